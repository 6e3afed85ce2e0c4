package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.cli.shared.Games;
import steward.contest.repeat.GameFacts;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TestScenes;

/** The sums over the games of a series. */
class StandingsTest {

    private static Contest contest(int players) {
        List<Contest.Entrant> entrants = Collections.nCopies(players,
            new Contest.Entrant("p", "p", Protocol.JSON, List.of()));
        return new Contest(TestScenes.duel(players), entrants, null, 1);
    }

    /** Bots that each play the search race alone, where a lower score is better. */
    private static Contest alone(int bots) {
        return new Contest(Games.open("search-race"), contest(bots).entrants(), null, 1);
    }

    /** Scores by seed (from 1) and bot; NaN for a game without a result. */
    private static List<Series.Played> games(double[]... scores) {
        List<Series.Played> games = new ArrayList<>();
        for (int seed = 1; seed <= scores.length; seed++) {
            for (int bot = 0; bot < scores[seed - 1].length; bot++) {
                double score = scores[seed - 1][bot];
                String fault = score == 1000 ? "no answer" : null;
                MatchResult result = new MatchResult(100, "over",
                    List.of(new MatchResult.PlayerResult("p", 0, score, fault, fault, 1, 0, 0, 0, 0)));
                games.add(new Series.Played(games.size() + 1, seed, bot, Double.isNaN(score) ? null : result, null,
                    List.of(), null));
            }
        }
        return games;
    }

    /** The first bot: better, equal, worse (it failed), both without a finish; the fifth map has no second result. */
    @Test
    void resultsOfBotsAloneAreComparedMapByMap() {
        List<Series.Played> games = games(new double[] {100.25, 120}, new double[] {90, 90},
            new double[] {1000, 120.5}, new double[] {1000, 1000}, new double[] {80, Double.NaN});
        Tally first = Tally.of(alone(2), games, Set.of(), 0);
        assertEquals(new Tally(4, 1, 2, 1, 0, 2, 0.5, (100.25 + 90 + 1000 + 1000 + 80) / 5, first.seeds()), first);
        assertEquals(new Tally(4, 1, 2, 1, 0, 1, 0.5, (120 + 90 + 120.5 + 1000) / 4,
            Tally.of(alone(2), games, Set.of(), 1).seeds()), Tally.of(alone(2), games, Set.of(), 1));
        assertFalse(games.get(6).allFailed(), "a bot alone does not fail together with others");
    }

    /** Of three: one ahead of both others, one ahead of one, one equal to one and behind the other. */
    @Test
    void threeBotsAloneShareThePoints() {
        List<Series.Played> games = games(new double[] {10, 20, 30}, new double[] {20, 10, 20});
        assertEquals((1 + 0.25) / 2, Tally.of(alone(3), games, Set.of(), 0).points());
        assertEquals((0.5 + 1) / 2, Tally.of(alone(3), games, Set.of(), 1).points());
        assertEquals((0 + 0.25) / 2, Tally.of(alone(3), games, Set.of(), 2).points());
    }

    @Test
    void aBotWithoutOthersHasNoPoints() {
        Tally tally = Tally.of(alone(1), games(new double[] {10}, new double[] {30}), Set.of(), 0);
        assertEquals(2, tally.games());
        assertTrue(Double.isNaN(tally.points()));
        assertEquals(20, tally.score());
        Standings standings = new Standings(alone(1));
        assertTrue(Double.isNaN(standings.points(0)));
    }

    @Test
    void aSeriesOfBotsAlonePlaysEachSeedWithEach() {
        Series series = new Series(alone(3), 7, 2, false, null, KeptReplays.NONE, Hiccups.REPLAY);
        assertEquals(6, series.games());
        assertEquals(List.of(7L, 7L, 7L, 8L, 8L, 8L), IntStream.rangeClosed(1, 6).mapToObj(series::seed).toList());
        assertEquals(List.of(0, 1, 2, 0, 1, 2), IntStream.rangeClosed(1, 6).map(series::rotation).boxed().toList());
    }

