package steward.bots.fantasticbits;

import java.io.IOException;

/**
 * The plain bot: each wizard heads for the snaffle that is nearest to it and throws what it holds at the middle of the
 * goal. It never casts a spell.
 */
public final class Chaser extends FantasticBitsBot {

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Chaser().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        for (Entity wizard : now.own()) {
            if (wizard.snaffle >= 0) {
                orders.toss(now.goalX, now.goalY());
                continue;
            }
            Entity nearest = null;
            for (Entity snaffle : now.of("snaffle")) {
                if (nearest == null || snaffle.distance(wizard) < nearest.distance(wizard)) {
                    nearest = snaffle;
                }
            }
            orders.go(nearest == null ? wizard.x : nearest.x, nearest == null ? wizard.y : nearest.y);
        }
    }
}
