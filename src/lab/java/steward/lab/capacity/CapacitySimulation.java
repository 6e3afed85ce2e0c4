package steward.lab.capacity;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.PriorityQueue;
import java.util.SplittableRandom;

/**
 * A league's process and its workers in virtual time, event by event. Games take times of an exponential distribution,
 * everything in the process as long as it was measured to take. A step waits for its thread, if there is only one for
 * it, and then for a processor; processors are given in the order of asking. Equal arguments give equal results.
 *
 * <p>A place is a game under way: the schedule decides on it, the broker hands it out, a worker that is free plays it,
 * the broker takes the result, it is read, checked and handed over to be stored. Then the place is free for the next.
 */
public final class CapacitySimulation {

    private static final double NANOS_PER_US = 1e3;
    /** Games before counting begins, for each that can be under way or wait to be stored. */
    private static final int WARM = 10;
    /** Games that may wait to be stored or be stored just now, as {@link steward.league.store.GameWriter} has it. */
    private static final int MOST_WAITING = 4096;

    private final LeagueCosts costs;
    private final Setting setting;
    private final SplittableRandom random;
    private final PriorityQueue<Event> events = new PriorityQueue<>();
    private final Deque<Runnable> processors = new ArrayDeque<>();
    private final Deque<Runnable> jobs = new ArrayDeque<>();
    private final Deque<Runnable> blocked = new ArrayDeque<>();
    private final Line messages = new Line();
    private final Line schedule = new Line();
    private final Line store = new Line();
    private long now;
    private long order;
    private int idleProcessors;
    private int idleWorkers;
    private int roomToWait = MOST_WAITING;

    private long stored;
    private long began;
    private double busyNanos;
    private double delayNanos;
    private long delays;
    private double insideNanos;
    private int inside;
    private long insideSince;
    private double playingNanos;

    /**
     * Setting of a simulation: the league's machine and its workers.
     *
     * @param processors of the league's machine
     * @param workers    games that they play at the same time, all together
     * @param gameNanos  how long a game takes on average, in nanoseconds, the way to the worker and back included
     * @param places     games that may be under way at most
     */
    public record Setting(int processors, int workers, double gameNanos, int places) {
    }

    /**
     * Result of a simulation.
     *
     * @param perSecond  games in a second that the busiest part of the process has worked on, half ones as halves
     * @param stored     games stored in a second, which depends on where in their course games are at begin and end
     * @param processors share of the processors' time that was needed, 0..1
     * @param messages   the same of the thread that reads messages
     * @param schedule   the same of the schedule
     * @param store      the same of the thread that stores
     * @param workers    share of the workers' time in which they played
     * @param delayMs    from a result's arrival until the game is handed over to be stored, on average
     * @param inside     results in the process that are not handed over yet, on average
     */
    public record Load(double perSecond, double stored, double processors, double messages, double schedule,
                       double store, double workers, double delayMs, double inside) {
    }

    private record Event(long time, long order, Runnable what) implements Comparable<Event> {
        @Override
        public int compareTo(Event other) {
            return time != other.time ? Long.compare(time, other.time) : Long.compare(order, other.order);
        }
    }

    private record Step(long nanos, Runnable then) {
    }

    /** Server that takes one step at a time; the others wait in line. */
    private static final class Line {
        private final Deque<Step> waiting = new ArrayDeque<>();
        private boolean busy;
        private double nanos;
    }

    private CapacitySimulation(LeagueCosts costs, Setting setting, long seed) {
        this.costs = costs;
        this.setting = setting;
        random = new SplittableRandom(seed);
        idleProcessors = setting.processors();
        idleWorkers = setting.workers();
    }

    /**
     * Simulates.
     *
     * @param games after which it ends; before, a quarter as many are played that do not count, or more where many
     *              can be under way: queues that still grow would pass for games
     */
    public static Load of(LeagueCosts costs, Setting setting, int games, long seed) {
        return new CapacitySimulation(costs, setting, seed).run(games);
    }

