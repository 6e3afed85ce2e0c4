package steward.league.play;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import steward.contest.Contest;
import steward.contest.WorkerThreads;
import steward.files.InputException;
import steward.league.EarlierGames;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.LeagueEnd;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.play.Roster.Member;
import steward.league.rating.Ratings;
import steward.league.store.AsideGames;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.GameWriter;
import steward.text.TextFormat;

/**
 * A league while it is played: threads that take games from the schedule, play them, and hand them over to be stored.
 * Between games league.json is read anew ({@link RosterWatch}).
 *
 * <p>Over 400 lines, because the threads and what ends them read the same fields.
 */
public final class LeagueRun {

    /** How long a thread sleeps that has to wait for other games, in milliseconds. */
    static final long WAIT_MS = 100;

    private final LeagueFolder folder;
    private final GameStore store;
    private final int season;
    private final GameWriter writer;
    private final GamePlay play;
    private final RosterWatch watch;
    private final Schedule schedule;
    private final Limits limits;
    private final Consumer<String> teller;
    private final Consumer<StoredGame> listener;
    private final long end;
    private final GameQueries queries;
    /** Below this number no decision's results are asked for alone. */
    private final int settled;
    /** Other machines, or {@code null}; set before the run begins. */
    private Elsewhere elsewhere;

    /** Guarded by this, as is all below. */
    private final RunResults results;
    private LeagueEnd leagueEnd;
    private StopRule rule = StopRule.NONE;
    private BiFunction<Roster, Map<List<Integer>, Integer>, Schedule.Plan> plan;
    private Roster roster;
    private Map<Integer, Member> members;
    private int underWay;
    private boolean brokenOff;
    private boolean ended;
    private String stopped;
    private long handed;
    private Pauses pauses;
    private final Standstill standstill;
    private final ForgivenGames forgiven = new ForgivenGames();

    /**
     * Limits of a run.
     *
     * @param threads games at the same time
     * @param games   that the schedule has in all when the run ends; {@code Long.MAX_VALUE} for no end
     * @param nanos   after which no game is begun; {@code Long.MAX_VALUE} for no end
     */
    public record Limits(int threads, long games, long nanos) { }

    /**
     * A run that is to begin.
     *
     * @param season   its number in the store
     * @param machine  what is noted with each game
     * @param teller   is told what happens, by any thread
     * @param listener is told of each game that is handed over to be stored, by any thread
     */
    public LeagueRun(LeagueFolder folder, GameStore store, int season, Season key, Contest contest,
                     RosterReader reader, Roster roster, Limits limits, String machine, Consumer<String> teller,
                     Consumer<StoredGame> listener) {
        this.folder = folder;
        this.store = store;
        this.season = season;
        this.limits = limits;
        this.teller = teller;
        this.listener = listener;
        standstill = new Standstill(limits.threads() > 0, teller);
        play = new GamePlay(key, contest, new KeptGames(folder), machine, System::currentTimeMillis);
        queries = new GameQueries(store, season, key);
        EarlierGames earlier = queries.earlier();
        settled = Looks.settled(earlier.firstOpen(), roster.settings().lag());
        schedule = new Schedule(roster.settings().seed(), key.players(), roster.settings().lag(), earlier);
        results = new RunResults(key, queries, settled);
        schedule.without(results.repeated());
        if (roster.settings().adaptive() && key.players() > 1) {
            results.learn();
        }
        watch = new RosterWatch(folder, reader, roster.settings(), teller);
        pauses = new Pauses(0, roster.settings().lag(), settled, folder, store, queries, teller);
        use(roster);
        end = limits.nanos() == Long.MAX_VALUE ? Long.MAX_VALUE : System.nanoTime() + limits.nanos();
        writer = new GameWriter(store, season);
    }

