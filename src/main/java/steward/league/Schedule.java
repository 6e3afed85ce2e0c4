package steward.league;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.function.Predicate;

/**
 * The games of a season in their order. Decisions are numbered; a decision that was made in an earlier run is known by
 * its games, and one that has none yet is made again as it was: it follows from those before it. A decision is begun
 * only when all that are {@code lag} or more back are over.
 *
 * <p>Not thread-safe.
 */
public final class Schedule {

    private final long firstSeed;
    private final int players;
    private final int lag;
    private final EarlierGames earlier;
    /** How often each group was decided on, for a pairing that is made anew when the bots have changed. */
    private final Map<List<Integer>, Integer> made = new LinkedHashMap<>();
    /** Decisions by group that the pairing has not been told yet: it need not know until it has to choose. */
    private final Map<List<Integer>, Integer> untold = new LinkedHashMap<>();
    /** Games that are under way, by decision. */
    private final TreeMap<Integer, Integer> open = new TreeMap<>();
    private final Deque<Task> waiting = new ArrayDeque<>();

    private PausedBots pauses;
    private Consumer<Integer> pauseListener = version -> { };
    /** All that may play, those that are paused among them. */
    private Collection<Integer> roster = List.of();
    private Function<List<Integer>, Pairing> make;
    private Set<Integer> paused = Set.of();
    private List<Integer> active = List.of();
    private Pairing pairing;
    private RepeatedGroups repeated;
    /** With a plan: decisions by group, also those of earlier runs that are still to come; {@code null} without. */
    private Map<List<Integer>, Integer> decided;
    private Plan plan;
    private Predicate<int[]> mayMeet = group -> true;
    private IntPredicate end = number -> false;
    private boolean ended;
    private int next;
    private final int last;
    private long games;

    /** Number of decisions on each group, where that is fixed beforehand. */
    public interface Plan {

        /**
         * Returns the number of decisions in all, those of earlier runs included.
         *
         * @param group versions, ascending; where each plays alone, none: it is of all
         */
        int decisions(List<Integer> group);
    }

    /**
     * A game to be played.
     *
     * @param lineup the versions by seat
     */
    public record Task(int decision, long seed, int... lineup) { }

    /**
     * @param firstSeed of decision 0
     * @param players   of a game
     * @param lag       in decisions
     * @param earlier   the games of earlier runs; the schedule's own from now on
     */
    public Schedule(long firstSeed, int players, int lag, EarlierGames earlier) {
        this.firstSeed = firstSeed;
        this.players = players;
        this.lag = lag;
        this.earlier = earlier;
        last = earlier.last();
        repeated = new RepeatedGroups(players == 1);
        pauses = new PausedBots(0, lag, 0);
    }

    /**
     * Pauses bots; before {@link #play}.
     *
     * @param bots     with the games of earlier runs
     * @param listener is told of each version when it is paused
     */
    public void pausing(PausedBots bots, Consumer<Integer> listener) {
        pauses = bots;
        pauseListener = listener;
    }

    /**
     * Who plays from now on. Games that were decided and not begun are dropped if one of theirs plays no more.
     *
     * @param versions in any order
     * @param maker    makes a pairing of them
     */
    public void play(Collection<Integer> versions, Function<List<Integer>, Pairing> maker) {
        roster = List.copyOf(versions);
        make = maker;
        paused = Set.of();
        play();
    }

