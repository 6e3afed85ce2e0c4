package steward.league.play;

import java.util.List;
import steward.league.RepeatedGroups;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.pairing.KnownResults;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;

/**
 * Results that a run learns from, of earlier runs and of its own: which groups of bots only repeat games, and, where a
 * pairing or an end asks for it, how strong each bot is. Not thread-safe.
 */
final class RunResults {

    private final RepeatedGroups repeated;
    private final KnownResults known;

    /**
     * Results of earlier runs.
     *
     * @param from   below this number no decision's results are asked for alone
     * @param learns whether it is asked how strong bots are
     */
    RunResults(Season season, GameQueries queries, int from, boolean learns) {
        repeated = new RepeatedGroups(season.players() == 1);
        queries.addTo(repeated);
        known = learns ? new KnownResults(season, queries.resultsBefore(from)) : null;
        if (learns) {
            queries.known(from, known::add);
        }
    }

    RepeatedGroups repeated() {
        return repeated;
    }

    /** The results of the schedule; {@code null} if nobody asks for them. */
    KnownResults known() {
        return known;
    }

    /** Adds what is to be learnt from the attempts of a game. */
    void add(List<Member> members, List<StoredGame> attempts) {
        for (StoredGame game : attempts) {
            if (game.isRated()) {
                add(members, game.decision(), game.seed(), game.lineup(), game.seats().get(0).score(),
                    game.transcript(), game.seats().stream().mapToInt(StoredGame.StoredSeat::rank).toArray());
            }
        }
    }

    private void add(List<Member> members, int decision, long seed, int[] lineup, double score, long transcript,
                     int... ranks) {
        boolean random = members.stream().anyMatch(member -> member.version().random());
        repeated.add(decision, random ? 0 : transcript, lineup);
        if (known != null) {
            known.add(decision, seed, lineup, score, random ? 0 : transcript, ranks);
        }
    }

    /** Adds a game that was stored before it was decided on; by seat, whether the bot failed. */
    boolean[] addStored(GameStore store, GamePlay play, Schedule.Task task, List<Member> seats) {
        boolean[][] failed = {new boolean[0]};
        for (int attempt = 1; attempt <= 2; attempt++) {
            store.outcome(play.name(task, seats, attempt)).ifPresent(found -> {
                failed[0] = new boolean[seats.size()];
                for (int seat = 0; seat < seats.size(); seat++) {
                    failed[0][seat] = found.failed().get(seat);
                }
                if (!found.allFailed()) {
                    add(seats, task.decision(), task.seed(), task.lineup(), found.scores().get(0), found.transcript(),
                        found.ranks().stream().mapToInt(rank -> rank).toArray());
                }
            });
        }
        return failed[0];
    }
}
