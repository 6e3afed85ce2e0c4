package steward.bots.meanmax;

import java.io.IOException;
import java.util.List;

/**
 * The bot that spoils what rivals do. Its looters harvest and hunt as those of {@link Harvester}; its destroyer throws
 * grenades at rivals that harvest; its doof gets in the way of the leading rival and pours oil on wrecks that only
 * rivals harvest.
 */
public final class Marauder extends MeanMaxBot {

    /** Within this distance of a wreck its own reaper would be hit by a skill. */
    private static final double OWN_DISTANCE = 1500;
    private static final double SKILL_RANGE = 2000;
    private static final int GRENADE_COST = 60;
    private static final int OIL_COST = 30;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Marauder().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        Thing prey = Harvester.prey(now);
        Harvester.orderReaper(now, prey, orders);
        orderDestroyer(now, prey, orders);
        orderDoof(now, orders);
    }

    private static void orderDestroyer(Situation now, Thing prey, Orders orders) {
        Thing destroyer = now.own("destroyer");
        Thing target = now.rage() >= GRENADE_COST + OIL_COST ? harvested(now, destroyer, 2) : null;
        if (target != null) {
            orders.cast(target.x, target.y);
        } else {
            Harvester.hunt(now, prey, orders);
        }
    }

    /** A wreck in range with enough water that rivals harvest and the own reaper does not, or {@code null}. */
    private static Thing harvested(Situation now, Thing caster, int water) {
        Thing reaper = now.own("reaper");
        Thing best = null;
        for (Thing wreck : now.wrecks) {
            boolean worth = wreck.water >= water && caster.distance(wreck) < SKILL_RANGE
                && reaper.distance(wreck) > OWN_DISTANCE + Harvester.EFFECT_RADIUS / 2
                && !Harvester.isInOil(now, wreck);
            if (worth && rivalsAt(now.rivals(), wreck) > 0 && (best == null || wreck.water > best.water)) {
                best = wreck;
            }
        }
        return best;
    }

    private static int rivalsAt(List<Thing> rivals, Thing wreck) {
        int count = 0;
        for (Thing rival : rivals) {
            count += rival.distance(wreck) < wreck.radius ? 1 : 0;
        }
        return count;
    }

    private static void orderDoof(Situation now, Orders orders) {
        Thing doof = now.own("doof");
        Thing target = now.rage() >= OIL_COST ? harvested(now, doof, 3) : null;
        if (target != null) {
            orders.cast(target.x, target.y);
            return;
        }
        int leader = -1;
        for (int player = 0; player < now.scores.size(); player++) {
            if (player != now.player && (leader < 0 || now.scores.get(player) > now.scores.get(leader))) {
                leader = player;
            }
        }
        Thing rival = now.of(leader, "reaper");
        orders.go(rival.x + Harvester.LEAD_TURNS * (rival.vx - doof.vx),
            rival.y + Harvester.LEAD_TURNS * (rival.vy - doof.vy));
    }
}