    private void play() {
        active = roster.stream().filter(version -> !paused.contains(version)).sorted().toList();
        if (players > 1 && active.size() >= players) {
            pairing = make.apply(active);
            earlier.tellWhole(this::made);
            untold.clear();
            untold.putAll(made);
        }
        waiting.removeIf(task -> {
            boolean gone = Arrays.stream(task.lineup()).anyMatch(version -> !active.contains(version));
            if (gone) {
                pauses.forget(task);
            }
            return gone;
        });
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
            paused = found;
            play();
            found.stream().filter(version -> !before.contains(version)).forEach(pauseListener);
        }
        return true;
    }

    /**
     * Decides on each group as often as a plan says, also where its games are repeats; before {@link #play}.
     *
     * @param maker makes the plan from the decisions by group so far
     */
    public void following(Function<Map<List<Integer>, Integer>, Plan> maker) {
        if (decided == null) {
            decided = new HashMap<>();
            int[] before = {-1};
            earlier.each((decision, lineup) -> {
                if (decision != before[0]) {
                    decided.merge(group(lineup), 1, Integer::sum);
                }
                before[0] = decision;
            });
        }
        plan = maker.apply(Collections.unmodifiableMap(decided));
    }

    /** Asks no more for groups whose games only repeat earlier ones; it ends where there are no others. */
    public void without(RepeatedGroups groups) {
        repeated = groups;
    }

    /** Says which versions may play together, ascending; before {@link #play}. */
    public void meeting(Predicate<int[]> versions) {
        mayMeet = versions;
    }

    private boolean isWanted(int... group) {
        if (plan == null) {
            return mayMeet.test(group) && !repeated.isRepeated(group);
        }
        List<Integer> versions = Arrays.stream(group).boxed().toList();
        return mayMeet.test(group) && decided.getOrDefault(versions, 0) < plan.decisions(versions);
    }

    /** Versions of a decision, ascending; where each plays alone, nothing: it is of all. */
    private List<Integer> group(int... lineup) {
        return players == 1 ? List.of() : Arrays.stream(lineup).sorted().boxed().toList();
    }

    /** Number of games that the plan has still to come; before the first is given out. */
    public long planned() {
        long[] left = {0};
        if (players == 1) {
            left[0] = (long) active.size() * Math.max(last + 1, plan.decisions(List.of()));
        } else {
            RoundOrder.groups(active, players, -1).stream().filter(mayMeet).map(this::group)
                .forEach(group -> left[0] += (long) players * Math.max(decided.getOrDefault(group, 0),
                    plan.decisions(group)));
        }
        earlier.each((decision, lineup) ->
            left[0] -= Arrays.stream(lineup).allMatch(active::contains) ? 1 : 0);
        return left[0];
    }

    /** True if, where each plays alone, there is nothing left to decide. */
    private boolean isAloneOver(int number) {
        return plan == null ? repeated.isRepeated() : number >= plan.decisions(List.of());
    }

    /** True if it has ended since all groups only repeat games. */
    public boolean isRepeated() {
        return ended && plan == null && (players == 1 ? repeated.isRepeated()
            : pairing.choose(this::isWanted) == null);
    }

    /** Ends it before the first decision without games of which this is true; each is asked about when it is due. */
    public void until(IntPredicate isEnd) {
        end = isEnd;
    }

    /** Returns how many games of the schedule have been played or given out. */
    public long games() {
        return games;
    }

    /**
     * The next game; {@code null} if games that are under way have to end before it is known.
     *
     * @param most games in all
     */
    public Task next(long most) {
        return next(most, task -> true);
    }

    /**
     * The next game of some; {@code null} also if there are others only that have to be taken before.
     *
     * @param most  games in all
     * @param takes whether a game may be taken
     */
    public Task next(long most, Predicate<Task> takes) {
        Optional<Task> task = first(most, takes);
        while (task.isEmpty()) {
            if (games + waiting.size() >= most || firstOpen() <= next - lag) {
                return null;
            }
            boolean known = players > 1 && earlier.has(next);
            if (ended || !known && (!pause() || active.size() < players || active.isEmpty())) {
                return null;
            }
            decide();
            task = first(most, takes);
        }
        waiting.remove(task.get());
        games++;
        open.merge(task.get().decision(), 1, Integer::sum);
        return task.get();
    }

    /** The first of those that will be played in any case: who passes some by must not put others in their place. */
    private Optional<Task> first(long most, Predicate<Task> takes) {
        return waiting.stream().limit(Math.max(0, most - games)).filter(takes).findFirst();
    }

    /** The first decision of which a game is under way or not begun; that after the last one if there is none. */
    private int firstOpen() {
        int first = open.isEmpty() ? next : open.firstKey();
        for (Task task : waiting) {
            first = Math.min(first, task.decision());
        }
        return first;
    }

    /** Returns how many decisions have been made since the first one of which a game is not over. */
    public int ahead() {
        return next - firstOpen();
    }

    /**
     * True if games have been decided on that are not begun.
     *
     * @param most games in all
     */
    public boolean isLeft(long most) {
        return games < most && !waiting.isEmpty();
    }

    /**
     * Returns the games that have been decided on and are not begun.
     *
     * @param most games in all
     */
    public List<Task> waiting(long most) {
        return waiting.stream().limit(Math.max(0, most - games)).toList();
    }

    private void decide() {
        int number = next++;
        if (players > 1 && earlier.takeWhole(number, players)) {
            games += players;
            return;
        }
        List<int[]> done = earlier.take(number);
        repeated.goTo(number - lag + 1);
        if (done.isEmpty() && number > last && (players == 1 && isAloneOver(number) || end.test(number))) {
            ended = true;
            next--;
            return;
        }
        games += done.size();
        List<int[]> lineups;
        if (players == 1) {
            lineups = active.stream().map(version -> new int[] {version}).toList();
        } else {
            int[] versions = done.isEmpty() ? choose(number) : Lineups.sorted(done.get(0));
            if (versions == null) {
                ended = number > last;             // those before the last one have been decided on already
                next -= ended ? 1 : 0;
                return;
            }
            if (plan != null && done.isEmpty()) {
                decided.merge(group(versions), 1, Integer::sum);
            }
            made(1, versions);
            lineups = Lineups.rotations(versions);
        }
        for (int[] lineup : lineups) {
            boolean playable = Arrays.stream(lineup).allMatch(active::contains);
            if (playable && done.stream().noneMatch(each -> Arrays.equals(each, lineup))) {
                Task task = new Task(number, firstSeed + number, lineup);
                waiting.add(task);
                pauses.expect(task);
            }
        }
    }

    private void made(int times, int... versions) {
        List<Integer> group = Arrays.stream(versions).sorted().boxed().toList();
        made.merge(group, times, Integer::sum);
        untold.merge(group, times, Integer::sum);
    }

    private int[] choose(int number) {
        earlier.tellWhole(this::made);
        untold.forEach((group, times) -> pairing.made(times, group.stream().mapToInt(version -> version).toArray()));
        untold.clear();
        pairing.next(number);
        return pairing.choose(this::isWanted);
    }

    /**
     * A game is over, or will not be.
     *
     * @param failed by seat, whether the bot failed; nothing where there is no result
     */
    public void over(Task task, boolean... failed) {
        pauses.forget(task);
        for (int seat = 0; seat < failed.length; seat++) {
            pauses.over(task.decision(), task.lineup()[seat], failed[seat]);
        }
        open.computeIfPresent(task.decision(), (number, count) -> count == 1 ? null : count - 1);
    }

    /** A game that was over is to be played again: what came of it is not believed any more. */
    public void again(Task task) {
        games--;
        if (Arrays.stream(task.lineup()).allMatch(active::contains)) {
            waiting.addFirst(task);
            pauses.expect(task);
        }
    }

    /** A game that was given out is to be played again, with the bots as they are now. */
    public void dropped(Task task) {
        over(task);
        games--;
        if (Arrays.stream(task.lineup()).allMatch(active::contains)) {
            waiting.addFirst(task);
            pauses.expect(task);
        }
    }
}
