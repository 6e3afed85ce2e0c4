package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.function.ToIntFunction;
import steward.contest.seeds.Seeds;

/**
 * Order of all games of a season, made of numbered decisions. Each decision is made once; a restarted run finds the
 * earlier decisions and plays their missing games. A decision is made only when all decisions at least {@code lag} back
 * are over, so that the results it uses do not depend on the number of threads. Its games begin after it is stored.
 *
 * <p>Not thread-safe. Over 400 lines, because all that happens to a game changes the same rows.
 */
public final class Schedule {

    private final Seeds seeds;
    private final int players;
    private final int lag;
    private final PausedBots pauses;
    private final Consumer<Integer> pauseListener;
    /** Decisions that lack games, by number. */
    private final TreeMap<Integer, Row> rows = new TreeMap<>();
    /** Decisions with games that wait or are under way, by number. */
    private final TreeMap<Integer, Row> open = new TreeMap<>();
    private final GroupSeeds groupSeeds;
    /** Decisions by group, but for those that were dropped before they had a game. */
    private final Map<List<Integer>, Integer> made = new LinkedHashMap<>();
    private final List<Decision> news = new ArrayList<>();
    private final Map<Integer, Boolean> marks = new HashMap<>();

    /** Lineups of each group, for decisions of earlier runs. */
    private final Map<List<Integer>, List<int[]>> rotations = new HashMap<>();

    /** Versions that may play, paused ones included. */
    private Collection<Integer> roster;
    private Function<List<Integer>, Pairing> make;
    private Set<Integer> paused = Set.of();
    private List<Integer> active = List.of();
    private Set<Integer> playing = Set.of();
    private Pairing pairing;
    private final RepeatedGroups repeated;
    /** Number of decisions on each group, where that is fixed beforehand; or {@code null}. */
    private ToIntFunction<List<Integer>> plan;
    private Predicate<int[]> mayMeet = group -> true;
    private IntPredicate end = number -> false;
    private boolean ended;
    private int next;
    private int waiting;
    private long games;

    /**
     * A game to be played.
     *
     * @param lineup the versions by seat
     */
    public record Task(int decision, long seed, int... lineup) { }

    /** A decision that lacks games. */
    private static final class Row {
        private final int number;
        private final List<Integer> group;
        /** Games that have not begun, by the version on the first seat: some wait, others are held. */
        private final List<Task> left = new ArrayList<>();
        private int waiting;
        private int underWay;
        /** Games that are over or under way. */
        private int begun;
        private boolean dropped;
        /** True if it is counted in {@link Schedule#made}. */
        private boolean isCounted;

        Row(int number, List<Integer> group, int begun) {
            this.number = number;
            this.group = group;
            this.begun = begun;
        }
    }

    /**
     * A schedule in which nothing is decided and nobody plays yet.
     *
     * @param seeds    of the decisions from 0 on; of a list each group plays all
     * @param players  of a game
     * @param lag      in decisions
     * @param roster   versions that will play first: where each plays alone, also in decisions of earlier runs
     * @param pauses   with the games of earlier runs
     * @param listener is told of each version when it is paused
     */
    public Schedule(Seeds seeds, int players, int lag, Collection<Integer> roster, PausedBots pauses,
                    Consumer<Integer> listener) {
        this.seeds = seeds;
        groupSeeds = new GroupSeeds(seeds);
        this.players = players;
        this.lag = lag;
        this.roster = List.copyOf(roster);
        this.pauses = pauses;
        pauseListener = listener;
        repeated = new RepeatedGroups(players == 1);
    }

    /**
     * Takes a decision of an earlier run, after those before it; none of its games has begun until {@link #over(int,
     * int...)}.
     */
    public void made(Decision decision, boolean dropped) {
        Row row = new Row(decision.number(), players == 1 ? List.of() : decision.group(), 0);
        row.dropped = dropped;
        lineups(decision).forEach(lineup -> row.left.add(new Task(row.number, decision.seed(), lineup)));
        rows.put(row.number, row);
        groupSeeds.decided(row.group, decision.seed());
        next = row.number + 1;
    }

    private List<int[]> lineups(Decision decision) {
        if (players > 1) {
            return rotations.computeIfAbsent(decision.group(), group -> Lineups.rotations(versions(group)));
        }
        Set<Integer> all = new TreeSet<>(roster);
        decision.paused().stream().filter(version -> !pauses.isResumed(version, decision.number()))
            .forEach(all::remove);
        all.addAll(decision.group());
        return all.stream().map(version -> new int[] {version}).toList();
    }

    /** A game of an earlier run is over; its decision is there. */
    public void over(int decision, int... lineup) {
        Row row = rows.get(decision);
        boolean isNew = row != null && row.left.removeIf(task -> Arrays.equals(task.lineup(), lineup));
        games += isNew || players == 1 ? 1 : 0;        // alone, one that plays no more may have come later
        if (isNew) {
            row.begun++;
            if (row.left.isEmpty()) {
                rows.remove(decision);
                made.merge(row.group, 1, Integer::sum);
            }
        }
    }

