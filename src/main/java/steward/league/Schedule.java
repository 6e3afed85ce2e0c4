package steward.league;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;

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
    private final Map<Integer, List<int[]>> stored = new HashMap<>();
    /** Decisions in earlier form, for a pairing that is made anew when the bots have changed. */
    private final List<int[]> made = new ArrayList<>();
    /** Games that are under way, by decision. */
    private final TreeMap<Integer, Integer> open = new TreeMap<>();
    private final Deque<Task> waiting = new ArrayDeque<>();

    private List<Integer> active = List.of();
    private Pairing pairing;
    private int next;
    private int last = -1;
    private long games;

    /**
     * A game to be played.
     *
     * @param decision its number
     * @param seed     its seed
     * @param lineup   the versions by seat
     */
    public record Task(int decision, long seed, int... lineup) {
    }

    /**
     * @param firstSeed of decision 0
     * @param players   of a game
     * @param lag       in decisions
     */
    public Schedule(long firstSeed, int players, int lag) {
        this.firstSeed = firstSeed;
        this.players = players;
        this.lag = lag;
    }

    /** Tells it a game of an earlier run; before the first {@link #next}. */
    public void stored(int decision, int... lineup) {
        stored.computeIfAbsent(decision, number -> new ArrayList<>(2)).add(lineup);
        last = Math.max(last, decision);
    }

    /**
     * Who plays from now on. Games that were decided and not begun are dropped if one of theirs plays no more.
     *
     * @param versions in any order
     * @param make     makes a pairing of them
     */
    public void play(Collection<Integer> versions, Function<List<Integer>, Pairing> make) {
        active = versions.stream().sorted().toList();
        if (players > 1) {
            pairing = make.apply(active);
            made.forEach(pairing::made);
        }
        waiting.removeIf(task -> Arrays.stream(task.lineup()).anyMatch(version -> !active.contains(version)));
    }

    /** How many games of the schedule have been played or given out. */
    public long games() {
        return games;
    }

    /**
     * The next game; {@code null} if games that are under way have to end before it is known.
     *
     * @param most games in all
     */
    public Task next(long most) {
        while (waiting.isEmpty()) {
            if (games >= most || !open.isEmpty() && open.firstKey() <= next - lag) {
                return null;
            }
            if (players == 1 && next > last && active.isEmpty()) {
                return null;
            }
            decide(most);
        }
        if (games >= most) {
            return null;
        }
        Task task = waiting.remove();
        games++;
        open.merge(task.decision(), 1, Integer::sum);
        return task;
    }

    private void decide(long most) {
        int number = next++;
        List<int[]> done = stored.getOrDefault(number, List.of());
        stored.remove(number);
        List<int[]> lineups;
        if (players == 1) {
            lineups = active.stream().map(version -> new int[] {version}).toList();
        } else {
            int[] versions = done.isEmpty() ? pairing.choose() : Decision.sorted(done.get(0));
            made.add(versions);
            pairing.made(versions);
            lineups = Decision.rotations(versions);
        }
        games += done.size();
        if (done.size() == lineups.size() && players > 1) {
            return;
        }
        for (int[] lineup : lineups) {
            boolean playable = Arrays.stream(lineup).allMatch(active::contains);
            if (playable && done.stream().noneMatch(each -> Arrays.equals(each, lineup))) {
                waiting.add(new Task(number, firstSeed + number, lineup));
            }
        }
    }

    /** A game is over, or will not be. */
    public void over(Task task) {
        open.computeIfPresent(task.decision(), (number, count) -> count == 1 ? null : count - 1);
    }

    /** A game that was over is to be played again: what came of it is not believed any more. */
    public void again(Task task) {
        games--;
        if (Arrays.stream(task.lineup()).allMatch(active::contains)) {
            waiting.addFirst(task);
        }
    }

    /** A game that was given out is to be played again, with the bots as they are now. */
    public void dropped(Task task) {
        over(task);
        games--;
        if (Arrays.stream(task.lineup()).allMatch(active::contains)) {
            waiting.addFirst(task);
        }
    }
}
