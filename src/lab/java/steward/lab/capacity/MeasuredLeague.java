package steward.lab.capacity;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.bot.command.Platform;
import steward.bot.isolation.Isolation;
import steward.contest.BotStarter;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.files.InputException;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.LeagueRun;
import steward.league.play.RosterReader;
import steward.league.store.GameStore;
import steward.machines.serve.RemoteGames;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerToken;
import steward.machines.worker.Worker;

/**
 * A league between bots inside this JVM that is played for a while, by itself or by a worker that joins it as all
 * workers do, by TLS with a token, and whose games are checked and stored as all are. Measured is the CPU time of each
 * kind of thread.
 */
public final class MeasuredLeague {

    /** In how many of the games the bots are asked again, as usual. */
    static final double SHARE = 0.05;
    /** Tenths of a second for which a first game is waited for. */
    private static final int PATIENCE_TENTHS = 600;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_US = 1e3;
    private static final int BOTS = 4;
    private static final String HOST = "127.0.0.1";
    private static final String COMMON_POOL = "ForkJoinPool.commonPool";
    private static final String WORKER = "measured";

    private final MeasuredBots bots;
    private final Path folder;
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    /** Threads that were there before, but for the JVM's common pool: other leagues of the process may be closing. */
    private Set<Long> strangers = Set.of();
    private final OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    /** Kinds of threads. */
    public enum Kind {
        /** The broker's, and those of the league's own connection to it. */
        BROKER,
        /** The one that reads what workers say. */
        MESSAGES,
        /** Threads that play games, or offer games to workers, wait for them and check them. */
        GAMES,
        /** Such threads, where workers play, in work that a league does without them, too: schedule, pairing. */
        SCHEDULE,
        /** The one that stores. */
        STORE,
        /** The worker's connection. */
        WORKER_BROKER,
        /** The worker's games. */
        WORKER_GAMES,
        /** Others. */
        OTHER;

        static Kind of(String thread) {
            if (thread.contains("activemq-client-factory") || thread.contains("activemq-client-remoting")) {
                return WORKER_BROKER;
            }
            return thread.contains("activemq") || thread.startsWith(COMMON_POOL) ? BROKER
                : switch (thread) {
                    case "what workers say" -> MESSAGES;
                    case "league" -> GAMES;
                    case "league writer" -> STORE;
                    case "worker" -> WORKER_GAMES;
                    default -> OTHER;
                };
        }
    }

    /**
     * Result of a measurement.
     *
     * @param perSecond games stored in a second
     * @param process   CPU time of the whole process, in microseconds a game, what compiles and collects included
     * @param perJob    games that a worker is given together, on average
     * @param kinds     the same of each kind of thread
     */
    public record Sample(double perSecond, double process, double perJob, Map<Kind, Double> kinds) {

        /** Returns the CPU time of all threads together. */
        public double threads() {
            return kinds.values().stream().mapToDouble(Double::doubleValue).sum();
        }
    }

    /**
     * Length of a measurement.
     *
     * @param perSecond   games that begin in a second at most
     * @param warmSeconds before
     * @param seconds     while it is measured
     * @param slots       games at the same time
     */
    public record Effort(double perSecond, double warmSeconds, double seconds, int slots) { }

    private record Reading(long nanos, long process, long games, Map<Kind, Long> kinds) { }

    /** @param folder where leagues are made */
    public MeasuredLeague(MeasuredBots bots, Path folder) {
        this.bots = bots;
        this.folder = folder;
    }

    /**
     * Measures.
     *
     * @param served whether a worker plays, and the league none of the games
     * @throws InputException if a folder or the broker cannot be made
     * @throws IllegalStateException if no games are played
     */
    public Sample measure(boolean served, Effort effort) throws InterruptedException, IOException {
        strangers = Arrays.stream(threads.getThreadInfo(threads.getAllThreadIds())).filter(Objects::nonNull)
            .filter(info -> !info.getThreadName().startsWith(COMMON_POOL)).map(ThreadInfo::getThreadId)
            .collect(Collectors.toSet());
        LeagueFolder league = new LeagueFolder(Files.createTempDirectory(folder, "league"));
        LeagueSettings settings = LeagueSettings.usual(bots.setup().scene().name(), 1).with(null,
            Double.POSITIVE_INFINITY, KeptReplays.FAILED).withBots(IntStream.rangeClosed(1, BOTS).mapToObj(k ->
                new LeagueBot("bot-" + k, bots.command(k), null, false, false)).toList());
        league.write(settings);
        List<String> told = Collections.synchronizedList(new ArrayList<>());
        Pacer pacer = new Pacer(effort.perSecond() * bots.setup().scene().players());
        BotStarter paced = (entrant, isolation, others) -> {
            pacer.await();
            return bots.playing().player(entrant, isolation, others);
        };
        Contest contest = bots.contest().startedBy(served ? bots.asked() : paced);
        return served ? served(league, settings, contest, paced, effort, told)
            : play(league, settings, contest, null, effort, told);
    }

