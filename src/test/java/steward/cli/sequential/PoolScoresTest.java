package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.contest.Contest;
import steward.contest.PairedPlay.Outcome;
import steward.contest.PairedPlay.Seed;
import steward.league.sequential.Gsprt;
import steward.match.Protocol;
import steward.match.TestScenes;

/** Scores of a test against a pool, from the outcomes of games. */
class PoolScoresTest {

    static Contest contest(int players) {
        List<Contest.Entrant> entrants = new ArrayList<>();
        for (int k = 0; k < players; k++) {
            entrants.add(new Contest.Entrant("bot" + k, "bot" + k, Protocol.JSON, List.of()));
        }
        return new Contest(TestScenes.duel(players), entrants, null, 1);
    }

    /** A game that the tested bot has won or lost on a side. */
    static Outcome game(boolean isWon, int side) {
        double first = isWon == (side == 0) ? 1 : 0;
        return new Outcome(new double[] {first, 1 - first}, false, 0, new boolean[2]);
    }

    /** Won against both sides what the base lost: +1; half of it: 1/2; of three seats likewise. */
    @Test
    void anObservationIsTheMeanOfTheSeatsOfASeed() {
        PoolScores pool = new PoolScores(contest(2), List.of("a", "b"), false);
        pool.add(0, new Seed(1, game(true, 0), game(true, 1), game(false, 0), game(false, 1)));
        pool.add(1, new Seed(2, game(true, 0), game(false, 1), game(false, 0), game(false, 1)));
        pool.add(1, new Seed(3, game(true, 0), new Outcome(null, true, 0), game(false, 0), game(false, 1)));
        assertEquals(2, pool.scores().observations());
        assertEquals(1L, pool.scores().counts().get(1.0));
        assertEquals(1L, pool.scores().counts().get(0.75));
        assertEquals(0.75, pool.ofNew());
        assertEquals(0, pool.ofBase());
        assertEquals(1, pool.unused().allFailed());
        assertEquals(1, pool.opponents().get(1).seeds());
        PoolScores three = new PoolScores(contest(3), List.of("a, b"), false);
        // The new bot is first of three in each game, the base between the two others.
        three.add(0, new Seed(1, three(2, 1, 0), three(1, 0, 2), three(0, 2, 1), three(1, 2, 0), three(2, 0, 1),
            three(0, 1, 2)));
        assertEquals(1, three.ofNew());
        assertEquals(0.5, three.ofBase());
        assertEquals(1L, three.scores().counts().get(0.75));
    }

    /** One opponent meets the same game on every seed, and weighs as much as another: (0.5 + 3 * 1) / 4. */
    @Test
    void repeatsCountAsTheOpponentWasDrawnButDecideNothing() {
        PoolScores pool = new PoolScores(contest(2), List.of("alike", "other"), false);
        Outcome[] alike = {transcript(true, 1), transcript(true, 2), transcript(false, 3), transcript(false, 4)};
        pool.add(1, new Seed(1, game(true, 0), game(true, 1), game(true, 0), game(true, 1)));
        for (int seed = 2; seed < 5; seed++) {
            pool.add(0, new Seed(seed, alike));
        }
        assertEquals(1L, pool.scores().counts().get(0.5));
        assertEquals(3L, pool.scores().counts().get(1.0));
        assertEquals(2, pool.unused().repeats());
        assertEquals(2, pool.repeatsInARow());
        Gsprt test = Gsprt.ofScores(0.5, 0.6, 0.05, 0.05);
        for (int seed = 5; seed < 50; seed++) {
            pool.add(0, new Seed(seed, alike));
        }
        assertEquals(Gsprt.State.H1, test.state(pool.scores()));
        assertEquals(Gsprt.State.OPEN, pool.state(test), "two games of the four decide nothing");
    }

    private static Outcome transcript(boolean isWon, long transcript) {
        Outcome game = game(isWon, (int) (transcript + 1) % 2);
        return new Outcome(game.values(), false, transcript, new boolean[2]);
    }

    /** 10,000 seeds in a row and twenty opponents: 500 each, with a standard deviation of 22; bound at five. */
    @Test
    void seedsDrawOpponentsEquallyOften() {
        int[] drawn = new int[20];
        for (long seed = Long.MAX_VALUE - 5000; seed != Long.MIN_VALUE + 5000; seed++) {
            drawn[PoolScores.opponent(seed, 20)]++;
        }
        for (int count : drawn) {
            assertEquals(500, count, 110);
        }
    }

    private static Outcome three(double... values) {
        return new Outcome(values, false, 0, new boolean[3]);
    }

    /** At even points 0.1 is a score of 0.6: 400 log10(0.6 / 0.4) Elo. */
    @Test
    void pointsAreToldInEloAtThePointsOfTheBase() {
        PoolScores pool = new PoolScores(contest(2), List.of("a"), false);
        pool.add(0, new Seed(1, game(true, 0), game(true, 1), game(true, 0), game(false, 1)));
        assertEquals(0.5, pool.ofBase());
        assertEquals(400 * StrictMath.log10(0.6 / 0.4), PoolText.elo(pool, 0.1), 1e-9);
        assertTrue(Double.isNaN(PoolText.elo(pool, 0.5)));
    }
}
