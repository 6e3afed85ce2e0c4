package steward.lab.capacity;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import steward.league.StoredGame;
import steward.machines.serve.ForwardedGames;
import steward.machines.serve.RemoteGames;

/** Games of workers, and the CPU time of the threads that wait for them and check them. */
final class MeteredGames extends ForwardedGames {

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final LongAdder nanos = new LongAdder();

    MeteredGames(RemoteGames games) {
        super(games);
    }

    /** CPU time of offers and checks so far, in nanoseconds. */
    long nanos() {
        return nanos.sum();
    }

    @Override
    public List<List<StoredGame>> play(List<Game> together) throws InterruptedException {
        long before = threads.getCurrentThreadCpuTime();
        try {
            return super.play(together);
        } finally {
            nanos.add(threads.getCurrentThreadCpuTime() - before);
        }
    }
}
