package steward.machines.worker;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.bundle.Bundle;
import steward.machines.bundle.LongScene;
import steward.machines.bundle.UnpackedBundle;
import steward.machines.check.MachineSpeed;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.match.GuestSetup;
import steward.scene.RungLaw;
import steward.scene.Scene;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/**
 * Main loop of a worker: plays games of a league on this machine until it is told to end. If the connection breaks, it
 * connects again; games under way are then lost here and go to other workers.
 */
public final class Worker {

    private static final long POLL_MS = 500;
    private static final long PATIENCE_MS = 20_000;
    private static final long SHORTEST_WAIT_MS = 250;
    private static final long LONGEST_WAIT_MS = 30_000;

    private final Options options;
    private final GameTypes types;
    private final boolean runsReferees;
    private final Consumer<String> teller;
    private final long end;
    private final int speed = MachineSpeed.measure();
    private final String process = UUID.randomUUID().toString();
    private final AtomicLong begun = new AtomicLong();
    private final AtomicLong played = new AtomicLong();
    /** Bundles that do not run here, and why. */
    private final Map<String, String> unfit = new ConcurrentSkipListMap<>();
    /** Time before the next connection, in milliseconds: twice as long after each one that the league does not take. */
    private long wait = SHORTEST_WAIT_MS;
    private volatile boolean draining;
    private volatile long lastJob = System.nanoTime();

    /** The league does not take this worker: its token is not good, or the programs compute other results. */
    public static final class RefusedException extends RuntimeException {

        RefusedException(String message) {
            super(message);
        }
    }

    /**
     * Options of a worker.
     *
     * @param slots     games at the same time
     * @param games     after which it ends; {@code Long.MAX_VALUE} for no end
     * @param nanos     after which no game is begun; {@code Long.MAX_VALUE} for no end
     * @param isolation how bots are kept apart
     * @param folder    where bundles go
     * @param platform  that it is, as commands of bots are for one
     * @param machine   what it is played on
     */
    public record Options(String host, int port, WorkerToken token, int slots, long games, long nanos,
                          Supplier<Isolation> isolation, Path folder, String platform, String version,
                          String machine) { }

    /** @param teller is told what happens, by any thread */
    public Worker(Options options, GameTypes types, Consumer<String> teller) {
        this.options = options;
        this.types = types;
        runsReferees = types.guest() != null && types.guest().isTrusted();
        this.teller = teller;
        end = options.nanos() == Long.MAX_VALUE ? Long.MAX_VALUE : System.nanoTime() + options.nanos();
    }

    /** Takes no more games; those under way are finished. Any thread may call it. */
    public void drain() {
        draining = true;
    }

    /** Returns for how long it has had no job, in nanoseconds. */
    public long idleNanos() {
        return begun.get() > played.get() ? 0 : System.nanoTime() - lastJob;
    }

    /** How many games were played and reported. */
    public long played() {
        return played.get();
    }

    private boolean isOver() {
        return draining || begun.get() >= options.games() || end != Long.MAX_VALUE && System.nanoTime() - end >= 0;
    }

    /**
     * Plays until no more games may begin. Call once.
     *
     * @throws RefusedException if the league does not take it
     * @throws InputException   if what the league says cannot be used
     */
    public void play() throws InterruptedException {
        String told = "";
        while (!isOver()) {
            long before = played.get();
            try (BrokerClient client = new BrokerClient(options.host(), options.port(), options.token(), process)) {
                session(client);
            } catch (BrokenException problem) {
                if (problem.isRefused() && played.get() == before) {
                    throw new RefusedException(problem.getMessage());
                }
                String what = problem.getMessage() + "; it is tried again";
                if (!what.equals(told)) {
                    teller.accept(what);
                }
                told = what;
            }
            for (long slept = 0; slept < wait && !isOver(); slept += SHORTEST_WAIT_MS) {
                TimeUnit.MILLISECONDS.sleep(SHORTEST_WAIT_MS);
            }
            wait = Math.min(LONGEST_WAIT_MS, wait * 2);
        }
    }

