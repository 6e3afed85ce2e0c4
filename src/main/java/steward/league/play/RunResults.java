package steward.league.play;

import java.util.List;
import steward.league.RepeatedGroups;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.pairing.KnownResults;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;

/**
 * Results that a run's decisions use, from earlier runs and its own. They tell which groups of bots only repeat games
 * and, if the pairing or the end of the league needs it, how strong each bot is. Not thread-safe.
 */
final class RunResults {

    private final RepeatedGroups repeated;
    private final KnownResults known;

    /**
     * Results of earlier runs.
     *
     * @param from   results of decisions below this number are only needed as sums
     * @param learns whether ratings are needed during the run
     */
    RunResults(Season season, GameQueries queries, int from, boolean learns) {
        repeated = new RepeatedGroups(season.players() == 1);
        known = learns ? queries.known(from) : null;
    }

    RepeatedGroups repeated() {
        return repeated;
    }

    /** The results of the schedule; {@code null} if nobody asks for them. */
    KnownResults known() {
        return known;
    }

    /** Adds what is to be learnt from the attempts of a game. */
    void add(Schedule.Task task, List<Member> members, List<StoredGame> attempts) {
        boolean random = members.stream().anyMatch(member -> member.version().random());
        for (StoredGame game : attempts) {
            if (game.isRated()) {
                long transcript = random ? 0 : game.transcript();
                repeated.add(task.decision(), transcript, task.lineup());
                if (known != null) {
                    known.add(task.decision(), task.seed(), task.lineup(), game.seats().get(0).score(), transcript,
                        game.seats().stream().mapToInt(StoredGame.StoredSeat::rank).toArray());
                }
            }
        }
    }
}
