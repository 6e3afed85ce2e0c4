package steward.league.play;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import steward.contest.Contest;
import steward.contest.WorkerThreads;
import steward.files.InputException;
import steward.league.LeagueSettings;
import steward.league.Pairing;
import steward.league.PausedBots;
import steward.league.Schedule;
import steward.league.StoredGame;
import steward.league.pairing.AdaptivePairing;
import steward.league.pairing.KnownResults;
import steward.league.pairing.LeagueEnd;
import steward.league.pairing.Looks;
import steward.league.pairing.StopRule;
import steward.league.play.Roster.Member;
import steward.league.rating.Ratings;
import steward.league.store.AsideGames;
import steward.league.store.GameQueries;
import steward.league.store.GameWriter;
import steward.text.TextFormat;

/**
 * One run of a league: its threads take games from the schedule, play them, and pass them on to be stored. Between
 * games league.json is read anew ({@link RosterWatch}).
 *
 * <p>Over 400 lines, because the threads and what ends them read the same fields.
 */
public final class LeagueRun {

    /** How long a thread sleeps that has to wait for other games, in milliseconds. */
    static final long WAIT_MS = 100;

    private final OpenSeason season;
    private final GameQueries queries;
    private final AsideGames aside;
    private final GameWriter writer;
    private final GamePlay play;
    private final RosterWatch watch;
    private final Schedule schedule;
    private final Limits limits;
    private final Rules rules;
    private final Consumer<String> teller;
    private final Consumer<StoredGame> listener;
    private final long end;
    /** Other machines, or {@code null}. */
    private final RemoteMachines remote;
    private final LeagueEnd leagueEnd;

    /** Guarded by this, as is all below. */
    private final PausedBots pauses;
    /** Results from which a pairing or an end learns how strong each bot is; {@code null} if nobody asks. */
    private final KnownResults known;
    private final IdleWatch idle;
    private Roster roster;
    private Map<Integer, Member> members;
    /** Games that wait, if there are so many, so that nobody waits for decisions to be stored. */
    private int ahead = 1;
    private int underWay;
    private boolean brokenOff;
    private boolean ended;
    private String stopped;
    private long handed;

    /**
     * Limits of a run.
     *
     * @param threads games at the same time
     * @param games   that the schedule has in all when the run ends; {@code Long.MAX_VALUE} for no end
     * @param nanos   after which no game is begun; {@code Long.MAX_VALUE} for no end
     */
    public record Limits(int threads, long games, long nanos) { }

    /** Makes a plan for bots that play from the decisions by group so far. */
    public interface Planner extends BiFunction<Roster, Map<List<Integer>, Integer>,
        ToIntFunction<List<Integer>>> { }

    /**
     * Rules by which a run decides.
     *
     * @param end        ends the run when enough is known
     * @param pauseAfter how many failed games in a row pause a bot; 0 for never
     * @param planner    plans the games to be played and no others, or {@code null}
     */
    public record Rules(StopRule end, int pauseAfter, Planner planner) {

        public static final Rules NONE = new Rules(StopRule.NONE, 0, null);
    }