    private Sample served(LeagueFolder league, LeagueSettings settings, Contest contest, BotStarter paced,
                          Effort effort, List<String> told) throws InterruptedException, IOException {
        Path token = league.path().resolve("worker.token");
        WorkerList.add(league, WORKER, token);
        InetSocketAddress address;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getByName(HOST))) {
            address = new InetSocketAddress(HOST, free.getLocalPort());
        }
        Worker worker = new Worker(new Worker.Options(HOST, address.getPort(), WorkerToken.read(token),
            effort.slots(), Long.MAX_VALUE, Long.MAX_VALUE, () -> Isolation.OFF, league.path().resolve("bundles"),
            Platform.here(), "measured", "this process", paced), bots.types(), told::add);
        try (RemoteGames far = new RemoteGames(league, Season.of(contest.setup(), settings), contest, settings,
                bots.types(), new RemoteGames.Service(address, SHARE, Long.MAX_VALUE, "measured", false), told::add)) {
            start("worker of the measurement", worker::play, told::add);
            try {
                return play(league, settings, contest, far, effort, told);
            } finally {
                worker.drain();
            }
        }
    }

    private Sample play(LeagueFolder league, LeagueSettings settings, Contest contest, RemoteGames far, Effort effort,
                        List<String> told) throws InterruptedException {
        Season season = Season.of(contest.setup(), settings);
        try (GameStore store = GameStore.write(league)) {
            int number = store.open(season);
            RosterReader reader = new RosterReader(store, contest, Map.of(), false, told::add,
                System::currentTimeMillis);
            LeagueRun run = new LeagueRun(league, store, number, season, contest, reader, reader.read(settings),
                new LeagueRun.Limits(far == null ? effort.slots() : 0, Long.MAX_VALUE, Long.MAX_VALUE), "measured",
                told::add, game -> { });
            MeteredGames metered = far == null ? null : new MeteredGames(far);
            if (far != null) {
                run.with(metered);
                far.onCaught((fate, machine, why) -> run.setAside(machine, why));
            }
            Thread playing = start("run of the measurement", run::play, told::add);
            try {
                TimeUnit.NANOSECONDS.sleep((long) (effort.warmSeconds() * NANOS));
                Reading before = read(run, metered);
                TimeUnit.NANOSECONDS.sleep((long) (effort.seconds() * NANOS));
                for (int tries = 0; tries < PATIENCE_TENTHS && run.stored() == before.games(); tries++) {
                    TimeUnit.MILLISECONDS.sleep(100);  // figures are of CPU time: on a busy machine it takes longer
                }
                return sample(before, read(run, metered), far == null ? 1 : far.perJob(), told);
            } finally {
                run.breakOff();
                playing.join();
            }
        }
    }

    /** A measurement in which nothing was played. */
    public static final class NoGameException extends RuntimeException {

        NoGameException(String message) {
            super(message);
        }
    }

    /** Something that is done until it is ended. */
    private interface Work {
        void run() throws InterruptedException;
    }

    private static Thread start(String name, Work work, Consumer<String> teller) {
        Thread thread = new Thread(() -> {
            try {
                work.run();
            } catch (InputException problem) {
                teller.accept(problem.getMessage());
            } catch (InterruptedException end) {
                return;
            }
        }, name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    private Reading read(LeagueRun run, MeteredGames metered) {
        Map<Kind, Long> kinds = new EnumMap<>(Kind.class);
        for (long id : threads.getAllThreadIds()) {
            ThreadInfo info = threads.getThreadInfo(id);
            long cpu = threads.getThreadCpuTime(id);
            if (info != null && cpu > 0 && !strangers.contains(id)) {
                kinds.merge(Kind.of(info.getThreadName()), cpu, Long::sum);
            }
        }
        if (metered != null) {
            long checks = metered.nanos();
            kinds.merge(Kind.SCHEDULE, kinds.getOrDefault(Kind.GAMES, 0L) - checks, Long::sum);
            kinds.put(Kind.GAMES, checks);
        }
        return new Reading(System.nanoTime(), system.getProcessCpuTime(), run.stored(), kinds);
    }

    private static Sample sample(Reading before, Reading after, double perJob, List<String> told) {
        long games = after.games() - before.games();
        if (games == 0) {
            throw new NoGameException("found no game that was stored within "
                + (after.nanos() - before.nanos()) / 1_000_000_000L + " s, expected at least one: the machine is too "
                + "busy" + (told.isEmpty() ? "" : ", or " + told.get(told.size() - 1)));
        }
        Map<Kind, Double> kinds = new EnumMap<>(Kind.class);
        for (Kind kind : Kind.values()) {
            long nanos = after.kinds().getOrDefault(kind, 0L) - before.kinds().getOrDefault(kind, 0L);
            kinds.put(kind, Math.max(0, nanos / NANOS_PER_US / games));
        }
        return new Sample(games * NANOS / (after.nanos() - before.nanos()),
            (after.process() - before.process()) / NANOS_PER_US / games, perJob, kinds);
    }

    /** Lets so many bots begin in a second, and not more when some were late. */
    private static final class Pacer {

        private final double gap;
        private double next = System.nanoTime();

        Pacer(double perSecond) {
            gap = NANOS / perSecond;
        }

        void await() {
            long wait;
            synchronized (this) {
                next = Math.max(next + gap, System.nanoTime() - NANOS / 10);
                wait = (long) (next - System.nanoTime());
            }
            try {
                TimeUnit.NANOSECONDS.sleep(wait);
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
