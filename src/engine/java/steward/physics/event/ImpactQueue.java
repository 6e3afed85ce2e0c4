package steward.physics.event;

import java.util.Arrays;
import steward.physics.ImpactLaw;
import steward.physics.time.SimultaneousImpacts;

/** Queue of the predicted impacts of a scan, which selects those that happen next. */
abstract sealed class ImpactQueue permits ImpactQueue.OneAtATime, ImpactQueue.WithinWindow, RefiningQueue {

    /** Offers an impact at an absolute time within the turn; b is an index, or {@code ~wall}. */
    abstract void offer(double time, int a, int b);

    abstract void clear();

    /** Selects the impacts that happen next and puts them first. @return how many; 0 if none was offered */
    abstract int nextBatch();

    abstract double time(int k);

    abstract int a(int k);

    abstract int b(int k);

    static ImpactQueue of(ImpactLaw law) {
        return law.batchWindow() > 0 ? new WithinWindow(law.batchWindow()) : new OneAtATime();
    }

    /** Keeps the earliest impact; ties go to the lowest pair, bodies before walls. */
    static final class OneAtATime extends ImpactQueue {

        private double time;
        private int a;
        private int b;

        @Override
        void offer(double candidateTime, int candidateA, int candidateB) {
            if (candidateTime < time || candidateTime == time && isLower(candidateA, candidateB)) {
                time = candidateTime;
                a = candidateA;
                b = candidateB;
            }
        }

        private boolean isLower(int candidateA, int candidateB) {
            return SimultaneousImpacts.rank(candidateA, candidateB) < SimultaneousImpacts.rank(a, b);
        }

        @Override
        void clear() {
            time = Double.POSITIVE_INFINITY;
        }

        @Override
        int nextBatch() {
            return time < Double.POSITIVE_INFINITY ? 1 : 0;
        }

        @Override
        double time(int k) {
            return time;
        }

        @Override
        int a(int k) {
            return a;
        }

        @Override
        int b(int k) {
            return b;
        }
    }

    /**
     * Keeps all impacts in the order of time, ties in the order of the scan; those within the batch window happen
     * together.
     */
    static final class WithinWindow extends ImpactQueue {

        private final double window;
        private double[] times = new double[16];
        private int[] firsts = new int[16];
        private int[] seconds = new int[16];
        private int size;

        WithinWindow(double window) {
            this.window = window;
        }

        @Override
        void offer(double time, int a, int b) {
            if (size == times.length) {
                times = Arrays.copyOf(times, 2 * size);
                firsts = Arrays.copyOf(firsts, 2 * size);
                seconds = Arrays.copyOf(seconds, 2 * size);
            }
            int k = size++;
            while (k > 0 && times[k - 1] > time) {
                times[k] = times[k - 1];
                firsts[k] = firsts[k - 1];
                seconds[k] = seconds[k - 1];
                k--;
            }
            times[k] = time;
            firsts[k] = a;
            seconds[k] = b;
        }

        @Override
        void clear() {
            size = 0;
        }

        @Override
        int nextBatch() {
            int count = 0;
            while (count < size && times[count] - times[0] <= window) {
                count++;
            }
            return count;
        }

        @Override
        double time(int k) {
            return times[k];
        }

        @Override
        int a(int k) {
            return firsts[k];
        }

        @Override
        int b(int k) {
            return seconds[k];
        }
    }
}
