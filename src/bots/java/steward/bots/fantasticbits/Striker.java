package steward.bots.fantasticbits;

import java.io.IOException;
import java.util.List;

/**
 * The bot that aims. Its wizards go for different snaffles, where those will be; they throw so that their own speed
 * does not spoil the aim, past rivals who are in the way. It never casts a spell.
 */
public final class Striker extends FantasticBitsBot {

    /** Way that a snaffle rolls, per speed: 1 / friction. */
    static final double ROLL = 4;
    /** The part of the goal beside each post at which nothing is aimed, in u. */
    static final double POST_MARGIN = 500;
    /** A rival this near to the line of a throw stops it, in u. */
    static final double IN_THE_WAY = 600;
    /** Speed that a throw adds to a snaffle, in u per turn. */
    private static final double THROW_SPEED = 1000;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Striker().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        List<Entity> own = now.own();
        Entity[] goals = share(now, own, now.of("snaffle"));
        for (int k = 0; k < own.size(); k++) {
            if (own.get(k).snaffle >= 0) {
                toss(now, own.get(k), orders);
            } else {
                chase(now, own.get(k), goals[k], orders);
            }
        }
    }

    /** Heads for the place where a snaffle will be, or for the middle if there is none. */
    static void chase(Situation now, Entity wizard, Entity snaffle, Orders orders) {
        if (snaffle == null) {
            orders.go(now.width / 2, now.height / 2);
            return;
        }
        double turns = Math.min(4, wizard.distance(snaffle) / 500);
        orders.go(snaffle.x + snaffle.vx * turns - wizard.vx, snaffle.y + snaffle.vy * turns - wizard.vy);
    }

    /** A snaffle for each wizard, so that both together have the shortest ways. */
    static Entity[] share(Situation now, List<Entity> own, List<Entity> snaffles) {
        Entity[] best = new Entity[2];
        double least = Double.POSITIVE_INFINITY;
        for (Entity first : snaffles) {
            for (Entity second : snaffles) {
                if (first == second && snaffles.size() > 1) {
                    continue;
                }
                double cost = cost(now, own.get(0), first) + cost(now, own.get(1), second);
                if (cost < least) {
                    least = cost;
                    best[0] = first;
                    best[1] = second;
                }
            }
        }
        return best;
    }

    /** The way to where a snaffle will be; less for one near the own goal, more for one that a rival holds. */
    private static double cost(Situation now, Entity wizard, Entity snaffle) {
        double way = wizard.distance(snaffle.x + 2 * snaffle.vx - wizard.vx, snaffle.y + 2 * snaffle.vy - wizard.vy);
        double fromOwnGoal = Math.abs(snaffle.x - (now.width - now.goalX));
        boolean mine = now.own().stream().anyMatch(each -> each.snaffle == snaffle.id);
        return way + 0.1 * fromOwnGoal + (mine ? 3000 : 0);
    }

    /** Of several places in the goal the one that is free of rivals and nearest to the way that it flies anyway. */
    static void toss(Situation now, Entity wizard, Orders orders) {
        double bestY = now.goalY();
        double most = Double.NEGATIVE_INFINITY;
        double low = now.goalTop + POST_MARGIN;
        double high = now.goalBottom - POST_MARGIN;
        for (int k = 0; k <= 12; k++) {
            double y = low + k * (high - low) / 12;
            double value = clearance(now, wizard, now.goalX, y) - 0.1 * Math.abs(y - wizard.y);
            if (value > most) {
                most = value;
                bestY = y;
            }
        }
        double dx = now.goalX - wizard.x;
        double dy = bestY - wizard.y;
        double far = Math.max(1, Math.sqrt(dx * dx + dy * dy));
        double speed = THROW_SPEED + (wizard.vx * dx + wizard.vy * dy) / far;
        orders.toss(wizard.x + 10 * (dx / far * speed - wizard.vx), wizard.y + 10 * (dy / far * speed - wizard.vy));
    }

    /** Returns how far the nearest rival or bludger is from a line, as far as it matters. */
    static double clearance(Situation now, Entity from, double x, double y) {
        double dx = x - from.x;
        double dy = y - from.y;
        double far = Math.max(1, Math.sqrt(dx * dx + dy * dy));
        double least = IN_THE_WAY;
        for (Entity other : now.entities) {
            boolean blocks = other.kind.equals("wizard") ? other.player != now.player : other.kind.equals("bludger");
            double along = ((other.x - from.x) * dx + (other.y - from.y) * dy) / far;
            if (blocks && along > 0 && along < Math.min(far, ROLL * THROW_SPEED)) {
                double beside = Math.abs((other.x - from.x) * dy - (other.y - from.y) * dx) / far;
                least = Math.min(least, beside);
            }
        }
        return least;
    }
}
