package steward.league.play;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import steward.league.Schedule;
import steward.league.play.Roster.Member;
import steward.league.store.AsideGames;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;

/** Forgiven games that are played again, each with the number of its first attempt now. Not thread-safe. */
final class ForgivenGames {

    private final Map<Schedule.Task, Integer> further = new HashMap<>();

    /** Puts those of a season first that are to be played again, if their bots still play. */
    void decide(GameStore store, int season, GamePlay play, Function<Schedule.Task, List<Member>> members,
                Schedule schedule) {
        AsideGames aside = new AsideGames(store);
        Set<List<Integer>> known = new HashSet<>();
        for (AsideGames.SetAside game : aside.again(season)) {
            Schedule.Task task = new Schedule.Task(game.decision(), game.seed(), GameQueries.lineup(game.lineup()));
            List<Integer> key = new ArrayList<>(List.of(game.decision()));
            Arrays.stream(task.lineup()).forEach(key::add);
            List<Member> seats = members.apply(task);
            if (seats.contains(null) || !known.add(key)) {
                continue;
            }
            int attempt = 1;
            while (aside.isReplaced(play.name(task, seats, attempt))) {
                attempt++;
            }
            if (!store.has(play.name(task, seats, attempt))) {
                further.put(task, attempt);
                schedule.again(task);
            }
        }
    }

    /** Returns the number of a game's first attempt; 1 if none was forgiven. */
    int first(Schedule.Task task) {
        return further.getOrDefault(task, 1);
    }
}
