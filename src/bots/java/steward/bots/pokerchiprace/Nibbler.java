package steward.bots.pokerchiprace;

import java.io.IOException;

/** The plain bot: each chip heads for the nearest smaller one, and drifts once it is on its way. */
public final class Nibbler extends ChipBot {

    /** A chip that comes nearer by this much a turn is on its way, in u. */
    private static final double FAST = 6;

    /** Plays one match over the standard streams. */
    public static void main(String[] arguments) throws IOException {
        new Nibbler().run();
    }

    @Override
    double[] decide(Chip chip) {
        Chip prey = null;
        for (Chip other : chips) {
            if (other.radius < chip.radius && (prey == null || chip.distance(other) < chip.distance(prey))) {
                prey = other;
            }
        }
        if (prey == null) {
            return null;
        }
        double dx = prey.x - chip.x;
        double dy = prey.y - chip.y;
        double approach = (dx * (chip.vx - prey.vx) + dy * (chip.vy - prey.vy)) / chip.distance(prey);
        return approach >= FAST ? null : new double[] {dx, dy};
    }
}
