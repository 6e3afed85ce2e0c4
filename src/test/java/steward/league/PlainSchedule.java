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

/**
 * A round robin as one would write it without a thought for speed: it keeps every game, looks at one decision after the
 * other, and counts all groups anew for each choice. {@link Schedule} has to give the same games.
 */
final class PlainSchedule {

    private final long firstSeed;
    private final int players;
    private final int lag;
    private final Map<Integer, List<int[]>> stored = new TreeMap<>();
    private final List<List<Integer>> made = new ArrayList<>();
    private final Map<Integer, Integer> open = new TreeMap<>();
    private final Deque<Schedule.Task> waiting = new ArrayDeque<>();
    private List<Integer> active = List.of();
    private int next;
    private long games;

    PlainSchedule(long firstSeed, int players, int lag) {
        this.firstSeed = firstSeed;
        this.players = players;
        this.lag = lag;
    }

    int lag() {
        return lag;
    }

    long games() {
        return games;
    }

    void stored(int decision, int... lineup) {
        stored.computeIfAbsent(decision, number -> new ArrayList<>()).add(lineup);
    }

    void play(Collection<Integer> versions) {
        active = versions.stream().sorted().toList();
        waiting.removeIf(task -> !isPlayable(task.lineup()));
    }

    private boolean isPlayable(int... lineup) {
        return Arrays.stream(lineup).allMatch(active::contains);
    }

    Schedule.Task next(long most) {
        while (waiting.isEmpty()) {
            boolean blocked = open.keySet().stream().anyMatch(number -> number <= next - lag);
            if (games >= most || blocked) {
                return null;
            }
            decide();
        }
        if (games >= most) {
            return null;
        }
        Schedule.Task task = waiting.remove();
        games++;
        open.merge(task.decision(), 1, Integer::sum);
        return task;
    }

    private void decide() {
        int number = next++;
        List<int[]> done = stored.getOrDefault(number, List.of());
        games += done.size();
        List<int[]> lineups = new ArrayList<>();
        if (players == 1) {
            active.forEach(version -> lineups.add(new int[] {version}));
        } else {
            List<Integer> group = done.isEmpty() ? leastPlayed()
                : Arrays.stream(done.get(0)).sorted().boxed().toList();
            made.add(group);
            lineups.addAll(Lineups.rotations(group.stream().mapToInt(version -> version).toArray()));
        }
        for (int[] lineup : lineups) {
            if (isPlayable(lineup) && done.stream().noneMatch(each -> Arrays.equals(each, lineup))) {
                waiting.add(new Schedule.Task(number, firstSeed + number, lineup));
            }
        }
    }

    /** The group of those that play which was decided on least, the first of several. */
    private List<Integer> leastPlayed() {
        Map<List<Integer>, Integer> counts = new HashMap<>();
        made.forEach(group -> counts.merge(group, 1, Integer::sum));
        List<Integer> best = null;
        for (int[] each : RoundOrder.groups(active, players, -1)) {
            List<Integer> group = Arrays.stream(each).boxed().toList();
            if (best == null || counts.getOrDefault(group, 0) < counts.getOrDefault(best, 0)) {
                best = group;
            }
        }
        return best;
    }

    void over(Schedule.Task task) {
        open.computeIfPresent(task.decision(), (number, count) -> count == 1 ? null : count - 1);
    }

    void dropped(Schedule.Task task) {
        over(task);
        games--;
        if (isPlayable(task.lineup())) {
            waiting.addFirst(task);
        }
    }
}