    private void use(Roster next) {
        folder.named(() -> next.checked(play.season().players()));
        roster = next;
        members = next.byVersion();
        LeagueSettings settings = next.settings();
        pauses.use(next, schedule);
        schedule.meeting(next.meeting());
        if (plan != null) {
            schedule.following(decided -> plan.apply(next, decided));
        }
        schedule.play(next.versions(), versions -> pairing(settings, versions, next));
    }

    private Pairing pairing(LeagueSettings settings, List<Integer> versions, Roster next) {
        int players = play.season().players();
        if (settings.adaptive()) {
            return new AdaptivePairing(versions, players, settings.lag(), rule,
                before -> Ratings.of(results.known().before(before), versions));
        }
        return settings.gauntlet() == null ? Pairing.roundRobin(versions, players)
            : Pairing.gauntlet(versions, players, next.versionOf(settings.gauntlet()).orElseThrow());
    }

    /** Ends the run when enough is known; before {@link #play}. */
    public synchronized void until(StopRule stop) {
        rule = stop;
        results.learn();
        leagueEnd = new LeagueEnd(stop, results.known(), roster.settings().lag(), schedule::active);
        schedule.until(leagueEnd);
        use(roster);
    }

    /**
     * Plays what a plan says and no more; before {@link #play}.
     *
     * @param maker makes the plan for a roster from the decisions by group so far
     * @return the number of games to be played
     */
    public synchronized long following(BiFunction<Roster, Map<List<Integer>, Integer>, Schedule.Plan> maker) {
        plan = maker;
        use(roster);
        return schedule.planned();
    }

    /** The rule that ended the run with what was known, or {@code null}. */
    public synchronized LeagueEnd ended() {
        return leagueEnd != null && leagueEnd.met() != null ? leagueEnd : null;
    }

    /** True if the run has ended since the bots only repeat games that were played before. */
    public synchronized boolean isRepeated() {
        return schedule.isRepeated();
    }

    /** Lets other machines play, too; before {@link #play}. */
    public void with(Elsewhere machines) {
        elsewhere = machines;
    }

    /** Pauses bots that failed in so many games in a row, 0 for never; before {@link #play}. */
    public synchronized void pauseAfter(int most) {
        pauses = new Pauses(most, roster.settings().lag(), settled, folder, store, queries, teller);
        use(roster);
    }

    /** Plays until an end is reached. Call once. */
    public void play() throws InterruptedException {
        int far = elsewhere == null ? 0 : 1;
        synchronized (this) {
            forgiven.decide(store, season, play, this::members, schedule);
        }
        writer.start();                                // not before: a run that is refused leaves no thread
        try {
            WorkerThreads.run("league", limits.threads() + far, thread -> thread < limits.threads() ? this::playHere
                : () -> new FarGames(elsewhere).play(new Far()));
        } finally {
            writer.close();
        }
        if (writer.problem() != null) {
            stop(writer.problem().getMessage());
        }
    }

    private Void playHere() throws InterruptedException {
        boolean more = true;
        while (more) {
            List<Elsewhere.Game> games = takeOrEnd(1, Standstill::isForHere);
            more = !games.isEmpty() && play(games, one -> List.of(play.play(one.get(0))));
        }
        return null;
    }

    /** Games that are played elsewhere. */
    private final class Far implements FarGames.Run {

        @Override
        public boolean isOver() {
            synchronized (LeagueRun.this) {
                return ended || brokenOff || stopped != null;
            }
        }

        @Override
        public List<Elsewhere.Game> take(int most) throws InterruptedException {
            return takeOrEnd(most, elsewhere::canPlay);
        }

        @Override
        public void play(List<Elsewhere.Game> games) throws InterruptedException {
            LeagueRun.this.play(games, elsewhere::play);
        }

        @Override
        public void waits() {
            synchronized (LeagueRun.this) {
                ended |= underWay == 0 && (isAtEnd() || takeNow(task -> false) == null && isNothingLeft());
                lookWhetherAnyoneCanPlay();
            }
        }

