package steward.game.bodies;

import java.util.List;
import steward.numerics.SineCosine;
import steward.numerics.SplitMix64;

/**
 * Discs of a scene that a rule lays out, in place of a list.
 *
 * @param shape     how they lie
 * @param count     how many, at least 1
 * @param place     {@code x, y, width, height} of a rectangle, {@code x, y, radius} of a circle, or the ends
 *                  {@code ax, ay, bx, by} of a line, as the shape says
 * @param radiusLow the least radius; each is drawn evenly
 * @param speedLow  the least speed, in u per turn; the direction is drawn
 * @param like      all else
 * @param seed      of what is drawn; {@code null} for the match's
 */
public record Fill(Shape shape, int count, double[] place, double radiusLow, double radiusHigh, double speedLow,
                   double speedHigh, Body like, Long seed) {

    /** Tries for a place without overlap: at 45% of the area covered one in some hundred succeeds. */
    private static final int TRIES = 10_000;

    /** How the discs of a fill lie. */
    public enum Shape {
        /** At random in a rectangle or a circle, without overlap. */
        RANDOM,
        /** In rows of a rectangle, from its corner with the lowest coordinates. */
        LATTICE,
        /** Evenly on a circle, from the right, towards positive y. */
        RING,
        /** Evenly from one end of a line to the other. */
        LINE
    }

    /**
     * Draws the discs.
     *
     * @param room what is there already; gets the discs
     * @param to   gets the discs, as many as there is room for
     * @return how many there was room for
     */
    int draw(SplitMix64 ofMatch, Room room, List<Body> to) {
        SplitMix64 random = seed == null ? ofMatch : new SplitMix64(seed);
        SineCosine angle = new SineCosine();
        double[] at = new double[2];
        for (int k = 0; k < count; k++) {
            double radius = between(random, radiusLow, radiusHigh);
            double speed = between(random, speedLow, speedHigh);
            angle.turn(speed == 0 ? 0 : 2 * Math.PI * random.nextDouble());
            double vx = speed * angle.cos();
            double vy = speed * angle.sin();
            int tries = shape != Shape.RANDOM ? 1 : fits(radius) ? TRIES : 0;
            do {
                if (tries-- == 0) {
                    return k;
                }
                place(k, radius, random, angle, at);
            } while (!room.has(at[0], at[1], radius));
            room.add(at[0], at[1], radius);
            to.add(like.at(at[0], at[1], vx, vy, radius));
        }
        return count;
    }

    /** True if a disc of this size has room in the place, were nothing else there. */
    private boolean fits(double radius) {
        return place.length == 3 ? radius <= place[2] : 2 * radius <= Math.min(place[2], place[3]);
    }

    private static double between(SplitMix64 random, double low, double high) {
        return low == high ? low : low + (high - low) * random.nextDouble();
    }

    private void place(int k, double radius, SplitMix64 random, SineCosine angle, double... at) {
        switch (shape) {
            case RANDOM -> anywhere(radius, random, at);
            case LATTICE -> {
                int columns = columns();
                int rows = (count + columns - 1) / columns;
                at[0] = place[0] + (k % columns + 0.5) * place[2] / columns;
                at[1] = place[1] + (k / columns + 0.5) * place[3] / rows;
            }
            case RING -> {
                angle.turn(2 * Math.PI * k / count);
                at[0] = place[0] + place[2] * angle.cos();
                at[1] = place[1] + place[2] * angle.sin();
            }
            case LINE -> {
                double share = count == 1 ? 0 : (double) k / (count - 1);
                at[0] = place[0] + share * (place[2] - place[0]);
                at[1] = place[1] + share * (place[3] - place[1]);
            }
        }
    }

    /** As many columns as make the lattice's cells nearest to squares. */
    private int columns() {
        return Math.max(1, Math.min(count, (int) Math.round(Math.sqrt(count * place[2] / place[3]))));
    }

    private void anywhere(double radius, SplitMix64 random, double... at) {
        boolean circle = place.length == 3;
        double reach = circle ? place[2] - radius : 0;
        do {
            double u = random.nextDouble();
            double v = random.nextDouble();
            at[0] = circle ? place[0] + reach * (2 * u - 1) : place[0] + radius + u * (place[2] - 2 * radius);
            at[1] = circle ? place[1] + reach * (2 * v - 1) : place[1] + radius + v * (place[3] - 2 * radius);
        } while (circle && squared(at[0] - place[0]) + squared(at[1] - place[1]) > reach * reach);
    }

    private static double squared(double value) {
        return value * value;
    }
}