    /** Plays over one connection. */
    private void session(BrokerClient client) throws BrokenException, InterruptedException {
        client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", options.version())
            .put("bits", RungLaw.keys()).put("machine", options.machine()).put("slots", options.slots())
            .put("speed", speed).put("guests", runsReferees)));
        JobPlay jobs = welcome(client);
        wait = SHORTEST_WAIT_MS;
        for (String bundle : unfit.keySet()) {
            sayUnfit(client, bundle);
        }
        teller.accept("joined " + options.host() + ":" + options.port() + " as " + options.token().worker() + ", "
            + options.slots() + (options.slots() == 1 ? " game" : " games") + " at a time");
        List<Thread> threads = new ArrayList<>();
        List<Exception> problems = Collections.synchronizedList(new ArrayList<>());
        for (int slot = 0; slot < options.slots(); slot++) {
            Thread thread = new Thread(() -> {
                try {
                    slot(client, jobs);
                } catch (Exception problem) {
                    problems.add(problem);
                }
            }, "worker");
            thread.setDaemon(true);
            thread.start();
            threads.add(thread);
        }
        for (Thread thread : threads) {
            thread.join();
        }
        if (problems.isEmpty()) {
            client.say(WireMessage.bytes(new HeaderText().put("type", "bye")));
            return;
        }
        Exception first = problems.get(0);
        if (first instanceof BrokenException broken) {
            throw broken;
        }
        throw new InputException("what the league says cannot be used: " + first.getMessage());
    }

    private JobPlay welcome(BrokerClient client) throws BrokenException {
        LeagueWord answer = heard(client, word -> word instanceof LeagueWord.Refused
            || word instanceof LeagueWord.Welcome ? word : null);      // others are of an earlier connection
        if (answer instanceof LeagueWord.Refused refused) {
            throw new RefusedException(refused.reason());
        }
        if (answer instanceof LeagueWord.Welcome welcome) {
            return jobs(client, welcome);
        }
        throw new BrokenException(options.host() + ":" + options.port() + ": the league does not answer", false);
    }

    /** Returns that of the league's words that is wanted, or {@code null} if it has not come in time. */
    private static <T> T heard(BrokerClient client, Function<LeagueWord, T> wanted) throws BrokenException {
        long began = System.nanoTime();
        while (System.nanoTime() - began < TimeUnit.MILLISECONDS.toNanos(PATIENCE_MS)) {
            byte[] bytes = client.listen(POLL_MS);
            T found = bytes == null ? null : wanted.apply(word(bytes));
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /** The scene of a league, with the files of its own referee as they are here. */
    private String scene(BrokerClient client, LeagueWord.Welcome welcome) throws BrokenException {
        String text = welcome.scene() != null ? welcome.scene()
            : LongScene.text(welcome.bundle(), fetch(client, welcome.bundle(), welcome.size()));
        Scene scene = SceneReader.read(text, "the league's scene");
        if (types.guest() == null || !types.guest().id().equals(scene.gameId())) {
            return text;
        }
        UnpackedBundle files = !runsReferees || welcome.scene() == null || welcome.bundle() == null ? null
            : UnpackedBundle.of(options.folder(), welcome.bundle(), fetch(client, welcome.bundle(), welcome.size()),
                options.platform());
        GuestSetup setup = (GuestSetup) types.open(scene);
        if (files == null || setup.isOnClassPath() && !files.command().words().stream()
                .allMatch(entry -> Path.of(entry).startsWith(files.root().toAbsolutePath()))) {
            throw new RefusedException("the league's scene has a referee of its own, expected --guests here, and its "
                + "files from the league");
        }
        return setup.sceneWith(files.command().words());
    }

    private JobPlay jobs(BrokerClient client, LeagueWord.Welcome welcome) throws BrokenException {
        try {
            return new JobPlay(welcome.with(scene(client, welcome), null, 0), types, options.isolation(),
                options.folder(), options.platform(), options.version());
        } catch (SceneException problem) {
            throw new InputException(problem.getMessage());
        } catch (JobPlay.OtherRulesException problem) {
            client.say(WireMessage.bytes(problem.word()));
            throw new RefusedException(problem.getMessage());
        }
    }

    private static LeagueWord word(byte[] bytes) {
        return InputException.of(() -> LeagueWord.read(bytes, "the league", Bundle.LARGEST));
    }

    /** Plays in one slot: takes jobs until it is over. */
    private void slot(BrokerClient client, JobPlay jobs) throws Exception {
        while (!isOver()) {
            int known = unfit.size();
            try (BrokerClient.Taker taker = client.taker(unfit.keySet())) {
                while (!isOver() && unfit.size() == known) {
                    byte[] bytes = taker.take(POLL_MS);
                    if (bytes == null) {
                        continue;
                    }
                    GameJob job = GameJob.read(bytes, "the league", Bundle.LARGEST);
                    try {
                        WorkerWord.Result result = jobs.play(job, (hash, size) -> fetch(client, hash, size),
                            this::begins);
                        if (result.games().isEmpty()) {
                            return;                    // the last games are other places'
                        }
                        report(taker, result);
                    } catch (JobPlay.UnfitException problem) {
                        unfit.put(problem.bundle(), JobPlay.shortened(problem.getMessage()));
                        teller.accept(problem.getMessage());
                        sayUnfit(client, problem.bundle());
                    }
                }
            }
        }
    }

    /** Reports a result. If that fails, its games are handed back and other workers play them. */
    private void report(BrokerClient.Taker taker, WorkerWord.Result result) throws BrokenException {
        boolean reported = false;
        try {
            taker.finish(result.bytes());
            played.addAndGet(result.games().size());
            lastJob = System.nanoTime();
            reported = true;
        } finally {
            begun.addAndGet(reported ? 0 : -result.games().size());
        }
    }

    private void sayUnfit(BrokerClient client, String bundle) throws BrokenException {
        client.say(WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle", bundle)
            .put("reason", unfit.get(bundle))));
    }

    /** Reserves one more game. @return false if none may begin */
    private boolean begins() {
        return !isOver() && begun.incrementAndGet() <= options.games();
    }

    /** Fetches the bytes of a bundle, piece by piece; one bundle at a time. */
    private synchronized byte[] fetch(BrokerClient client, String hash, int size) throws BrokenException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        while (bytes.size() < size) {
            client.say(WireMessage.bytes(new HeaderText().put("type", "fetch").put("bundle", hash)
                .put("from", bytes.size())));
            byte[] part = part(client, hash, bytes.size());
            if (part.length == 0 || bytes.size() + part.length > size) {
                throw new InputException("the league has no bundle " + hash + " of " + size + " bytes any more");
            }
            bytes.write(part, 0, part.length);
        }
        return bytes.toByteArray();
    }

    private static byte[] part(BrokerClient client, String hash, int from) throws BrokenException {
        byte[] part = heard(client, word -> word instanceof LeagueWord.Piece piece && piece.bundle().equals(hash)
            && piece.from() == from ? piece.bytes() : null);
        if (part == null) {
            throw new BrokenException("the league does not send the bundle " + hash, false);
        }
        return part;
    }
}