    /** @param failures of players who have failed, the others have not; by player, the score is its number */
    private static Series.Played game(int number, int rotation, List<Integer> ranks, Failure... failures) {
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (int player = 0; player < ranks.size(); player++) {
            String fault = null;
            for (Failure failure : failures) {
                fault = failure.player() == player ? failure.reason() : fault;
            }
            players.add(new MatchResult.PlayerResult("p", ranks.get(player), player, fault, fault, 1, 0, 0, 0, 0));
        }
        return new Series.Played(number, number, rotation, new MatchResult(number, "over", players), null,
            List.of(failures), null);
    }

    private static Series.Played of(int number, long seed, Series.Played game) {
        return new Series.Played(number, seed, game.rotation(), game.result(), null, game.failures(), null);
    }

    private static Failure failure(int player, int turn, String reason) {
        return new Failure(player, turn, reason, List.of("said in turn " + turn), List.of());
    }

    private static Tally tally(List<Integer> ranks, int bot) {
        return Tally.of(contest(ranks.size()), List.of(game(1, 0, ranks)), Set.of(), bot);
    }

    /** Points 1, 1/2, 0 of three bots: the middle one has one other below and one above. */
    @Test
    void pointsAreTheShareOfTheOthersBelow() {
        assertEquals(0.5, tally(List.of(0, 1, 2), 1).points());
        assertEquals(0.75, tally(List.of(0, 0, 2), 0).points());
        assertEquals(1, tally(List.of(0, 0, 2), 1).draws());
        assertEquals(1, tally(List.of(0, 1, 1), 0).wins());
        assertEquals(0, tally(List.of(0, 1, 2), 2).points());
    }

    /** Two games of seed 7 and one of seed 8; a fourth repeats the first, and its bots failed together in a fifth. */
    @Test
    void gamesOfASeedBelongTogetherAndRepeatsCountOnce() {
        List<Series.Played> games = List.of(of(1, 7, game(1, 0, List.of(0, 1))), of(2, 7, game(2, 0, List.of(0, 0))),
            of(3, 8, game(3, 0, List.of(1, 0))), of(4, 9, game(4, 0, List.of(0, 1))),
            of(5, 10, game(5, 0, List.of(0, 0), failure(0, 1, "a"), failure(1, 1, "b"))));
        Tally first = Tally.of(contest(2), games, Set.of(4), 0);
        assertEquals(new Tally(3, 1, 1, 1, 1, 1, 0.5, 0, List.of(0.75, 0.0)), first);
    }

    /** A win and its repeat, and a loss from the other seat: while they are played and at the end, in any order. */
    @Test
    void theStandingOfASeriesCountsRepeatsOnceToo() {
        for (List<Integer> order : List.of(List.of(1, 2, 3), List.of(3, 2, 1))) {
            Standings standings = new Standings(contest(2));
            for (int number : order) {
                Series.Played game = game(number, number / 3, List.of(0, 1));
                standings.add(new Series.Played(number, number, game.rotation(), game.result(), null, List.of(), null,
                    new GameFacts(number == 3 ? 8 : 7, List.of(), List.of()), null), List.of(), List.of());
            }
            assertEquals(0.5, standings.points(0));
            assertEquals(0.5, standings.tally(0).points());
        }
    }

    @Test
    void gamesInWhichAllFailTogetherAreNoDraws() {
        List<Series.Played> games = List.of(
            game(1, 0, List.of(0, 0), failure(0, 1, "a"), failure(1, 1, "b")),
            game(2, 0, List.of(0, 0)),
            game(3, 0, List.of(1, 0), failure(0, 3, "a"), failure(1, 4, "b")),
            game(4, 0, List.of(1, 0), failure(0, 3, "a")));
        assertTrue(games.get(0).allFailed());
        assertFalse(games.get(1).allFailed() || games.get(2).allFailed() || games.get(3).allFailed());
        Tally first = Tally.of(contest(2), games, Set.of(), 0);
        assertEquals(new Tally(3, 0, 1, 2, 1, 3, 0.5 / 3, 0, List.of(0.5, 0.0, 0.0)), first);
        assertEquals(new Tally(3, 2, 1, 0, 1, 2, 2.5 / 3, 1, List.of(0.5, 1.0, 1.0)),
            Tally.of(contest(2), games, Set.of(), 1));
    }