    /**
     * Sets the versions that play from now on. Games that were decided on and not begun are held while one of theirs
     * plays no more.
     *
     * @param versions in any order
     * @param maker    makes a pairing of them
     */
    public void play(Collection<Integer> versions, Function<List<Integer>, Pairing> maker) {
        Set<Integer> before = paused;
        roster = List.copyOf(versions);
        make = maker;
        ended = false;
        pause(Set.of());
        int known = Math.min(next, firstOpen() + lag - 1);             // all that are lag back are over
        Set<Integer> found = new TreeSet<>();
        roster.stream().filter(version -> pauses.at(version, known) == PausedBots.State.PAUSED).forEach(found::add);
        if (!found.isEmpty()) {
            pause(found);
        }
        tell(before);
    }

    /** Tells of the versions that have been paused since others were. */
    private void tell(Set<Integer> before) {
        paused.stream().filter(version -> !before.contains(version)).forEach(pauseListener);
    }

    /** Plays without some: games of these are held. */
    private void pause(Set<Integer> found) {
        rows.values().forEach(row -> expect(row, false));
        paused = found;
        active = roster.stream().filter(version -> !paused.contains(version)).sorted().toList();
        playing = Set.copyOf(active);
        rows.values().forEach(row -> expect(row, true));
        pairing = null;
        List.copyOf(rows.values()).forEach(this::note);
        if (players > 1 && active.size() >= players) {
            pairing = make.apply(active);
            made.forEach((group, times) -> pairing.made(times, versions(group)));
        }
    }

    private static int[] versions(List<Integer> group) {
        return group.stream().mapToInt(version -> version).toArray();
    }

    /** True if a game that has not begun waits; it is held as long as one of its bots does not play. */
    private boolean waits(Task task) {
        return Arrays.stream(task.lineup()).allMatch(playing::contains);
    }

    /** Counts the games of a decision that wait, or no more. */
    private void expect(Row row, boolean is) {
        row.left.stream().filter(this::waits).forEach(task -> {
            row.waiting += is ? 1 : -1;
            waiting += is ? 1 : -1;
            pauses.expect(task, is);
        });
    }

    /** Notes what has become of a decision: whether it is open, dropped, among those that were made. */
    private void note(Row row) {
        boolean isOpen = row.underWay + row.waiting > 0;
        if (isOpen) {
            open.put(row.number, row);
        } else {
            open.remove(row.number);
        }
        if (isOpen || !row.left.isEmpty()) {
            rows.put(row.number, row);
        } else {
            rows.remove(row.number);
        }
        if (row.dropped == (row.left.size() == row.waiting)) {
            row.dropped = !row.dropped;
            if (marks.remove(row.number) == null) {    // twice is as it was
                marks.put(row.number, row.dropped);
            }
        }
        boolean counts = row.begun > 0 || !row.dropped;
        if (counts != row.isCounted) {
            row.isCounted = counts;
            made.merge(row.group, counts ? 1 : -1, Integer::sum);
            if (pairing != null) {
                pairing.made(counts ? 1 : -1, versions(row.group));
            }
        }
    }

    /** The versions that play and are not paused, ascending. */
    public List<Integer> active() {
        return active;
    }

    /** Pauses bots that are to be paused from the next decision on; false if games that are not over decide that. */
    private boolean pause() {
        Set<Integer> found = new TreeSet<>();
        for (int version : roster) {
            PausedBots.State state = pauses.at(version, next);
            if (state == PausedBots.State.OPEN) {
                return false;
            }
            if (state == PausedBots.State.PAUSED) {
                found.add(version);
            }
        }
        if (!found.equals(paused)) {
            Set<Integer> before = paused;
            pause(found);
            tell(before);
        }
        return true;
    }

    /**
     * Decides on each group as often as a plan says, also where its games are repeats; after {@link #play}.
     *
     * @param maker makes the plan from the decisions by group so far: the number of decisions in all, those of earlier
     *              runs included, on each group of versions, ascending; where each plays alone, on no version
     */
    public void following(Function<Map<List<Integer>, Integer>, ToIntFunction<List<Integer>>> maker) {
        plan = maker.apply(Collections.unmodifiableMap(made));
    }

    /** The groups whose games only repeat earlier ones: without a plan they are not asked for more. */
    public RepeatedGroups repeated() {
        return repeated;
    }

    /** Says which versions may play together, ascending. */
    public void meeting(Predicate<int[]> versions) {
        mayMeet = versions;
    }

    private boolean isWanted(int... group) {
        return isNew(group) && left(Lineups.group(players, group)) > 0;
    }

    private boolean isNew(int... group) {
        return mayMeet.test(group) && (plan != null || !repeated.isRepeated(group));
    }

