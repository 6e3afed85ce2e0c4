package steward.lab.timing;

import java.util.stream.IntStream;

/** Times turns in this JVM. */
public final class TurnTimer implements TimedPlace {

    private static final double NANOS = 1e9;
    /** Seconds of CPU of a stretch while warming up. */
    private static final double STRETCH = 0.02;
    /** The median of so many stretches is held against that of as many before them. */
    private static final int WINDOW = 5;
    /** Of all CPU time, what is not timed (drawing new games) may be so many times what is. */
    private static final int MOST_UNTIMED = 10;
    /** Times are steady when these medians differ by no more than this share. */
    private static final double STEADY = 0.02;

    private final WorkClock clock = new WorkClock();
    private final TimedTurns timed;

    public TurnTimer(TimedTurns timed) {
        this.timed = timed;
    }

    @Override
    public boolean warmUp(double least, double most) {
        double[] latest = new double[2 * WINDOW];
        double seconds = 0;
        boolean steady = false;
        for (int count = 0; seconds < least || !steady && seconds < most; count++) {
            Measured measured = run(Math.min(STRETCH, least));
            seconds += measured.all / NANOS;
            latest[count % latest.length] = measured.perTurn();
            int half = (count + 1) % latest.length;
            steady = count + 1 >= latest.length && half % WINDOW == 0
                && isSteady(window(latest, half), window(latest, half + WINDOW));
        }
        return steady;
    }

    private static double window(double[] latest, int from) {
        return IntStream.range(from, from + WINDOW).mapToDouble(k -> latest[k % latest.length]).sorted()
            .toArray()[WINDOW / 2];
    }

    private static boolean isSteady(double before, double after) {
        return Math.abs(after - before) <= STEADY * before;
    }

    @Override
    public Stretch round(double least) {
        Measured measured = run(least);
        return new Stretch(measured.perTurn(), clock.tellsBytes() ? measured.bytes / (double) measured.turns
            : Double.NaN);
    }

    /**
     * Some turns together.
     *
     * @param nanos of CPU in them
     * @param all   with what is not timed between them
     */
    private record Measured(long nanos, long all, long bytes, long turns) {

        double perTurn() {
            return nanos / (double) turns;
        }
    }

    private Measured run(double least) {
        long used = 0;
        long allocated = 0;
        long turns = 0;
        long begin = clock.nanos();
        long all;
        do {
            for (int k = 0; k < timed.cycle(); k++) {
                timed.prepare();
                long bytesBefore = clock.bytes();
                long before = clock.nanos();
                timed.run();
                used += clock.nanos() - before;
                allocated += clock.bytes() - bytesBefore;
                turns += timed.turns();
            }
            all = clock.nanos() - begin;
        } while (used < least * NANOS && all < MOST_UNTIMED * least * NANOS);
        return new Measured(used, all, allocated, turns);
    }
}
