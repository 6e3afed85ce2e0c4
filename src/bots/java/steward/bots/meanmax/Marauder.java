package steward.bots.meanmax;

import java.io.IOException;
import java.util.List;

/**
 * The better bot. Its reaper goes to the wreck that gives the most water per turn and stops there; its destroyer hunts
 * tankers that have some water and are near its reaper, and throws grenades at rivals that harvest; its doof gets in
 * the way of the leading rival and pours oil on wrecks that only rivals harvest.
 */
public final class Marauder extends MeanMaxBot {

    /** About the speed at which a reaper travels, in u per turn. */
    private static final double REAPER_SPEED = 700;
    private static final double DESTROYER_SPEED = 450;
    /** Within this distance of a wreck its own reaper would be hit by a skill. */
    private static final double OWN_DISTANCE = 1500;
    private static final double SKILL_RANGE = 2000;
    private static final int GRENADE_COST = 60;
    private static final int OIL_COST = 30;
    private static final double EFFECT_RADIUS = 1000;
    /** How many turns ahead a moving target is aimed at. */
    private static final double LEAD_TURNS = 1.5;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Marauder().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        Thing prey = prey(now);
        orderReaper(now, prey, orders);
        orderDestroyer(now, prey, orders);
        orderDoof(now, orders);
    }

    /** The tanker that can be sunk soon, near the own reaper, and has water. */
    private static Thing prey(Situation now) {
        Thing reaper = now.own("reaper");
        Thing destroyer = now.own("destroyer");
        Thing best = null;
        double least = Double.POSITIVE_INFINITY;
        for (Thing tanker : now.tankers()) {
            if (tanker.distance(0, 0) > now.arenaRadius + tanker.radius / 2) {
                continue;
            }
            double turns = destroyer.distance(tanker) / DESTROYER_SPEED + 0.7 * reaper.distance(tanker) / REAPER_SPEED;
            double cost = turns - 1.2 * tanker.water;
            if (cost < least) {
                least = cost;
                best = tanker;
            }
        }
        return best;
    }

    private static void orderReaper(Situation now, Thing prey, Orders orders) {
        Thing reaper = now.own("reaper");
        Thing best = null;
        double most = 0;
        for (Thing wreck : now.wrecks) {
            double turns = Math.max(0, reaper.distance(wreck) - wreck.radius / 2) / REAPER_SPEED;
            double rivals = 0;
            for (Thing rival : now.rivals()) {
                rivals += rival.distance(wreck) < reaper.distance(wreck) + wreck.radius ? 1 : 0;
            }
            double water = wreck.water / (1 + 0.4 * rivals) - 0.5 * rivals * Math.min(turns, wreck.water);
            double rate = Math.max(0.1, water) / (turns + wreck.water / (1 + rivals) + 1);
            rate = isInOil(now, wreck) ? rate / 4 : rate;
            rate /= 1 + 0.35 * turns;
            if (rate > most) {
                most = rate;
                best = wreck;
            }
        }
        if (best != null) {
            stopAt(reaper, best.x, best.y, 0.9, orders);
        } else if (prey != null) {
            stopAt(reaper, prey.x + 2 * prey.vx, prey.y + 2 * prey.vy, 0.7, orders);
        } else {
            stopAt(reaper, 0, 0, 0.7, orders);
        }
    }

    /** Accelerates so that some share of the way is done in this turn. */
    private static void stopAt(Thing looter, double x, double y, double share, Orders orders) {
        orders.accelerate(looter, share * (x - looter.x) - looter.vx, share * (y - looter.y) - looter.vy);
    }

    private static boolean isInOil(Situation now, Thing wreck) {
        for (Thing effect : now.effects) {
            if (effect.skill.equals("oil") && effect.distance(wreck) < EFFECT_RADIUS + wreck.radius / 2) {
                return true;
            }
        }
        return false;
    }

    private static void orderDestroyer(Situation now, Thing prey, Orders orders) {
        Thing destroyer = now.own("destroyer");
        Thing target = now.rage() >= GRENADE_COST + OIL_COST ? harvested(now, destroyer, 2) : null;
        if (target != null) {
            orders.cast(target.x, target.y);
        } else if (prey != null) {
            orders.go(prey.x + LEAD_TURNS * (prey.vx - destroyer.vx), prey.y + LEAD_TURNS * (prey.vy - destroyer.vy));
        } else {
            Thing tanker = Situation.nearest(destroyer, now.tankers());
            orders.go(tanker == null ? 0 : tanker.x / 2, tanker == null ? 0 : tanker.y / 2);
        }
    }

    /** A wreck in range with enough water that rivals harvest and the own reaper does not, or {@code null}. */
    private static Thing harvested(Situation now, Thing caster, int water) {
        Thing reaper = now.own("reaper");
        Thing best = null;
        for (Thing wreck : now.wrecks) {
            boolean worth = wreck.water >= water && caster.distance(wreck) < SKILL_RANGE
                && reaper.distance(wreck) > OWN_DISTANCE + EFFECT_RADIUS / 2 && !isInOil(now, wreck);
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
        orders.go(rival.x + LEAD_TURNS * (rival.vx - doof.vx), rival.y + LEAD_TURNS * (rival.vy - doof.vy));
    }
}
