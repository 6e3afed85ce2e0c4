package steward.game.podrace;

/** Start positions of pods, computed from the first two checkpoints. */
public final class StartPlaces {

    /** Distance of the inner start places from checkpoint 0, in u, and of each further pair from the last. */
    private static final double START_OFFSET = 500;
    static final double START_SPACING = 1000;

    private StartPlaces() { }

    /**
     * Side by side across checkpoint 0, facing checkpoint 1, {@code [n][x, y]}: offsets -500, +500, -1500, +1500, ...
     * of an even number of pods; 0, +1000, -1000, ... of an odd one, as in the published referee.
     */
    public static double[][] of(double[][] checkpoints, int pods) {
        double dx = checkpoints[1][0] - checkpoints[0][0];
        double dy = checkpoints[1][1] - checkpoints[0][1];
        double length = Math.sqrt(dx * dx + dy * dy);
        double[][] places = new double[pods][];
        for (int pod = 0; pod < pods; pod++) {
            double side = side(pod, pods);
            places[pod] = new double[] {Math.floor(checkpoints[0][0] - side * dy / length + 0.5),
                Math.floor(checkpoints[0][1] + side * dx / length + 0.5)};
        }
        return places;
    }

    /** The offset of one pod of so many, in u; negative to one side of checkpoint 0. */
    static double side(int pod, int pods) {
        double offset = START_OFFSET + START_SPACING * (pod / 2);
        return (pod % 2 == 0 ? -offset : offset) + (pods % 2) * START_OFFSET;
    }

    /**
     * Returns how far jitter can move a start place, in u, before rounding. It moves checkpoint 0 by at most j = jitter
     * * sqrt(2), and the vector d to checkpoint 1 by at most 2j. If 2j is less than its length, d turns by at most a
     * with sin a = 2j / |d|, and a place at the side s moves along a chord of at most 2 |s| sin(a / 2) = |s| sqrt(2 - 2
     * cos a).
     *
     * @param length between the checkpoints without jitter
     */
    static double slack(double side, int jitter, double length) {
        double move = jitter * Math.sqrt(2);
        double sine = 2 * move / length;
        double turn = sine < 1 ? Math.sqrt(2 - 2 * Math.sqrt(1 - sine * sine)) : 2;
        return move + (jitter == 0 ? 0 : Math.abs(side) * turn);
    }
}
