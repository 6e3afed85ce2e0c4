package steward.bots.fantasticbits;

import java.io.IOException;
import java.util.List;

/**
 * The better bot. Its wizards go for different snaffles, where those will be; they throw so that their own speed does
 * not spoil the aim, past rivals who are in the way; they push snaffles that lie before the goal into it, and hold up
 * those that are about to roll into the own one.
 */
public final class Captain extends FantasticBitsBot {

    private static final int FLIPENDO_COST = 20;
    private static final int PETRIFICUS_COST = 10;
    /** Speed that a throw adds to a snaffle, in u per turn. */
    private static final double THROW_SPEED = 1000;
    /** How far a snaffle rolls per speed: 1 / friction. */
    private static final double ROLL = 4;
    /** From further away a push does not carry a snaffle into the goal, in u. */
    private static final double FLIPENDO_RANGE = 3500;
    private static final double FLIPENDO_CARRY = 6000;
    private static final double POST_MARGIN = 500;
    /** A rival this near to the line of a throw stops it, in u. */
    private static final double IN_THE_WAY = 600;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Captain().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        List<Entity> own = now.own();
        List<Entity> snaffles = now.of("snaffle");
        Entity[] goals = share(now, own, snaffles);
        int magic = now.ownMagic();
        Entity saved = null;
        Entity pushed = null;
        for (int k = 0; k < own.size(); k++) {
            Entity wizard = own.get(k);
            if (wizard.snaffle >= 0) {
                toss(now, wizard, orders);
                continue;
            }
            Entity danger = magic >= PETRIFICUS_COST ? danger(now, own, snaffles, saved) : null;
            Entity push = magic >= FLIPENDO_COST ? push(now, wizard, own, snaffles, pushed) : null;
            if (danger != null) {
                orders.cast("petrificus", danger);
                saved = danger;
                magic -= PETRIFICUS_COST;
            } else if (push != null) {
                orders.cast("flipendo", push);
                pushed = push;
                magic -= FLIPENDO_COST;
            } else if (goals[k] != null) {
                double turns = Math.min(4, wizard.distance(goals[k]) / 500);
                orders.go(goals[k].x + goals[k].vx * turns - wizard.vx, goals[k].y + goals[k].vy * turns - wizard.vy);
            } else {
                orders.go(now.width / 2, now.height / 2);
            }
        }
    }

    /** A snaffle for each wizard, so that both together have the shortest ways. */
    private static Entity[] share(Situation now, List<Entity> own, List<Entity> snaffles) {
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
    private static void toss(Situation now, Entity wizard, Orders orders) {
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
    private static double clearance(Situation now, Entity from, double x, double y) {
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

    /** A snaffle that rolls into the own goal within a few turns and that no own wizard reaches, or {@code null}. */
    private static Entity danger(Situation now, List<Entity> own, List<Entity> snaffles, Entity saved) {
        double line = now.width - now.goalX;
        for (Entity snaffle : snaffles) {
            double way = line - snaffle.x;
            boolean toward = way * snaffle.vx > 0 && Math.abs(snaffle.vx) > 300;
            double y = toward ? snaffle.y + snaffle.vy * way / snaffle.vx : -1;
            boolean in = toward && Math.abs(way) < ROLL * Math.abs(snaffle.vx) && y > now.goalTop && y < now.goalBottom;
            // The spell begins with the next turn: until then the snaffle rolls on.
            boolean inTime = Math.abs(way) > 1.0 * Math.abs(snaffle.vx) && Math.abs(way) < 3 * Math.abs(snaffle.vx);
            if (in && inTime && snaffle != saved && !snaffle.held && !isTarget(own, snaffle)) {
                return snaffle;
            }
        }
        return null;
    }

    /** A snaffle that a push from here drives into the goal, or {@code null}. */
    private static Entity push(Situation now, Entity wizard, List<Entity> own, List<Entity> snaffles, Entity pushed) {
        Entity best = null;
        double nearest = Double.POSITIVE_INFINITY;
        for (Entity snaffle : snaffles) {
            double sx = snaffle.x + snaffle.vx;
            double sy = snaffle.y + snaffle.vy;
            double dx = sx - wizard.x - wizard.vx;
            double dy = sy - wizard.y - wizard.vy;
            double distance = Math.sqrt(dx * dx + dy * dy);
            double way = now.goalX - sx;
            boolean held = own.stream().anyMatch(each -> each.snaffle == snaffle.id);
            if (held || snaffle == pushed || isTarget(own, snaffle) || distance < 1000 || distance > FLIPENDO_RANGE
                || dx * way <= 0 || Math.abs(way) > FLIPENDO_CARRY) {
                continue;
            }
            double y = sy + dy * way / dx;
            boolean in = y > now.goalTop + POST_MARGIN && y < now.goalBottom - POST_MARGIN;
            if (in && distance < nearest && clearance(now, snaffle, now.goalX, y) > IN_THE_WAY - 50) {
                best = snaffle;
                nearest = distance;
            }
        }
        return best;
    }

    private static boolean isTarget(List<Entity> own, Entity snaffle) {
        return own.stream().anyMatch(wizard -> wizard.spellTarget == snaffle.id);
    }
}
