package steward.machines.serve;

import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import steward.contest.Contest;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.Elsewhere;
import steward.league.play.KeptGames;
import steward.league.play.Roster.Member;
import steward.machines.broker.LeagueBroker;
import steward.machines.bundle.Bundle;
import steward.machines.check.DisprovedException;
import steward.machines.check.RulesFingerprint;
import steward.machines.check.WorkerBook;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.scene.PhysicsFingerprint;
import steward.scene.json.SceneException;

/**
 * Games of a league that workers play. A result counts only for a job that the broker handed to the worker that sends
 * it. What a game came to is read from its replay, which is played again; in a worker's first games, and in a share of
 * the others, the bots are asked again. A worker that is caught is revoked and its games are set aside.
 *
 * <p>Longer than others: a game is followed here from the offer to the answer, and each word of a worker.
 */
public final class RemoteGames implements Elsewhere, AutoCloseable {

    /** All of a new worker's first games are asked again. */
    static final int FIRST = 20;
    /** More games than this are never under way on workers: as many as there can be connections, and some that wait. */
    public static final int MOST = 2500;
    private static final long POLL_MS = 200;
    /** How often it is looked whether a game under way has to go to others, in milliseconds. */
    private static final long LOOK_MS = 1000;
    /** How long an offered game waits for a worker when none is connected, in nanoseconds. */
    private static final long ALONE_NANOS = TimeUnit.SECONDS.toNanos(5);
    private static final int LONGEST_TEXT = 200;

    private final LeagueFolder folder;
    private final Contest contest;
    private final LeagueSettings settings;
    private final LeagueBroker broker;
    private final ReportedGames reported;
    private final double share;
    private final long leaseNanos;
    private final String version;
    private final String rules;
    private final Consumer<String> teller;
    private final SecureRandom random = new SecureRandom();
    private final Map<String, Offer> offers = new ConcurrentHashMap<>();
    private final Map<String, Bundle> bundles = new ConcurrentHashMap<>();
    private final Map<String, Bundle> byStamp = new ConcurrentHashMap<>();
    private final Thread listening = new Thread(this::listen, "what workers say");
    private volatile WorkerList list;
    private volatile boolean closed;
    /** Whether a worker plays; as of the last look. */
    private volatile boolean anyConnected;
    private volatile SettingAside setter = (machine, why) -> 0;

    /** Guarded by this. */
    private final Map<String, WorkerState> workers = new TreeMap<>();
    private int taken;
    private String stamp;

    /** Sets the games of a machine aside. */
    public interface SettingAside {
        /** See {@link steward.league.play.LeagueRun#setAside}. */
        int setAside(String machine, String why) throws InterruptedException;
    }

    /** A job that is offered, and what comes of it: {@code null} if somebody else has to play it. */
    private record Offer(CompletableFuture<Played> played) {
    }

    /** What a worker says of a job. */
    private record Played(String worker, List<byte[]> replays, List<Boolean> starved) {
    }

    /**
     * How workers are served.
     *
     * @param address    to listen at
     * @param share      of the games whose bots are asked again, 0..1
     * @param leaseNanos after which a job is offered again that a worker has
     * @param version    of this program
     */
    public record Service(InetSocketAddress address, double share, long leaseNanos, String version) {
    }

    /**
     * Begins to serve.
     *
     * @param contest of the scene
     * @param teller  is told what happens, by any thread
     * @throws InputException if nothing can listen there, or a bot cannot be packed
     */
    public RemoteGames(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings, GameTypes types,
                       Service service, Consumer<String> teller) {
        this.folder = folder;
        this.contest = contest;
        this.settings = settings;
        this.teller = teller;
        share = service.share();
        leaseNanos = service.leaseNanos();
        version = service.version();
        rules = RulesFingerprint.of(contest.setup());
        reported = new ReportedGames(folder, season, contest, types);
        stamp = WorkerList.stamp(folder);
        list = WorkerList.read(folder);
        settings.active().forEach(Bundle::of);         // what cannot be sent is said before any game is played
        BrokerKey key = new BrokerKey(folder);
        key.make();
        broker = new LeagueBroker(service.address(), key, list.workers().stream().map(WorkerList.Worker::name).toList(),
            (name, secret) -> list.admits(name, secret));
        listening.setDaemon(true);
        listening.start();
    }

