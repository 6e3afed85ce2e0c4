package steward.lab.statistics;

import java.util.Arrays;
import steward.contest.WorkerThreads;

/** Plays many made-up leagues on threads and adds up what was counted: whole numbers, in any order the same. */
final class Counted {

    private static final int CHUNK = 50;

    /** Plays one league. */
    interface League {
        /** @param counts to be added to */
        void play(long number, long... counts);
    }

    /** Makes what plays leagues on one thread. */
    interface Player {
        League onThread();
    }

    /**
     * Plays them.
     *
     * @param numbers how many things are counted
     * @return the counts
     */
    static long[] play(int threads, long leagues, int numbers, Player player) throws InterruptedException {
        long[] all = new long[numbers];
        WorkerThreads.run("self-check", threads, first -> () -> {
            League league = player.onThread();
            long[] counts = new long[numbers];
            for (long chunk = (long) first * CHUNK; chunk < leagues; chunk += (long) threads * CHUNK) {
                for (long number = chunk; number < Math.min(leagues, chunk + CHUNK); number++) {
                    league.play(number, counts);
                }
            }
            synchronized (all) {
                Arrays.setAll(all, k -> all[k] + counts[k]);
            }
            return null;
        });
        return all;
    }
}
