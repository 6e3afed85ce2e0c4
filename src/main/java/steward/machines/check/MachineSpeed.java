package steward.machines.check;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/**
 * Benchmark of one processor of this machine: rounds of a fixed computation per second of CPU time. Through CPU time a
 * busy machine is not taken for a slow one. The computation mixes what bots do: multiplications of doubles, integer
 * arithmetic, and reads from a table that fits into a cache. Two machines are compared by the ratio of their speeds.
 */
public final class MachineSpeed {

    /** A scaled limit is at least the league's divided by this, and at most the league's multiplied by it. */
    public static final double MOST_SCALE = 8;
    private static final int SAMPLES = 12;
    private static final int ROUNDS = 400_000;
    private static final double HUNDRED = 100;

    private MachineSpeed() { }

    /** Returns the speed: the best of some samples of a few milliseconds, as all that interferes only slows down. */
    public static int measure() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        boolean cpu = threads.isCurrentThreadCpuTimeSupported();
        long best = Long.MAX_VALUE;
        long used = 0;
        for (int sample = 0; sample < SAMPLES; sample++) {
            long began = cpu ? threads.getCurrentThreadCpuTime() : System.nanoTime();
            used += work(sample);
            best = Math.min(best, (cpu ? threads.getCurrentThreadCpuTime() : System.nanoTime()) - began);
        }
        long nanos = Math.max(1, best) + (used & 1);   // what was computed is used, or it would be left out
        return (int) Math.max(1, Math.min(Integer.MAX_VALUE, ROUNDS * 1e9 / nanos));
    }

    private static long work(int seed) {
        int[] table = new int[1 << 12];
        double sum = seed;
        int mixed = seed + 1;
        for (int round = 0; round < ROUNDS; round++) {
            mixed = mixed * 0x9E3779B1 + round;
            int place = mixed >>> 20;
            table[place] += round;
            sum = sum * 0.999 + table[place ^ 1] * 1e-9;
        }
        return Double.doubleToLongBits(sum) + mixed;
    }

    /**
     * Returns by what the time limits of a worker are multiplied, in steps of a hundredth.
     *
     * @param league speed of the league's machine
     * @param worker speed of the worker's machine; 0 if it is not known
     */
    public static double scale(int league, int worker) {
        double scale = worker == 0 ? 1 : Math.max(1 / MOST_SCALE, Math.min(MOST_SCALE, (double) league / worker));
        return Math.rint(scale * HUNDRED) / HUNDRED;
    }
}