    /** Says how games are set aside; before any are played. */
    public void onCaught(SettingAside how) {
        setter = how;
    }

    // ---- games -----------------------------------------------------------------------------------

    @Override
    public synchronized boolean takePlace(long waitMs) throws InterruptedException {
        if (taken >= places()) {
            wait(waitMs);
        }
        if (taken >= places()) {
            return false;
        }
        taken++;
        return true;
    }

    /** As many games as workers play at the same time, and some that wait, so that nobody has to. */
    private int places() {
        int slots = workers.values().stream().mapToInt(worker -> worker.slots).sum();
        return Math.min(MOST, slots + (slots + 3) / 4);
    }

    @Override
    public synchronized void leavePlace() {
        taken--;
        notifyAll();
    }

    @Override
    public List<StoredGame> play(Schedule.Task task, LeagueSettings now, List<Member> members)
            throws InterruptedException {
        HeaderText header = new HeaderText();
        byte[] id = new byte[16];
        random.nextBytes(id);
        String job = HexFormat.of().formatHex(id);
        Set<String> needs = new TreeSet<>();
        List<HeaderText> seats = new ArrayList<>();
        for (Member member : members) {
            Bundle bundle = bundle(member);
            needs.add(bundle.hash());
            seats.add(new HeaderText().put("name", member.entrant().name()).put("bundle", bundle.hash())
                .put("size", bundle.bytes().length));
        }
        header.put("type", "job").put("job", job).put("seed", Long.toString(task.seed())).put("seats", seats);
        Offer offer = new Offer(new CompletableFuture<>());
        offers.put(job, offer);
        try {
            broker.offer(job, needs, WireMessage.bytes(header));
            Played played = await(job, offer);
            return played == null ? null : believed(task, now, members, played);
        } finally {
            offers.remove(job);
            broker.forget(job);
        }
    }

    private Bundle bundle(Member member) {
        Bundle bundle = byStamp.computeIfAbsent(member.bot().name() + "\n" + member.stamp(),
            key -> Bundle.of(member.bot()));
        bundles.put(bundle.hash(), bundle);
        return bundle;
    }

