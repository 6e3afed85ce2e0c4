package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import steward.league.Schedule.Task;

/** The decisions and games of a league without a database: one schedule after the other goes on from them. */
public final class MemoryLeague {

    private final int players;
    private final int ahead;
    private final Map<Integer, Decision> decisions = new TreeMap<>();
    private final Set<Integer> dropped = new HashSet<>();
    private final List<Task> over = new ArrayList<>();

    /** @param ahead games that are decided on before they are asked for */
    public MemoryLeague(int players, int ahead) {
        this.players = players;
        this.ahead = ahead;
    }

    /** One that decides as late as it can. */
    public MemoryLeague(int players) {
        this(players, 1);
    }

    /** Decisions and games from which another schedule goes on. */
    public PastDecisions past() {
        PastDecisions past = new PastDecisions(players, number -> decisions.get(number).seed());
        Map<List<Integer>, Integer> numbers = new HashMap<>();
        decisions.values().forEach(each -> past.decision(each.number(), lineup(past, numbers, each.group()),
            dropped.contains(each.number())));
        decisions.values().forEach(each -> past.paused(each.number(),
            each.paused().stream().mapToInt(version -> version).toArray()));
        over.forEach(task -> past.game(task.decision(), lineup(past, numbers, Arrays.stream(task.lineup()).boxed()
            .toList())));
        return past;
    }

    private static int lineup(PastDecisions past, Map<List<Integer>, Integer> numbers, List<Integer> versions) {
        return numbers.computeIfAbsent(versions, key -> {
            past.lineup(1 + numbers.size(), versions.stream().mapToInt(version -> version).toArray());
            return 1 + numbers.size();
        });
    }

    /** Adds a game of an earlier run, and its decision if that is not there. */
    void add(Task task) {
        decisions.computeIfAbsent(task.decision(), number -> new Decision(number, task.seed(),
            Arrays.stream(task.lineup()).sorted().boxed().toList(), List.of()));
        over.add(task);
    }

    /** Stores what is new, of which no decision is there yet. */
    private int store(Decision.News news) {
        for (Decision each : news.made()) {
            if (decisions.put(each.number(), each) != null) {
                throw new AssertionError(each + " was made twice");
            }
        }
        news.dropped().forEach((number, is) -> {
            if (!decisions.containsKey(number) || !(is ? dropped.add(number) : dropped.remove(number))) {
                throw new AssertionError(number + " is marked " + is + " again");
            }
        });
        return news.made().size();
    }

    /** The next game, once its decision is stored; {@code null} if there is none. */
    public Task next(Schedule schedule, long most) {
        store(schedule.decide(most, ahead));
        Task task = schedule.next(most, each -> true);
        if (task != null && !decisions.containsKey(task.decision())) {
            throw new AssertionError(task + " begins before it is stored");
        }
        return task;
    }

    /** Makes decisions while more are possible. */
    void decide(Schedule schedule, long most, int games) {
        store(schedule.decide(most, games));
    }

    /** A game is over and stored. */
    public void over(Schedule schedule, Task task, boolean... failed) {
        schedule.over(task, failed);
        over.add(task);
    }

    List<Task> games() {
        return over;
    }
}
