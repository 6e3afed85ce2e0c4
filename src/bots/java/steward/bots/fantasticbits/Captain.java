package steward.bots.fantasticbits;

import java.io.IOException;
import java.util.List;

/**
 * The bot that casts spells. Its wizards go and throw as those of {@link Striker}, push snaffles that lie before the
 * goal into it, and hold up those that are about to roll into the own one.
 */
public final class Captain extends FantasticBitsBot {

    private static final int FLIPENDO_COST = 20;
    private static final int PETRIFICUS_COST = 10;
    /** From further away a push does not carry a snaffle into the goal, in u. */
    private static final double FLIPENDO_RANGE = 3500;
    private static final double FLIPENDO_CARRY = 6000;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Captain().run();
    }

    @Override
    void decide(Situation now, Orders orders) {
        List<Entity> own = now.own();
        List<Entity> snaffles = now.of("snaffle");
        Entity[] goals = Striker.share(now, own, snaffles);
        int magic = now.ownMagic();
        Entity saved = null;
        Entity pushed = null;
        for (int k = 0; k < own.size(); k++) {
            Entity wizard = own.get(k);
            if (wizard.snaffle >= 0) {
                Striker.toss(now, wizard, orders);
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
            } else {
                Striker.chase(now, wizard, goals[k], orders);
            }
        }
    }

    /** A snaffle that rolls into the own goal within a few turns and that no own wizard reaches, or {@code null}. */
    private static Entity danger(Situation now, List<Entity> own, List<Entity> snaffles, Entity saved) {
        double line = now.width - now.goalX;
        for (Entity snaffle : snaffles) {
            double way = line - snaffle.x;
            boolean toward = way * snaffle.vx > 0 && Math.abs(snaffle.vx) > 300;
            double y = toward ? snaffle.y + snaffle.vy * way / snaffle.vx : -1;
            boolean in = toward && Math.abs(way) < Striker.ROLL * Math.abs(snaffle.vx) && y > now.goalTop
                && y < now.goalBottom;
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
            boolean in = y > now.goalTop + Striker.POST_MARGIN && y < now.goalBottom - Striker.POST_MARGIN;
            if (in && distance < nearest && Striker.clearance(now, snaffle, now.goalX, y) > Striker.IN_THE_WAY - 50) {
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
