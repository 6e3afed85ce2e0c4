package steward.bots.meanmax;

import java.io.IOException;

/**
 * The plain bot: at full thrust the reaper heads for the nearest wreck, the destroyer for the nearest tanker, the doof
 * for the nearest reaper of another player. Without a wreck the reaper follows its destroyer. It never uses a skill.
 */
public final class Gatherer extends MeanMaxBot {

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Gatherer().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        Thing reaper = now.own("reaper");
        Thing destroyer = now.own("destroyer");
        Thing doof = now.own("doof");
        Thing wreck = Situation.nearest(reaper, now.wrecks);
        Thing tanker = Situation.nearest(destroyer, now.tankers());
        Thing rival = Situation.nearest(doof, now.rivals());
        orders.go(wreck == null ? destroyer.x : wreck.x, wreck == null ? destroyer.y : wreck.y);
        orders.go(tanker == null ? 0 : tanker.x, tanker == null ? 0 : tanker.y);
        orders.go(rival.x, rival.y);
    }
}