    private Played await(String job, Offer offer) throws InterruptedException {
        long alone = 0;
        while (!closed) {
            try {
                return offer.played().get(LOOK_MS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException none) {
                alone = anyConnected ? 0 : alone == 0 ? System.nanoTime() : alone;
                if (alone != 0 && System.nanoTime() - alone > ALONE_NANOS) {
                    return null;
                }
                if (broker.heldNanos(job) > leaseNanos) {
                    say("worker " + broker.holder(job) + " has not finished a game within "
                        + TimeUnit.NANOSECONDS.toSeconds(leaseNanos) + " s; it goes to others");
                    return null;
                }
            } catch (ExecutionException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
        return null;
    }

    /** The game as its replays tell it; {@code null} if they are disproved, which has consequences for the worker. */
    private List<StoredGame> believed(Schedule.Task task, LeagueSettings now, List<Member> members, Played played)
            throws InterruptedException {
        String worker = played.worker();
        WorkerState state = state(worker);
        List<StoredGame> attempts = List.of();
        boolean believed = false;
        try {
            String machine;
            synchronized (this) {
                machine = WorkerState.machine(worker) + state.machine;
            }
            attempts = reported.attempts(task, now, members, played.replays(), played.starved(),
                machine);
            boolean again;
            synchronized (this) {
                again = share > 0 && (state.checked < FIRST || random.nextDouble() < share);
                state.checked += again ? 1 : 0;
            }
            if (again) {
                reported.askAgain(task, members, played.replays().get(attempts.size() - 1));
            }
            synchronized (this) {
                if (state.caught) {
                    return null;
                }
                state.games++;
            }
            believed = true;
            return attempts;
        } catch (DisprovedException wrong) {
            caught(state, wrong.getMessage());
            return null;
        } finally {
            if (!believed) {
                attempts.forEach(game -> KeptGames.remove(folder, game));
            }
        }
    }

    private void caught(WorkerState state, String why) throws InterruptedException {
        synchronized (this) {
            if (state.caught) {
                return;
            }
            state.caught = true;
            state.slots = 0;
        }
        boolean interrupted = Thread.interrupted();    // which would keep the list from being written
        try {
            WorkerList.revoke(folder, state.name, "caught: " + shown(why));
        } catch (InputException gone) {
            say(gone.getMessage());
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
        list = WorkerList.read(folder);
        broker.disconnect(state.name);
        int games = setter.setAside(WorkerState.machine(state.name), WorkerBook.ASIDE + "worker " + state.name
            + " was caught");
        say("worker " + state.name + " is caught and revoked: " + why + "; " + games
            + " of its games are set aside and played again");
    }

    @Override
    public synchronized boolean isTrusted(String machine) {
        return workers.values().stream().noneMatch(worker -> worker.caught
            && machine.startsWith(WorkerState.machine(worker.name)));
    }

    // ---- what workers say ------------------------------------------------------------------------

    private void listen() {
        long looked = System.nanoTime();
        while (!closed) {
            try {
                LeagueBroker.Report report = broker.next(POLL_MS);
                if (report != null) {
                    heard(report);
                }
                if (System.nanoTime() - looked > TimeUnit.MILLISECONDS.toNanos(POLL_MS)) {
                    looked = System.nanoTime();
                    look();
                }
            } catch (InterruptedException end) {
                return;
            } catch (RuntimeException problem) {
                if (closed) {
                    return;
                }
                say("what a worker says cannot be used: " + problem);
            }
        }
    }

    /** Looks who is there, and whether somebody was added or revoked. */
    private void look() {
        Set<String> connected = broker.connected();
        synchronized (this) {
            workers.values().forEach(worker -> worker.slots = connected.contains(worker.name) ? worker.slots : 0);
            anyConnected = workers.values().stream().anyMatch(worker -> worker.slots > 0);
            notifyAll();
        }
        String now = WorkerList.stamp(folder);
        if (now.equals(stamp)) {
            return;
        }
        stamp = now;
        try {
            list = WorkerList.read(folder);
        } catch (InputException problem) {
            say(problem.getMessage() + "; the workers stay as they were");
            return;
        }
        for (WorkerList.Worker worker : list.workers()) {
            if (worker.revoked() == null) {
                broker.open(worker.name());
            } else if (connected.contains(worker.name())) {
                broker.disconnect(worker.name());
                say("worker " + worker.name() + " is revoked");
            }
        }
    }

    private void heard(LeagueBroker.Report report) {
        try {
            WorkerWord word = WorkerWord.read(report.bytes(), "worker " + report.worker(), Bundle.LARGEST);
            WorkerState state = state(report.worker());
            synchronized (this) {
                state.lastWord = System.currentTimeMillis();
            }
            if (word instanceof WorkerWord.Hello hello) {
                hello(state, hello);
            } else if (word instanceof WorkerWord.Fetch fetch) {
                fetch(state, fetch);
            } else if (word instanceof WorkerWord.Result result) {
                result(state, result);
            } else if (word instanceof WorkerWord.Unfit unfit) {
                say("worker " + state.name + " cannot play a bot: " + shown(unfit.reason()));
            } else if (word instanceof WorkerWord.Differs differs) {
                leave(state);
                say(apart(state.name, state.version, shown(differs.rules()), rules));
            } else {
                leave(state);
            }
        } catch (InputException | SceneException problem) {
            say("worker " + report.worker() + " is sent away: " + shown(problem.getMessage()));
            broker.disconnect(report.worker());
        }
    }

    /** That two programs do not compute the same. */
    private String apart(String worker, String theirs, String their, String own) {
        return "found Steward " + theirs + " (results " + their + ") on worker " + worker + " and Steward " + version
            + " (results " + own + ") in the league, expected versions that compute the same";
    }

    private static String shown(String text) {
        String plain = String.valueOf(text).replaceAll("[^ -~]", "?");
        return plain.length() > LONGEST_TEXT ? plain.substring(0, LONGEST_TEXT) : plain;
    }

    private void hello(WorkerState state, WorkerWord.Hello hello) {
        int slots = hello.slots();
        String own = PhysicsFingerprint.text();
        if (!hello.bits().equals(own)) {
            String why = apart(state.name, shown(hello.version()), shown(hello.bits()), own);
            say(why);
            broker.tell(state.name, WireMessage.bytes(new HeaderText().put("type", "refused").put("reason", why)));
            return;
        }
        synchronized (this) {
            state.slots = slots;
            state.version = shown(hello.version());
            state.machine = shown(hello.machine());
            state.began = state.began == 0 ? System.nanoTime() : state.began;
            anyConnected = true;
            notifyAll();
        }
        say("worker " + state.name + " plays " + slots + (slots == 1 ? " game" : " games") + " at a time: "
            + shown(hello.machine()));
        HeaderText welcome = new HeaderText().put("type", "welcome").put("version", version)
            .put("rules", rules).put("factor", Double.toString(settings.factor()))
            .put("basis", settings.basis().word()).put("hiccups", settings.hiccups().word());
        broker.tell(state.name, WireMessage.bytes(welcome,
            contest.setup().scene().json().getBytes(StandardCharsets.UTF_8)));
    }

    private void fetch(WorkerState state, WorkerWord.Fetch fetch) {
        String hash = fetch.bundle();
        int from = fetch.from();
        Bundle bundle = bundles.get(hash);
        HeaderText answer = new HeaderText().put("type", "bundle").put("bundle", hash).put("from", from);
        byte[] part = {};
        if (bundle != null && from <= bundle.bytes().length) {
            part = Arrays.copyOfRange(bundle.bytes(), from, Math.min(bundle.bytes().length, from + WireMessage.CHUNK));
        }
        broker.tell(state.name, WireMessage.bytes(answer.put("known", bundle != null), part));
    }

    private synchronized void leave(WorkerState state) {
        state.slots = 0;
        notifyAll();
    }

    private void result(WorkerState state, WorkerWord.Result result) {
        Offer offer = offers.get(result.job());
        if (offer == null || !state.name.equals(broker.holder(result.job()))) {
            return;                                    // too late, or never its own: somebody else plays it
        }
        if (result.problem() != null || result.replays().isEmpty()) {
            say("worker " + state.name + " could not play a game: " + shown(result.problem()));
            offer.played().complete(null);
            return;
        }
        offer.played().complete(new Played(state.name, result.replays(), result.starved()));
    }

    private synchronized WorkerState state(String name) {
        return workers.computeIfAbsent(name, WorkerState::new);
    }

    private void say(String what) {
        teller.accept(what);
    }

    // ---- for people ------------------------------------------------------------------------------

    /** All workers that have said anything. */
    public synchronized List<WorkerSeen> seen() {
        List<WorkerSeen> seen = new ArrayList<>();
        for (WorkerState worker : new HashMap<>(workers).values()) {
            double seconds = Math.max(1, System.nanoTime() - worker.began) / 1e9;
            seen.add(new WorkerSeen(worker.name, worker.slots, worker.games / seconds, worker.version,
                System.currentTimeMillis() - worker.lastWord, worker.caught));
        }
        seen.sort((one, other) -> one.name().compareTo(other.name()));
        return seen;
    }

    @Override
    public void close() {
        closed = true;
        offers.values().forEach(offer -> offer.played().complete(null));
        listening.interrupt();
        broker.close();
    }
}
