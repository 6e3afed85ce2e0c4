package steward.machines.serve;

import java.net.InetSocketAddress;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.contest.Contest;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.KeptGames;
import steward.league.play.RemoteMachines;
import steward.league.play.Roster.Member;
import steward.machines.broker.LeagueBroker;
import steward.machines.bundle.Bundle;
import steward.machines.check.DisprovedException;
import steward.machines.check.WorkerBook;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerPauses;
import steward.machines.wire.GameJob;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WorkerWord;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/**
 * The league's side of remote play: gives games to workers and checks their results. A result counts only for a job
 * that the broker handed to the worker that sends it. Each game is computed anew from its commands; if a worker reports
 * something else, it is revoked and its games are set aside. In a worker's first games, and in a share of the others,
 * the bots are asked again. Their answers are evidence only: a worker whose answers differ too often for chance is
 * suspended until a person decides.
 *
 * <p>Over 400 lines, because every message of a worker is answered here, and each game accepted or refused.
 */
public final class RemoteGames implements RemoteMachines, AutoCloseable {

    /** All of a new worker's first games are asked again. */
    static final int FIRST = 20;
    /** More jobs than this are never under way on workers: as many as there can be connections, and some that wait. */
    public static final int MOST = 2500;
    private static final long POLL_MS = 200;

    private final LeagueFolder folder;
    private final Contest contest;
    private final LeagueSettings settings;
    private final LeagueBroker broker;
    private final ReportedGames reported;
    private final double share;
    private final Consumer<String> teller;
    private final SecureRandom random = new SecureRandom();
    private final OfferedJobs offered;
    private final GamePace pace;
    private final WorkerPauses pauses;
    private final WorkerAdmission admission;
    private final JobSize size = new JobSize();
    private final OfferedBundles bundles = new OfferedBundles();
    private final Thread listening = new Thread(this::listen, "what workers say");
    private final LeagueTerms terms;
    private volatile boolean closed;
    /** Why no game can be kept any more, or {@code null}. */
    private volatile InputException unusable;
    /** True if a worker plays; as of the last look. */
    private volatile boolean anyConnected;
    private volatile SettingAside setter = (fate, machine, why) -> 0;

    /** Guarded by this. */
    private final Map<String, WorkerState> workers = new TreeMap<>();
    private int taken;

    /**
     * Service to workers: its address and its rules.
     *
     * @param address    to listen at
     * @param share      of the games whose bots are asked again, 0..1
     * @param leaseNanos after which a job is offered again that a worker has
     * @param scaled     true if the time limits of a worker are scaled by the speed that it has measured
     */
    public record Service(InetSocketAddress address, double share, long leaseNanos, String version, boolean scaled) { }

    /**
     * Begins to serve.
     *
     * @param teller is told what happens, by any thread
     * @throws InputException if nothing can listen there, or a bot cannot be packed
     */
    public RemoteGames(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings, GameTypes types,
                       Service service, Consumer<String> teller) {
        this.folder = folder;
        this.contest = contest;
        this.settings = settings;
        this.teller = teller;
        share = service.share();
        bundles.offerScene(contest.setup());
        reported = new ReportedGames(folder, season, contest, types, teller, this::suspect);
        terms = new LeagueTerms(contest, settings, service);
        settings.active().forEach(Bundle::of);         // what cannot be sent is said before any game is played
        BrokerKey key = new BrokerKey(folder);
        key.make();
        pauses = new WorkerPauses(System::currentTimeMillis, folder);
        admission = new WorkerAdmission(folder, pauses, teller);
        broker = new LeagueBroker(service.address(), key, admission.workers().stream().map(WorkerList.Worker::name)
            .toList(), admission);
        pace = new GamePace(service.leaseNanos());
        offered = new OfferedJobs(broker, () -> anyConnected, this::canPlay, (worker, why) ->
            unplayed(state(worker), why), pauses::untested);
        listening.setDaemon(true);
        listening.start();
    }

    /** Says how games are set aside, and has it done for workers revoked before; before any are played. */
    public void onCaught(SettingAside how) throws InterruptedException {
        setter = how;
        for (WorkerList.Worker worker : admission.workers()) {
            setAside(worker);
        }
    }

    /** Sets the games of a worker aside, or suspends them, if the list says so and it has not been done. */
    private void setAside(WorkerList.Worker worker) throws InterruptedException {
        boolean suspended = worker.doubt() != null;
        if (suspended != admission.isSuspended(worker.name())) {
            admission.suspend(worker.name(), suspended);
            if (suspended || worker.revoked() == null) {
                suspend(worker.name(), suspended);
            }
        }
        WorkerState state;
        synchronized (this) {
            state = worker.aside() || workers.containsKey(worker.name()) ? state(worker.name()) : null;
            if (state == null || state.caught == worker.aside()) {
                return;
            }
            state.caught = worker.aside();             // or it is pardoned
            state.slots = 0;
        }
        if (worker.aside()) {
            int games = setAside(state);
            if (games > 0) {
                say("worker " + state.name + " is revoked; " + games + " of its games are set aside and played again");
            }
        }
    }