    /**
     * A run that is to begin.
     *
     * @param remote    other machines that play, too, or {@code null}
     * @param machine   what is noted with each game
     * @param teller    is told what happens, by any thread
     * @param listener  is told of each game that is handed over to be stored, by any thread
     */
    public LeagueRun(OpenSeason season, Contest contest, RosterReader reader, Roster roster, Limits limits, Rules rules,
                     RemoteMachines remote, String machine, Consumer<String> teller, Consumer<StoredGame> listener) {
        this.season = season;
        this.limits = limits;
        this.rules = rules;
        this.remote = remote;
        this.teller = teller;
        this.listener = listener;
        idle = new IdleWatch(limits.threads() > 0, teller);
        LeagueSettings settings = roster.settings();
        int players = season.season().players();
        play = new GamePlay(season.season(), contest, new KeptGames(season.folder()), machine,
            System::currentTimeMillis);
        queries = season.queries();
        aside = new AsideGames(season.store());
        int next = queries.nextDecision();
        known = settings.adaptive() && players > 1 || rules.end().isAny()
            ? queries.known(Looks.settled(next, settings.lag())) : null;
        pauses = new PausedBots(rules.pauseAfter(), settings.lag(), next);
        usePauses(roster);
        schedule = new Schedule(season.folder().starts(settings), players, settings.lag(), roster.versions(), pauses,
            this::tellPaused);
        queries.tell(schedule);
        if (schedule.unlisted() > 0) {
            teller.accept(season.folder().path().resolve(settings.seedFile()) + " is another list than before: "
                + TextFormat.count(schedule.unlisted(), "decision") + " of earlier runs have seeds that it lacks; "
                + "their games stay in the table, and every group plays what it has not played of this list. For a "
                + "table of one list put the old one back, or begin a new league");
        }
        leagueEnd = new LeagueEnd(rules.end(), known, settings.lag(), schedule::active, (one, other) ->
            this.roster.isPair(players, one, other));
        schedule.until(leagueEnd);
        watch = new RosterWatch(season.folder(), reader, settings, teller);
        use(roster);
        end = limits.nanos() == Long.MAX_VALUE ? Long.MAX_VALUE : System.nanoTime() + limits.nanos();
        writer = new GameWriter(season.store(), season.number(), next);
    }

    private void use(Roster next) {
        season.folder().named(() -> next.checked(season.season().players()));
        roster = next;
        members = next.byVersion();
        usePauses(next);
        schedule.meeting(next.meeting());
        schedule.play(next.versions(), versions -> pairing(versions, next));
        if (rules.planner() != null) {
            schedule.following(decided -> rules.planner().apply(next, decided));
        }
        next.members().stream().map(Member::version).filter(version -> version.paused()
            && schedule.active().contains(version.id())).forEach(version -> season.store().pause(version.id(), false));
    }

    private void usePauses(Roster next) {
        next.members().forEach(member -> pauses.use(member.version().id(), member.bot().resumed(),
            member.unsteady() != null, taker -> queries.failures(member.version().id(), taker)));
    }

    private void tellPaused(int version) {
        season.store().pause(version, true);
        teller.accept(members.get(version).whyPaused(rules.pauseAfter(), season.folder().path()));
    }

    private Pairing pairing(List<Integer> versions, Roster next) {
        int players = season.season().players();
        LeagueSettings settings = next.settings();
        if (settings.adaptive()) {
            return new AdaptivePairing(versions, players, settings.lag(), rules.end(),
                before -> Ratings.of(known.before(before), versions));
        }
        return settings.gauntlet() == null ? Pairing.roundRobin(versions, players)
            : Pairing.gauntlet(versions, players, next.versionOf(settings.gauntlet()).orElseThrow());
    }

    /** Number of games that a plan has still to come; before {@link #play}. */
    public synchronized long planned() {
        return schedule.planned();
    }

    /** The rule that ended the run with what was known, or {@code null}. */
    public synchronized LeagueEnd ended() {
        return leagueEnd.met() != null ? leagueEnd : null;
    }

    /** True if the run has ended since bots only repeat games, or, if listed, have played all seeds of the list. */
    public synchronized boolean isExhausted(boolean listed) {
        return schedule.isExhausted(listed);
    }

    /** Returns the versions that play and are not paused. */
    public synchronized List<Integer> active() {
        return schedule.active();
    }

    /** Plays until an end is reached. Call once. */
    public void play() throws InterruptedException {
        int others = remote == null ? 0 : 1;
        writer.start();                                // not before: a run that is refused leaves no thread
        try {
            WorkerThreads.run("league", limits.threads() + others, thread -> thread < limits.threads() ? this::playHere
                : new RemotePlay(this, remote)::play);
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
            List<RemoteMachines.Game> games = take(1, IdleWatch::isForHere);
            more = !games.isEmpty() && play(games, one -> List.of(play.play(one.get(0))));
        }
        return null;
    }