        @Override
        public void fail(RuntimeException problem) {
            stop("a game of another machine: " + problem);
        }
    }

    /** Player of games. */
    private interface Player {
        /** As {@link Elsewhere#play}. */
        List<List<StoredGame>> play(List<Elsewhere.Game> games) throws InterruptedException;
    }

    private synchronized List<Elsewhere.Game> takeOrEnd(int most, Predicate<List<Member>> can)
            throws InterruptedException {
        List<Elsewhere.Game> games = take(most, can);
        ended |= games.isEmpty();
        return games;
    }

    /** Plays games that were taken; whether there may be more. */
    private boolean play(List<Elsewhere.Game> games, Player player) throws InterruptedException {
        List<List<StoredGame>> played = Collections.nCopies(games.size(), null);
        String problem = null;
        try {
            played = player.play(games);
        } catch (InputException failed) {
            problem = failed.getMessage();
        }
        List<StoredGame> over = new ArrayList<>();
        boolean more;
        synchronized (this) {
            if (problem != null) {
                stop(problem);
            }
            for (int k = 0; k < games.size(); k++) {
                over.addAll(handOver(games.get(k), played.get(k)));
            }
            notifyAll();
            more = !brokenOff && stopped == null;
        }
        over.forEach(listener);
        return more;
    }

    /**
     * Hands a game over to be stored, or back to the schedule if it cannot count.
     *
     * @param attempts {@code null} if it has to be played once more
     * @return those that will be stored
     */
    private List<StoredGame> handOver(Elsewhere.Game game, List<StoredGame> attempts) throws InterruptedException {
        underWay--;
        boolean changed = watch.isChanged(game.members());
        boolean none = attempts == null || elsewhere != null
            && attempts.stream().anyMatch(attempt -> !elsewhere.isTrusted(attempt.machine()));
        if (brokenOff || changed || none) {
            if (attempts != null) {
                attempts.forEach(attempt -> KeptGames.remove(folder, attempt));
            }
            schedule.dropped(game.task());
            if (changed) {
                watch.lookSoon();
            }
            return List.of();
        }
        results.add(game.members(), attempts);
        schedule.over(game.task(), attempts.get(attempts.size() - 1).failed());
        handed += attempts.size();
        if (!writer.add(attempts)) {
            stop(writer.problem().getMessage());
            return List.of();
        }
        return attempts;
    }

    /** The next games, one if there is any, and more as long as none has to be waited for; none at the end. */
    private List<Elsewhere.Game> take(int most, Predicate<List<Member>> can) throws InterruptedException {
        List<Elsewhere.Game> games = new ArrayList<>();
        List<Member> bots = new ArrayList<>();
        Predicate<Schedule.Task> fits = task -> {
            List<Member> all = new ArrayList<>(bots);
            all.addAll(members(task));
            return can.test(all);
        };
        for (Schedule.Task task = take(fits); task != null; task = games.size() < most ? takeNow(fits) : null) {
            underWay++;
            bots.addAll(members(task));
            games.add(new Elsewhere.Game(task, roster.settings(), members(task), forgiven.first(task)));
        }
        return games;
    }

    private List<Member> members(Schedule.Task task) {
        return Arrays.stream(task.lineup()).mapToObj(members::get).toList();
    }

    /** The next game, or {@code null} at the end. */
    private Schedule.Task take(Predicate<Schedule.Task> can) throws InterruptedException {
        for (;;) {
            if (isAtEnd()) {
                return null;
            }
            Schedule.Task task = takeNow(can);
            if (task == null && underWay == 0 && schedule.active().size() < Math.max(1, play.season().players())) {
                stop("found " + TextFormat.count(schedule.active().size(), "bot") + " that is not paused, expected at "
                    + "least " + Math.max(1, play.season().players()));
            }
            if (task != null || isNothingLeft()) {
                return task;
            }
            if (elsewhere != null && underWay > 0) {
                elsewhere.hurry();
            }
            lookWhetherAnyoneCanPlay();
            wait(WAIT_MS);
        }
    }