    private int setAside(WorkerState state) throws InterruptedException {
        return setter.decide(SettingAside.Fate.ASIDE, WorkerBook.machine(state.name), StoredGame.SET_ASIDE + "worker "
            + state.name + " was caught");
    }

    /** A worker's answers are not those of its bots: its games wait for a decision, and it gets no more. */
    private void suspect(String worker, String doubt) throws InterruptedException {
        if (!admission.isSuspended(worker) && admission.doubt(worker, LeagueTerms.shown(doubt))) {
            admission.suspend(worker, true);
            suspend(worker, true);
        }
    }

    private void suspend(String worker, boolean held) throws InterruptedException {
        int games = setter.decide(held ? SettingAside.Fate.SUSPENDED : SettingAside.Fate.RESTORED,
            WorkerBook.machine(worker), StoredGame.SUSPENDED + "the answers of worker " + worker + " are doubtful");
        say("worker " + worker + (held ? " is suspended: " + TextFormat.count(games, "game") + " of it leave the table "
            + "and the comparison of workers, and it plays no more, until 'steward league worker pardon' or 'revoke' "
            + "decides" : " is pardoned and plays again; its games count"));
    }

    @Override
    public synchronized int takePlace(long waitMs) throws InterruptedException {
        if (taken >= places()) {
            wait(waitMs);
        }
        if (taken >= places()) {
            return 0;
        }
        taken++;
        return size.games(settings.lag() * contest.players() / (places() + 1));   // some are left for all
    }

    /** As many jobs as workers do at the same time, and some that wait, so that nobody has to. */
    private int places() {
        int slots = workers.values().stream().mapToInt(this::slots).sum();
        return Math.min(MOST, slots + (slots + 3) / 4);
    }

    private int slots(WorkerState worker) {
        return admission.isSuspended(worker.name) ? 0 : pauses.places(worker.name, worker.slots);
    }

    @Override
    public synchronized void leavePlace() {
        taken--;
        notifyAll();
    }

    /** Returns how many games wait for a worker. */
    public int waiting() {
        return offered.waiting();
    }

    @Override
    public List<List<StoredGame>> play(List<Game> games) throws InterruptedException {
        if (unusable != null) {
            throw unusable;
        }
        OfferedJobs.Told told = offered.play(games.stream().map(game -> new GameJob.Game(game.task().seed(),
            game.members().stream().map(bundles::seat).toList())).toList(), hurry -> pace.patience(games, hurry));
        List<List<StoredGame>> played = new ArrayList<>(Collections.nCopies(games.size(), null));
        int begun = told == null ? 0 : told.games().size();
        int believed = 0;
        if (told == null) {
            pace.ended(games);
        }
        for (int k = 0; k < begun && unusable == null; k++) {
            try {
                played.set(k, believed(games.get(k), told, told.games().get(k)));
                believed += played.get(k) == null ? 0 : 1;
            } catch (InputException problem) {
                unusable = problem;                    // the games before it count
            }
        }
        if (believed == begun && begun > 0) {
            size.played(told.worker(), begun, told.nanos());
        } else if (unusable != null && believed == 0) {
            throw unusable;
        }
        return played;
    }

    @Override
    public void hurry() {
        offered.hurry();
    }

    @Override
    public boolean canPlay(List<Member> members) {
        return canPlay(bundles.known(members));
    }

    /** True if a worker that is connected has not said of any of these bundles that it does not run there. */
    private synchronized boolean canPlay(Collection<String> needs) {
        return !anyConnected || workers.values().stream().anyMatch(worker -> slots(worker) > 0
            && Collections.disjoint(worker.unfit.keySet(), needs));
    }

    @Override
    public boolean isAway() {
        return !anyConnected;
    }

    @Override
    public synchronized String obstacle(List<Member> members) {
        return WorkerState.obstacle(workers.values(), bundles.known(members));
    }

    /** The game as its transcripts tell it; {@code null} if they are disproved, with consequences for the worker. */
    private List<StoredGame> believed(Game game, OfferedJobs.Told told, WorkerWord.Played played)
            throws InterruptedException {
        WorkerState state = state(told.worker());
        if (played.problem() != null || played.transcripts().isEmpty()) {
            unplayed(state, LeagueTerms.shown(played.problem()));
            return null;
        }
        List<StoredGame> attempts = List.of();
        boolean believed = false;
        try {
            String machine;
            double scale;
            synchronized (this) {
                if (state.caught) {
                    return null;
                }
                machine = WorkerBook.machine(state.name) + state.machine;
                scale = state.scale;
            }
            attempts = reported.attempts(game, played, machine, scale, told.nanos());
            boolean again;
            synchronized (this) {
                again = share > 0 && (state.checked < FIRST || random.nextDouble() < share);
                state.checked += again ? 1 : 0;
            }
            if (again) {
                reported.askAgain(game, state.name, scale, played.transcripts().get(attempts.size() - 1));
            }
            synchronized (this) {
                if (state.caught || admission.isSuspended(state.name)) {
                    return null;
                }
                state.games++;
            }
            believed = true;
            if (pauses.played(state.name)) {
                say("worker " + state.name + " plays again");
            }
            return attempts;
        } catch (DisprovedException wrong) {
            if (wrong.isComputed() && !contest.setup().isGuest()) {
                caught(state, wrong.getMessage());
            } else {
                unplayed(state, LeagueTerms.shown(wrong.getMessage()));
            }
            return null;
        } finally {
            if (!believed) {
                attempts.forEach(attempt -> KeptGames.remove(folder, attempt));
            }
        }
    }