    /** True if no games are begun any more. */
    synchronized boolean isOver() {
        return ended || brokenOff || stopped != null;
    }

    /** Notes that other machines have no place for games. */
    synchronized void hasNoPlace() throws InterruptedException {
        decide();
        ended |= underWay == 0 && isOverNow();
        lookWhetherAnyoneCanPlay();
    }

    /** Player of games. */
    interface Player {
        /** As {@link RemoteMachines#play}. */
        List<List<StoredGame>> play(List<RemoteMachines.Game> games) throws InterruptedException;
    }

    /** Plays games that were taken; whether there may be more. */
    boolean play(List<RemoteMachines.Game> games, Player player) throws InterruptedException {
        List<List<StoredGame>> played = Collections.nCopies(games.size(), null);
        try {
            played = player.play(games);
        } catch (InputException failed) {
            stop(failed.getMessage());
        }
        List<StoredGame> over = new ArrayList<>();
        synchronized (this) {
            for (int k = 0; k < games.size(); k++) {
                over.addAll(handOver(games.get(k), played.get(k)));
            }
            notifyAll();
        }
        over.forEach(listener);
        return !isOver();
    }

    /**
     * Hands a game over to be stored, or back to the schedule if it cannot count.
     *
     * @param attempts {@code null} if it has to be played once more
     * @return those that will be stored
     */
    private List<StoredGame> handOver(RemoteMachines.Game game, List<StoredGame> attempts) throws InterruptedException {
        underWay--;
        boolean changed = watch.isChanged(game.members());
        boolean none = attempts == null || remote != null
            && attempts.stream().anyMatch(attempt -> !remote.isTrusted(attempt.machine()));
        if (brokenOff || changed || none) {
            if (attempts != null) {
                attempts.forEach(attempt -> KeptGames.remove(season.folder(), attempt));
            }
            schedule.dropped(game.task());
            if (changed) {
                watch.lookSoon();
            }
            return List.of();
        }
        over(game.task(), game.members(), attempts.get(attempts.size() - 1));
        handed += attempts.size();
        if (!writer.add(attempts)) {
            stop(writer.problem().getMessage());
            return List.of();
        }
        return attempts;
    }

    /** Takes what a game came to. */
    private void over(Schedule.Task task, List<Member> members, StoredGame game) {
        if (game.isRated()) {
            long transcript = members.stream().anyMatch(member -> member.version().random()) ? 0 : game.transcript();
            schedule.repeated().add(task.decision(), transcript, task.lineup());
            if (known != null) {
                known.add(task.decision(), task.seed(), task.lineup(), game.seats().get(0).score(), transcript,
                    game.seats().stream().mapToInt(StoredGame.StoredSeat::rank).toArray());
            }
        }
        schedule.over(task, game.failed());
    }

    /**
     * Takes the next games, more than one as long as none has to be waited for.
     *
     * @param can whether all of these bots may play together
     * @return none at the end
     */
    synchronized List<RemoteMachines.Game> take(int most, Predicate<List<Member>> can) throws InterruptedException {
        List<RemoteMachines.Game> games = new ArrayList<>();
        List<Member> bots = new ArrayList<>();
        ahead = Math.max(ahead, most);
        while (games.size() < most) {
            decide();
            Schedule.Task task = watch.isPaused() || isAtEnd() ? null : schedule.next(limits.games(), each ->
                writer.isDecided(each.decision()) && can.test(Stream.concat(bots.stream(), members(each).stream())
                    .toList()));
            int attempt = task == null ? 0 : attempt(task);
            if (attempt > 0) {
                bots.addAll(members(task));
                games.add(new RemoteMachines.Game(task, roster.settings(), members(task), attempt));
                underWay++;
            } else if (task == null && (!games.isEmpty() || isOverNow())) {
                break;
            } else if (task == null) {
                waitForGames();
            }
        }
        ended |= games.isEmpty();
        return games;
    }