    /** Ends the run where games wait that none of the machines can play, and says if they wait for a machine. */
    private void lookWhetherAnyoneCanPlay() {
        if (underWay > 0 || watch.isPaused() || isAtEnd()) {
            standstill.moves();
            return;
        }
        standstill.look(schedule.waiting(limits.games()).stream().map(this::members).toList(), elsewhere,
            System.nanoTime()).ifPresent(this::stop);
    }

    /** True if nothing is under way and there is nothing left to play. */
    private boolean isNothingLeft() {
        return underWay == 0 && !watch.isPaused() && !schedule.isLeft(limits.games());
    }

    private boolean isAtEnd() {
        return brokenOff || stopped != null || writer.problem() != null
            || end != Long.MAX_VALUE && System.nanoTime() - end >= 0;
    }

    /** The next game, or {@code null} if there is none before others are over. */
    private Schedule.Task takeNow(Predicate<Schedule.Task> can) {
        watch.look(roster, results.known() != null, this::use);
        Schedule.Task task = watch.isPaused() || isAtEnd() ? null : schedule.next(limits.games(), can);
        while (task != null) {
            byte[] name = play.name(task, members(task), forgiven.first(task));
            if (!store.has(name)) {
                return task;
            }
            store.adopt(name, task.decision());
            schedule.over(task, results.addStored(store, play, task, members(task)));
            task = schedule.next(limits.games(), can);
        }
        return null;
    }

    /**
     * Sets the games of a machine aside: they stay, but do not count, and are played again.
     *
     * @param machine how the texts begin that say where its games were played
     * @param why     is noted with each
     * @return how many counted
     */
    public synchronized int setAside(String machine, String why) throws InterruptedException {
        waitUntilStored();
        int games = 0;
        for (AsideGames.SetAside game : new AsideGames(store).setAside(season, machine, why)) {
            int[] lineup = GameQueries.lineup(game.lineup());
            games++;
            if (game.decision() >= 0) {
                schedule.again(new Schedule.Task(game.decision(), game.seed(), lineup));
            }
        }
        notifyAll();
        return games;
    }

    /** Games of a machine do not count until {@link #restore}; they are not played again. @return how many */
    public synchronized int suspend(String machine, String why) throws InterruptedException {
        waitUntilStored();
        return new AsideGames(store).suspend(machine, why);
    }

    /** Suspended games of a machine count again. @return how many */
    public synchronized int restore(String machine) {
        return new AsideGames(store).restore(machine);
    }

    private void waitUntilStored() throws InterruptedException {
        while (writer.stored() < handed && writer.problem() == null) {
            wait(1);
        }
    }

    private synchronized void stop(String why) {
        stopped = stopped == null ? why : stopped;
        notifyAll();
    }

    /**
     * Breaks it off, from any thread: games that are under way do not count; those that are over are stored.
     *
     * @return how many were under way
     */
    public int breakOff() {
        int games;
        synchronized (this) {
            brokenOff = true;
            games = underWay;
            notifyAll();
        }
        writer.close();
        return games;
    }

    /** Returns why it ended before its time, or {@code null}. */
    public synchronized String stopped() {
        return stopped;
    }

    /** The bots that play now. */
    public synchronized Roster roster() {
        return roster;
    }

    /** Returns how many games the schedule has had, in this run and before. */
    public synchronized long games() {
        return schedule.games() - underWay;
    }

    /** Returns how many games are under way, here and elsewhere. */
    public synchronized int underWay() {
        return underWay;
    }

    /** Returns how many decisions the schedule is ahead of its first game that is not over; its lag is the most. */
    public synchronized int ahead() {
        return schedule.ahead();
    }

    /** Returns how many have been stored in this run, attempts included. */
    public long stored() {
        return writer.stored();
    }
}
