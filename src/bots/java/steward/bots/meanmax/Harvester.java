package steward.bots.meanmax;

import java.io.IOException;

/**
 * The bot that brakes. Its reaper goes to the wreck that gives the most water per turn and stops there; its destroyer
 * hunts tankers that have some water and are near its reaper; its doof heads for the nearest reaper of another player.
 * It never uses a skill.
 */
public final class Harvester extends MeanMaxBot {

    static final double EFFECT_RADIUS = 1000;
    /** Turns ahead at which a moving target is aimed at. */
    static final double LEAD_TURNS = 1.5;
    /** About the speed at which a reaper travels, in u per turn. */
    private static final double REAPER_SPEED = 700;
    private static final double DESTROYER_SPEED = 450;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Harvester().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        Thing prey = prey(now);
        orderReaper(now, prey, orders);
        hunt(now, prey, orders);
        Thing rival = Situation.nearest(now.own("doof"), now.rivals());
        orders.go(rival.x, rival.y);
    }

    /** The tanker that can be sunk soon, near the own reaper, and has water. */
    static Thing prey(Situation now) {
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

    /** Stops in the wreck that pays most, or where one will be. */
    static void orderReaper(Situation now, Thing prey, Orders orders) {
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

    /** True if oil lies on a wreck. */
    static boolean isInOil(Situation now, Thing wreck) {
        for (Thing effect : now.effects) {
            if (effect.skill.equals("oil") && effect.distance(wreck) < EFFECT_RADIUS + wreck.radius / 2) {
                return true;
            }
        }
        return false;
    }

    /** Heads for the prey; without one the destroyer waits half way to the nearest tanker. */
    static void hunt(Situation now, Thing prey, Orders orders) {
        Thing destroyer = now.own("destroyer");
        if (prey != null) {
            orders.go(prey.x + LEAD_TURNS * (prey.vx - destroyer.vx), prey.y + LEAD_TURNS * (prey.vy - destroyer.vy));
        } else {
            Thing tanker = Situation.nearest(destroyer, now.tankers());
            orders.go(tanker == null ? 0 : tanker.x / 2, tanker == null ? 0 : tanker.y / 2);
        }
    }
}