    /** Pauses a worker that has not played a game, and says why when it was not paused before. */
    private void unplayed(WorkerState state, String why) {
        if (pauses.failed(state.name)) {
            say("worker " + state.name + " could not play a game: " + why + "; it is paused, and tried with one job "
                + "after 1 s, 2 s, 4 s and so on");
        }
    }

    /** Notes a game that is stored, by whomever it was played. */
    public void stored(StoredGame game) {
        pace.played(game);
    }

    private void caught(WorkerState state, String why) throws InterruptedException {
        synchronized (this) {
            if (state.caught) {
                return;
            }
            state.caught = true;
            state.slots = 0;
        }
        admission.revoke(state.name, "caught: " + LeagueTerms.shown(why));
        broker.disconnect(state.name);
        int games = setAside(state);
        say("worker " + state.name + " is caught and revoked: " + why + "; " + games
            + " of its games are set aside and played again");
    }

    @Override
    public synchronized boolean isTrusted(String machine) {
        return workers.values().stream().noneMatch(worker -> (worker.caught || admission.isSuspended(worker.name))
            && machine.startsWith(WorkerBook.machine(worker.name)));
    }

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
    private void look() throws InterruptedException {
        Set<String> connected = broker.connected();
        broker.offerAgain();
        offered.lookAfterRecalled();
        synchronized (this) {
            workers.values().forEach(worker -> worker.slots = connected.contains(worker.name) ? worker.slots : 0);
            workers.values().stream().filter(worker -> worker.slots == 0).forEach(worker -> size.forget(worker.name));
            anyConnected = workers.values().stream().anyMatch(worker -> worker.slots > 0);
            notifyAll();
        }
        if (!admission.isChanged()) {
            return;
        }
        for (WorkerList.Worker worker : admission.workers()) {
            if (worker.revoked() == null) {
                broker.open(worker.name());
            } else if (connected.contains(worker.name())) {
                broker.disconnect(worker.name());
                say("worker " + worker.name() + " is revoked");
            }
            setAside(worker);
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
                broker.tell(state.name, bundles.piece(fetch));
            } else if (word instanceof WorkerWord.Result result) {
                offered.told(state.name, result);
            } else if (word instanceof WorkerWord.Unfit unfit) {
                unfit(state, unfit);
            } else if (word instanceof WorkerWord.Differs differs) {
                String difference = terms.difference(state, differs);
                leave(state);
                say(difference);
            } else {
                leave(state);
            }
        } catch (InputException | SceneException problem) {
            say("worker " + report.worker() + " is sent away: " + LeagueTerms.shown(problem.getMessage()));
            broker.disconnect(report.worker());
        }
    }

    private void hello(WorkerState state, WorkerWord.Hello hello) {
        String why = terms.refusal(state, hello);
        if (why != null) {
            say(why);
            broker.tell(state.name, new LeagueWord.Refused(why).bytes());
            return;
        }
        synchronized (this) {
            state.slots = hello.slots();
            admission.joined(state.name, hello.slots());
            state.unfit.clear();                       // it may be another machine by now; it says them again
            terms.note(state, hello);
            state.began = state.began == 0 ? System.nanoTime() : state.began;
            anyConnected = true;
            notifyAll();
        }
        say("worker " + state.name + " plays " + TextFormat.count(hello.slots(), "game") + " at a time: "
            + state.machine);
        broker.tell(state.name, bundles.greeting(terms.welcome(state)));
    }

    private void unfit(WorkerState state, WorkerWord.Unfit unfit) {
        boolean isNew;
        synchronized (this) {
            isNew = bundles.has(unfit.bundle())
                && state.unfit.put(unfit.bundle(), LeagueTerms.shown(unfit.reason())) == null;
        }
        if (isNew) {
            say("worker " + state.name + " cannot play a bot: " + LeagueTerms.shown(unfit.reason()));
            offered.lookWhoCanPlay();
            pauses.untested(state.name);               // it gives the job back
        }
    }

    private synchronized void leave(WorkerState state) {
        state.slots = 0;
        notifyAll();
    }

    private synchronized WorkerState state(String name) {
        return workers.computeIfAbsent(name, WorkerState::new);
    }

    private void say(String what) {
        teller.accept(what);
    }

    /** All workers that have said anything. */
    public synchronized List<WorkerSeen> seen() {
        List<WorkerSeen> seen = new ArrayList<>();
        workers.values().forEach(worker -> seen.add(worker.seen(admission.isSuspended(worker.name),
            reported.doubts(worker.name))));
        return seen;
    }

    @Override
    public void close() {
        closed = true;
        offered.close();
        listening.interrupt();
        broker.close();
    }
}
