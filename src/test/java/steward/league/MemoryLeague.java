package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import steward.contest.seeds.Seeds;
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

    /** Another schedule, which goes on from these decisions and games, and pauses nobody. */
    public Schedule schedule(int lag, Collection<Integer> roster) {
        return schedule(lag, roster, new PausedBots(0, lag, 0), version -> { });
    }

    /** Another schedule, which goes on from these decisions and games. */
    Schedule schedule(int lag, Collection<Integer> roster, PausedBots pauses, Consumer<Integer> listener) {
        return goOn(new Schedule(Seeds.from(100), players, lag, roster, pauses, listener));
    }

    /** Tells a schedule of these decisions and games. */
    Schedule goOn(Schedule schedule) {
        decisions.values().forEach(each -> schedule.made(each, dropped.contains(each.number())));
        over.forEach(task -> schedule.over(task.decision(), task.lineup()));
        return schedule;
    }

    /** Number of the next decision. */
    int next() {
        return decisions.keySet().stream().mapToInt(number -> number + 1).max().orElse(0);
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

    /** Plays one game after the other until there is none; each is told of before it is over. */
    public void play(Schedule schedule, long most, Consumer<Task> game) {
        for (Task task = next(schedule, most); task != null; task = next(schedule, most)) {
            game.accept(task);
            over(schedule, task);
        }
    }

    /**
     * Plays several games at a time, which end in any order. In a step one begins or ends; games that are under way
     * after the last step are lost, as at a kill.
     *
     * @param end what is done with a game that ends
     * @return true if nothing was left to play
     */
    public boolean play(Schedule schedule, long most, int steps, int threads, RandomGenerator random,
                        Consumer<Task> end) {
        List<Task> underWay = new ArrayList<>();
        for (int step = 0; step < steps; step++) {
            Task task = underWay.size() < threads ? next(schedule, most) : null;
            if (task != null) {
                underWay.add(task);
            } else if (underWay.isEmpty()) {
                return true;
            } else {
                end.accept(underWay.remove(random.nextInt(underWay.size())));
            }
        }
        return false;
    }

    List<Task> games() {
        return over;
    }
}