    private void waitForGames() throws InterruptedException {
        boolean isStoring = schedule.waiting(limits.games()).stream().anyMatch(task ->
            !writer.isDecided(task.decision()));
        if (isStoring) {
            ahead = Math.min(2 * ahead, mostAhead());
        } else if (remote != null && underWay > 0) {
            remote.hurry();
        }
        lookWhetherAnyoneCanPlay();
        wait(isStoring ? 1 : WAIT_MS);
    }

    private int mostAhead() {
        return roster.settings().lag() * season.season().players();
    }

    private List<Member> members(Schedule.Task task) {
        return Arrays.stream(task.lineup()).mapToObj(members::get).toList();
    }

    /** Reads anew what has changed, and makes the decisions that can be made; they are stored before their games. */
    private void decide() throws InterruptedException {
        watch.look(roster, known != null, this::use);
        boolean more = !watch.isPaused() && !isAtEnd();
        writer.add(schedule.decide(more ? limits.games() : 0, ahead));
        int players = season.season().players();
        if (more && underWay == 0 && schedule.games() < limits.games() && schedule.active().size() < players) {
            stop("found " + TextFormat.count(schedule.active().size(), "bot") + " that is not paused, expected at "
                + "least " + players);
        }
    }

    /**
     * Returns the number of a game's next attempt; 0 if it is over, as it was stored before it was decided on: it is
     * one of the schedule now.
     */
    private int attempt(Schedule.Task task) {
        int attempt = 1;
        StoredGame found = queries.game(play.name(task, members(task), attempt));
        while (found != null) {
            if (found.decision() < 0) {
                season.store().adopt(found.name(), task.decision());
            }
            if (found.isOver()) {
                over(task, members(task), found);
                return 0;
            }
            found = queries.game(play.name(task, members(task), ++attempt));
        }
        return attempt;
    }

    /** Ends the run where games wait that none of the machines can play, and says if they wait for a machine. */
    private void lookWhetherAnyoneCanPlay() {
        if (underWay > 0 || watch.isPaused() || isAtEnd()) {
            idle.moves();
            return;
        }
        if (ahead < mostAhead()) {
            ahead = mostAhead();                       // decisions to come may be of bots that can play
            return;
        }
        idle.look(schedule.waiting(limits.games()).stream().map(this::members).toList(), remote,
            System.nanoTime()).ifPresent(this::stop);
    }

    /** True at an end, and if nothing is under way or left to play. */
    private boolean isOverNow() {
        return isAtEnd() || underWay == 0 && !watch.isPaused() && schedule.waiting(limits.games()).isEmpty();
    }

    private boolean isAtEnd() {
        return brokenOff || stopped != null || writer.problem() != null
            || end != Long.MAX_VALUE && System.nanoTime() - end >= 0;
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
        List<StoredGame> games = aside.setAside(queries, season.number(), machine, why);
        games.stream().filter(game -> game.decision() >= 0).forEach(game ->
            schedule.again(new Schedule.Task(game.decision(), game.seed(), game.lineup())));
        notifyAll();
        return games.size();
    }

    /** Games of a machine do not count until {@link #restore}; they are not played again. @return how many */
    public synchronized int suspend(String machine, String why) throws InterruptedException {
        waitUntilStored();
        return aside.suspend(machine, why);
    }

    /** Suspended games of a machine count again. @return how many */
    public synchronized int restore(String machine) {
        return aside.restore(machine);
    }

    private void waitUntilStored() throws InterruptedException {
        while (writer.stored() < handed && writer.problem() == null) {
            wait(1);
        }
    }

    /** Ends the run before its time. */
    synchronized void stop(String why) {
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

    /** Returns how many games are under way, here and on other machines. */
    public synchronized int underWay() {
        return underWay;
    }

    /**
     * Returns how many decisions the schedule is ahead of its first game that is not over: its lag at most, but for
     * games of old decisions that are played late.
     */
    public synchronized int ahead() {
        return schedule.ahead();
    }

    /** Returns how many have been stored in this run, attempts included. */
    public long stored() {
        return writer.stored();
    }
}