    /** Returns how often a group may still be decided on: by the plan, and by its seeds. */
    private int left(List<Integer> group) {
        int seeds = groupSeeds.left(group);
        return plan == null ? seeds : Math.max(0, Math.min(plan.applyAsInt(group) - made.getOrDefault(group, 0),
            seeds));
    }

    /** Number of decisions of earlier runs on seeds that are not in the list, as it was another one then. */
    public int unlisted() {
        return groupSeeds.others();
    }

    /** Number of games that the plan has still to come; before the first is given out. */
    public long planned() {
        return waiting + (players == 1 ? (long) active.size() * left(List.of())
            : RoundOrder.groups(active, players, -1).stream().filter(mayMeet)
                .mapToLong(group -> (long) players * left(Lineups.group(players, group))).sum());
    }

    /** True if it has ended since all groups only repeat games or, if listed, have played all seeds of a list. */
    public boolean isExhausted(boolean listed) {
        return ended && plan == null && (players == 1 ? !isWanted() && listed == isNew() : pairing != null
            && pairing.choose(this::isWanted) == null && listed == (pairing.choose(this::isNew) != null));
    }

    /** Ends it before the first decision of which this is true; each is asked about when it is due. */
    public void until(IntPredicate isEnd) {
        end = isEnd;
    }

    /** Returns how many games of the schedule have been played or given out. */
    public long games() {
        return games;
    }

    /**
     * Makes the decisions that can be made, while there are few games.
     *
     * @param most  games in all
     * @param ahead that wait then, if there are so many
     * @return what is new, to be stored before games of it begin
     */
    public Decision.News decide(long most, int ahead) {
        boolean more = true;
        while (more && waiting < ahead && !ended && games + waiting < most && firstOpen() > next - lag) {
            more = pause() && active.size() >= players && decide();
        }
        Decision.News found = news.isEmpty() && marks.isEmpty() ? Decision.News.NONE : new Decision.News(news, marks);
        news.clear();
        marks.clear();
        return found;
    }

    private boolean decide() {
        repeated.goTo(next - lag + 1);
        int[] group = end.test(next) ? null : players > 1 ? choose() : isWanted() ? versions(active) : null;
        ended = group == null;
        if (!ended) {
            Decision decision = new Decision(next, groupSeeds.next(Lineups.group(players, group), next),
                Arrays.stream(group).boxed().toList(), List.copyOf(paused));
            made(decision, false);
            news.add(decision);
            Row row = rows.get(decision.number());
            expect(row, true);
            note(row);
        }
        return !ended;
    }

    private int[] choose() {
        pairing.next(next);
        return pairing.choose(this::isWanted);
    }

    /**
     * The next game; {@code null} if there is none before others are over, or before decisions are made.
     *
     * @param most  games in all
     * @param takes whether a game may be taken: of those only that will be played in any case
     */
    public Task next(long most, Predicate<Task> takes) {
        long left = most - games;
        for (Row row : open.values()) {
            for (Task task : row.left) {
                if (waits(task) && left-- <= 0) {
                    return null;
                }
                if (waits(task) && takes.test(task)) {
                    begin(row, task);
                    return task;
                }
            }
        }
        return null;
    }

    private void begin(Row row, Task task) {
        row.left.remove(task);
        row.waiting--;
        waiting--;
        row.underWay++;
        row.begun++;
        games++;
        note(row);
    }

    /** The first decision of which a game is under way or not begun; that after the last one if there is none. */
    private int firstOpen() {
        return open.isEmpty() ? next : open.firstKey();
    }

    /** Returns how many decisions have been made since the first one of which a game is not over. */
    public int ahead() {
        return next - firstOpen();
    }

    /**
     * Returns the games that have been decided on and are not begun.
     *
     * @param most games in all
     */
    public List<Task> waiting(long most) {
        return open.values().stream().flatMap(row -> row.left.stream()).filter(this::waits)
            .limit(Math.max(0, most - games)).toList();
    }

    /**
     * A game is over, or will not be.
     *
     * @param failed by seat, whether the bot failed; nothing where there is no result
     */
    public void over(Task task, boolean... failed) {
        pauses.expect(task, false);
        for (int seat = 0; seat < failed.length; seat++) {
            pauses.over(task.decision(), task.lineup()[seat], failed[seat]);
        }
        Row row = rows.get(task.decision());
        row.underWay--;
        note(row);
    }

    /** A game that was given out is to be played again, with the bots as they are now. */
    public void dropped(Task task) {
        over(task);
        again(task);
    }

    /** A game that was over is to be played again: what came of it is not believed any more. */
    public void again(Task task) {
        Row row = rows.computeIfAbsent(task.decision(), number -> {
            Row whole = new Row(number, Lineups.group(players, task.lineup()), Short.MAX_VALUE);
            whole.isCounted = true;
            return whole;
        });
        games--;
        row.begun--;
        expect(row, false);
        row.left.add(task);
        row.left.sort(Comparator.comparingInt(each -> each.lineup()[0]));
        expect(row, true);
        note(row);
    }
}