    @Test
    void aBotThatPlaysAloneAndFailsHasNotFailedTogetherWithOthers() {
        assertFalse(game(1, 0, List.of(0), failure(0, 1, "a")).allFailed());
        assertTrue(game(1, 0, List.of(0, 0, 0), failure(0, 5, "a"), failure(1, 5, "b"), failure(2, 5, "c"))
            .allFailed());
        assertFalse(game(1, 0, List.of(0, 1, 1), failure(1, 5, "b"), failure(2, 5, "c")).allFailed());
    }

    /** Of whatever order games end in, the bot of the call is meant; the lines are those of the earliest game. */
    @Test
    void failuresOfAKindAreTogether() {
        Standings standings = new Standings(contest(2));
        List<Failure> late = List.of(failure(0, 9, "no answer within 75 ms (waited 80 ms)"));
        List<Failure> early = List.of(failure(1, 4, "no answer within 75 ms (waited 76 ms)"));
        List<Failure> other = List.of(failure(0, 2, "exited with status 1 before answering"));
        standings.add(game(3, 0, List.of(1, 0), late.get(0)), late, List.of());
        standings.add(game(2, 1, List.of(0, 1), early.get(0)), early, List.of());
        standings.add(game(1, 1, List.of(1, 0), other.get(0)), other, List.of());
        List<FailureKind> kinds = standings.failures();
        assertEquals(2, kinds.size());
        assertEquals(1, kinds.get(0).entrant());
        assertEquals(1, kinds.get(0).game().number());
        assertEquals(0, kinds.get(1).entrant());
        assertEquals(List.of(4, 9), kinds.get(1).occurrences().stream().map(FailureKind.Occurrence::turn).toList());
        assertEquals(List.of("said in turn 4"), kinds.get(1).first().stderr());
        assertEquals(3, standings.gamesWithFaults());
        assertEquals(2 / 3.0, standings.points(1), 1e-12);
        assertEquals(2, standings.meanTurns());
        assertEquals(List.of(1, 2, 3), standings.games().stream().map(Series.Played::number).toList());
    }

    /** In game 7 the bots have changed sides. */
    @Test
    void timesAreThoseOfTheBotAndNotOfTheSide() {
        Standings standings = new Standings(contest(2));
        AnswerTimes slow = new AnswerTimes();
        slow.add(100, 12);
        AnswerTimes quick = new AnswerTimes();
        quick.add(10, 3);
        standings.add(game(6, 0, List.of(0, 1)), List.of(), List.of(quick, quick));
        standings.add(game(7, 1, List.of(0, 1)), List.of(), List.of(slow, quick));
        assertEquals(10, standings.times(0).worstNanos());
        assertEquals(100, standings.times(1).worstNanos());
        assertEquals(7, standings.times(1).worstGame());
        assertEquals(12, standings.times(1).worstTurn());
        assertEquals(55, standings.times(1).meanNanos());
    }

    @Test
    void whatIsKept() {
        Contest contest = contest(2);
        Series.Played won = game(1, 0, List.of(0, 1));
        Series.Played lost = game(2, 1, List.of(0, 1));
        Series.Played draw = game(3, 0, List.of(0, 0));
        Series.Played failed = game(4, 0, List.of(0, 1), failure(1, 1, "a"));
        Series.Played nothing = new Series.Played(5, 5, 0, null, "no room", List.of(), null);
        List<Series.Played> all = List.of(won, lost, draw, failed, nothing);
        assertEquals(all, all.stream().filter(game -> KeptReplays.ALL.keeps(contest, game)).toList());
        assertEquals(List.of(lost), all.stream().filter(game -> KeptReplays.LOST.keeps(contest, game)).toList());
        assertEquals(List.of(failed, nothing),
            all.stream().filter(game -> KeptReplays.FAILED.keeps(contest, game)).toList());
        assertEquals(List.of(), all.stream().filter(game -> KeptReplays.NONE.keeps(contest, game)).toList());
    }
}
