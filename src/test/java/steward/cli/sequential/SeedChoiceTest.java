package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.contest.PairedPlay.Outcome;
import steward.contest.PairedPlay.Seed;

/** Seeds that tell bots apart, as the outcomes of their games say. */
class SeedChoiceTest {

    private long transcript;

    private Outcome game(double... values) {
        return new Outcome(values, false, ++transcript, new boolean[values.length]);
    }

    /** In the second game the bots have changed sides: its first value is the second bot's. */
    private Seed seed(long seed, double first, double second) {
        return new Seed(seed, game(first, 0), game(-second, 0));
    }

    @Test
    void aSeedIsChosenWhereABotWinsFromBothSides() {
        SeedChoice choice = new SeedChoice(PoolScoresTest.contest(2), 2);
        assertTrue(choice.take(seed(1, 1, -1)), "who sits first wins");
        assertTrue(choice.take(seed(2, 0, 0)), "draws");
        assertTrue(choice.take(seed(3, 1, 0)), "won from the one side, drawn from the other: d = 1/2, s = 1/4");
        assertTrue(choice.take(seed(4, -1, -1)));
        assertTrue(choice.take(new Seed(5, game(1, 0), new Outcome(null, true, 0))), "without a result");
        assertFalse(choice.take(seed(6, 1, 1)), "as many as are wanted");
        assertEquals(List.of("4  # bot1 ahead by 1", "6  # bot0 ahead by 1"), choice.lines());
        String account = String.join(" ", choice.account());
        assertTrue(account.contains("played 6 seeds from all seats"), account);
        assertTrue(account.contains("Chosen: 2, 1 for bot0, 1 for bot1. Passed over: 0 others above 0, 2 that a seat "
            + "decided, 1 that told nothing, 0 that only repeat games, 0 in which a bot failed, 1 without"), account);
    }

    /** Who crashed lost from both sides: that is a merit of the seed in nothing. */
    @Test
    void aSeedOnWhichABotFailedIsPassedOver() {
        SeedChoice choice = new SeedChoice(PoolScoresTest.contest(2), 2);
        choice.take(new Seed(1, new Outcome(new double[] {1, 0}, false, 7, false, true), game(0, 1)));
        choice.take(seed(2, 1, 1));
        assertEquals(List.of("2  # bot0 ahead by 1"), choice.lines());
        assertTrue(choice.account().get(4).contains("1 in which a bot failed, 0 without a result."));
    }

    @Test
    void gamesThatRepeatOthersChooseNothing() {
        SeedChoice choice = new SeedChoice(PoolScoresTest.contest(2), 2);
        Outcome first = new Outcome(new double[] {1, 0}, false, 7);
        Outcome second = new Outcome(new double[] {0, 1}, false, 8);
        choice.take(new Seed(1, first, second));
        choice.take(new Seed(2, first, second));
        assertEquals(List.of("1  # bot0 ahead by 1"), choice.lines());
    }

    /** Of three players the order may be that of the bots in each game, of the seats, or neither. */
    @Test
    void amongThreeTheWorthiestAreChosen() {
        SeedChoice choice = new SeedChoice(PoolScoresTest.contest(3), 1);
        // First bot 1, second 1/2 and third 0 points in each game: d = 1/2, each seat has 1/2 on average.
        Seed bots = new Seed(1, game(2, 1, 0), game(1, 0, 2), game(0, 2, 1));
        // First bot 1, second 0: d = 1.
        Seed better = new Seed(2, game(2, 0, 1), game(0, 1, 2), game(1, 2, 0));
        Seed seats = new Seed(3, game(2, 1, 0), game(2, 1, 0), game(2, 1, 0));
        assertEquals(0, bots.seatAdvantage(), 1e-12);
        assertEquals(0.5, seats.seatAdvantage(), 1e-12);
        assertTrue(choice.take(bots));
        assertTrue(choice.take(seats));
        assertEquals(List.of("1  # bot0 ahead by 0.5"), choice.lines());
        assertFalse(choice.take(better));
        assertEquals(List.of("2  # bot0 ahead by 1"), choice.lines());
    }
}
