package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * A round robin as one would write it without a thought for speed: it keeps every decision, looks at one after the
 * other, and counts all groups anew for each choice. {@link Schedule} has to give the same games.
 */
final class PlainSchedule {

    private final int players;
    private final int lag;
    private final Map<Integer, Row> rows = new TreeMap<>();
    private Set<Integer> active;
    private int next;
    private long games;

    /** A decision: its games that have not begun, and how many have. */
    private static final class Row {
        private final Set<List<Integer>> left = new HashSet<>();
        private TreeSet<Integer> group = new TreeSet<>();
        private int begun;
        private int underWay;
    }

    PlainSchedule(int players, int lag) {
        this.players = players;
        this.lag = lag;
    }

    int lag() {
        return lag;
    }

    long games() {
        return games;
    }

    /** A game of an earlier run; before {@link #play}. */
    void stored(int decision, int... lineup) {
        Row row = rows.computeIfAbsent(decision, number -> new Row());
        Arrays.stream(lineup).forEach(row.group::add);
        row.begun++;
        row.left.add(list(lineup));                    // until it is known who plays: what has been played
        games++;
        next = Math.max(next, decision + 1);
    }

    void play(Collection<Integer> versions) {
        boolean first = active == null;
        active = new TreeSet<>(versions);
        if (first) {
            rows.values().forEach(row -> {
                Set<List<Integer>> played = Set.copyOf(row.left);
                row.left.clear();
                Set<Integer> all = new TreeSet<>(row.group);
                all.addAll(active);
                row.left.addAll(lineups(players == 1 ? all : row.group));
                row.left.removeAll(played);
            });
        }
    }

    private static List<Integer> list(int... lineup) {
        return Arrays.stream(lineup).boxed().toList();
    }

    private List<List<Integer>> lineups(Collection<Integer> group) {
        return players == 1 ? group.stream().map(List::of).toList()
            : Lineups.rotations(group.stream().mapToInt(version -> version).toArray()).stream().map(PlainSchedule::list)
                .toList();
    }

    private List<List<Integer>> playable(Row row) {
        return row.left.stream().filter(active::containsAll).toList();
    }

    private boolean isOpen(Row row) {
        return row.underWay > 0 || !playable(row).isEmpty();
    }

    /** The games that may be next, all of one decision; none if there is none. */
    Set<String> next(long most) {
        while (rows.values().stream().allMatch(row -> playable(row).isEmpty()) && games < most && rows.entrySet()
                .stream().noneMatch(row -> row.getKey() <= next - lag && isOpen(row.getValue()))) {
            Row row = new Row();
            row.group = new TreeSet<>(players == 1 ? active : leastPlayed());
            row.left.addAll(lineups(row.group));
            rows.put(next++, row);
        }
        Set<String> found = new TreeSet<>();
        rows.forEach((number, row) -> {
            if (found.isEmpty() && games < most) {
                playable(row).forEach(lineup -> found.add(number + " " + lineup));
            }
        });
        return found;
    }

    void begin(Schedule.Task task) {
        Row row = rows.get(task.decision());
        row.left.remove(list(task.lineup()));
        row.begun++;
        row.underWay++;
        games++;
    }

    /** The group of those that play which was decided on least, the first of several. */
    private List<Integer> leastPlayed() {
        Map<List<Integer>, Integer> counts = new HashMap<>();
        rows.values().stream().filter(row -> row.begun > 0 || active.containsAll(row.group))
            .forEach(row -> counts.merge(new ArrayList<>(row.group), 1, Integer::sum));
        List<Integer> best = null;
        for (int[] each : RoundOrder.groups(List.copyOf(active), players, -1)) {
            List<Integer> group = list(each);
            if (best == null || counts.getOrDefault(group, 0) < counts.getOrDefault(best, 0)) {
                best = group;
            }
        }
        return best;
    }

    void over(Schedule.Task task) {
        rows.get(task.decision()).underWay--;
    }

    void dropped(Schedule.Task task) {
        Row row = rows.get(task.decision());
        row.underWay--;
        row.begun--;
        games--;
        row.left.add(list(task.lineup()));
    }
}
