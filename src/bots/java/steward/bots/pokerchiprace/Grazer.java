package steward.bots.pokerchiprace;

import java.io.IOException;

/**
 * The bot that looks at its first meal. For each chip it looks at waiting and at a push in each of 24 directions, flies
 * all chips straight on, and takes the way whose first contact gives most area, and soonest. It sees neither walls nor
 * what comes after that contact.
 */
public final class Grazer extends ChipBot {

    private static final int DIRECTIONS = 24;
    /** Contacts later than this are not looked at, in turns. */
    private static final double HORIZON = 30;
    /** Discount of a meal: its worth is multiplied by this with each turn. */
    private static final double PATIENCE = 0.96;
    /** Speed that a push gives to a chip, in u per turn, and the share of its area that it costs. */
    private static final double PUSH = 200.0 / 14;
    private static final double COST = 1.0 / 15;
    /** The directions are a length apart from the chip at which it pushes itself, in u. */
    private static final double FAR = 100;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Grazer().run();
    }

    @Override
    double[] decide(Chip chip) {
        double best = worth(chip, chip.vx, chip.vy);
        double[] way = null;
        for (int k = 0; k < DIRECTIONS; k++) {
            double x = StrictMath.cos(2 * Math.PI * k / DIRECTIONS);
            double y = StrictMath.sin(2 * Math.PI * k / DIRECTIONS);
            double worth = worth(chip, chip.vx + PUSH * x, chip.vy + PUSH * y) - COST * chip.radius * chip.radius;
            if (worth > best) {
                best = worth;
                way = new double[] {FAR * x, FAR * y};
            }
        }
        return way;
    }

    /** The area that the first contact gives, or takes, at this velocity; without the factor pi. */
    private double worth(Chip chip, double vx, double vy) {
        double soonest = HORIZON;
        Chip met = null;
        for (Chip other : chips) {
            double time = other.player == chip.player ? HORIZON : timeToTouch(chip, other, vx, vy);
            if (time < soonest) {
                soonest = time;
                met = other;
            }
        }
        if (met == null) {
            return 0;
        }
        Chip eaten = met.radius < chip.radius ? met : chip;
        return (eaten == met ? 1 : -1) * eaten.radius * eaten.radius * StrictMath.pow(PATIENCE, soonest);
    }

    /** Turns until two chips touch that fly straight on, or infinity. */
    private static double timeToTouch(Chip chip, Chip other, double vx, double vy) {
        double dx = other.x - chip.x;
        double dy = other.y - chip.y;
        double ux = other.vx - vx;
        double uy = other.vy - vy;
        double reach = chip.radius + other.radius;
        double a = ux * ux + uy * uy;
        double b = dx * ux + dy * uy;
        double d = b * b - a * (dx * dx + dy * dy - reach * reach);
        return b >= 0 || d < 0 ? Double.POSITIVE_INFINITY : Math.max(0, (-b - Math.sqrt(d)) / a);
    }
}