    private Load run(int games) {
        int places = Math.min(setting.places(), setting.workers() + (setting.workers() + 3) / 4);
        for (int place = 0; place < places; place++) {
            decide();
        }
        runUntil(Math.max(games / 4, WARM * (places + MOST_WAITING)));
        began = now;
        stored = 0;
        busyNanos = 0;
        delayNanos = 0;
        delays = 0;
        insideNanos = 0;
        insideSince = now;
        playingNanos = 0;
        messages.nanos = 0;
        schedule.nanos = 0;
        store.nanos = 0;
        runUntil(games);
        count(0);
        double time = now - began;
        return new Load(busiest(time) * 1e9 / time, stored * 1e9 / time, busyNanos / time / setting.processors(),
            messages.nanos / time, schedule.nanos / time, store.nanos / time, playingNanos / time / setting.workers(),
            delays == 0 ? 0 : delayNanos / delays / 1e6, insideNanos / time);
    }

    /** Returns how many games the part has worked on that had the least time left: that many can end, and no more. */
    private double busiest(double time) {
        double share = busyNanos / time / setting.processors();
        double games = busyNanos / (costs.total() * NANOS_PER_US);
        double[] nanos = {messages.nanos, schedule.nanos, store.nanos};
        double[] micros = {costs.messages(), costs.schedule(), costs.store()};
        for (int line = 0; line < nanos.length; line++) {
            if (nanos[line] / time > share) {
                share = nanos[line] / time;
                games = nanos[line] / (micros[line] * NANOS_PER_US);
            }
        }
        return games;
    }

    private void runUntil(long games) {
        while (stored < games) {
            Event next = events.remove();
            now = next.time();
            next.what().run();
        }
    }

    private void at(long nanos, Runnable what) {
        events.add(new Event(now + nanos, order++, what));
    }

    // ---- threads and processors ------------------------------------------------------------------

    /** A step that any thread does. */
    private void step(double micros, Runnable then) {
        Step step = new Step(Math.round(micros * NANOS_PER_US), then);
        processor(() -> work(step));
    }

    /** A step of a thread that there is once, or under a lock. */
    private void step(Line line, double micros, Runnable then) {
        line.waiting.add(new Step(Math.round(micros * NANOS_PER_US), then));
        if (!line.busy) {
            line.busy = true;
            processor(() -> next(line));
        }
    }

    /** Once it has a processor, a thread keeps it while anything waits for the thread. */
    private void next(Line line) {
        Step step = line.waiting.remove();
        line.nanos += step.nanos();
        busyNanos += step.nanos();
        at(step.nanos(), () -> {
            step.then().run();
            if (line.waiting.isEmpty()) {
                line.busy = false;
                release();
            } else {
                next(line);
            }
        });
    }

    private void processor(Runnable work) {
        if (idleProcessors == 0) {
            processors.add(work);
            return;
        }
        idleProcessors--;
        work.run();
    }

    private void release() {
        Runnable waiting = processors.poll();
        if (waiting == null) {
            idleProcessors++;
        } else {
            waiting.run();
        }
    }

    private void work(Step step) {
        busyNanos += step.nanos();
        at(step.nanos(), () -> {
            release();
            step.then().run();
        });
    }

    // ---- a game ----------------------------------------------------------------------------------

    private void decide() {
        step(schedule, costs.schedule(), () -> step(costs.broker() / 2, () -> offer(this::reported)));
    }

    private void offer(Runnable then) {
        if (idleWorkers == 0) {
            jobs.add(then);
        } else {
            idleWorkers--;
            play(then);
        }
    }

    private void play(Runnable then) {
        long nanos = Math.round(-Math.log(1 - random.nextDouble()) * setting.gameNanos());
        at(nanos, () -> {
            playingNanos += nanos;
            Runnable next = jobs.poll();
            if (next == null) {
                idleWorkers++;
            } else {
                play(next);
            }
            then.run();
        });
    }

    private void reported() {
        long arrived = now;
        count(1);
        step(costs.broker() / 2, () -> step(messages, costs.messages(), () -> step(costs.check()
            + (random.nextDouble() < costs.share() ? costs.again() : 0), () -> {
                count(-1);
                delayNanos += now - arrived;
                delays++;
                handOver();
            })));
    }

    private void count(int change) {
        insideNanos += (double) inside * (now - insideSince);
        insideSince = now;
        inside += change;
    }

    /** Waits only if very many games wait to be stored. */
    private void handOver() {
        if (roomToWait == 0) {
            blocked.add(this::handOver);
            return;
        }
        roomToWait--;
        step(store, costs.store(), () -> {
            stored++;
            roomToWait++;
            Runnable waiting = blocked.poll();
            if (waiting != null) {
                waiting.run();
            }
        });
        decide();
    }
}
