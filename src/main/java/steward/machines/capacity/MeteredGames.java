package steward.machines.capacity;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;
import steward.league.StoredGame;
import steward.league.play.Elsewhere;
import steward.league.play.Roster.Member;
import steward.machines.serve.RemoteGames;

/** Games of workers, and the CPU time of the threads that wait for them and check them. */
final class MeteredGames implements Elsewhere {

    private final RemoteGames games;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final LongAdder nanos = new LongAdder();

    MeteredGames(RemoteGames games) {
        this.games = games;
    }

    /** CPU time of offers and checks so far, in nanoseconds. */
    long nanos() {
        return nanos.sum();
    }

    @Override
    public int takePlace(long waitMs) throws InterruptedException {
        return games.takePlace(waitMs);
    }

    @Override
    public void leavePlace() {
        games.leavePlace();
    }

    @Override
    public List<List<StoredGame>> play(List<Game> together) throws InterruptedException {
        long before = threads.getCurrentThreadCpuTime();
        try {
            return games.play(together);
        } finally {
            nanos.add(threads.getCurrentThreadCpuTime() - before);
        }
    }

    @Override
    public boolean canPlay(List<Member> members) {
        return games.canPlay(members);
    }

    @Override
    public boolean isTrusted(String machine) {
        return games.isTrusted(machine);
    }
}
