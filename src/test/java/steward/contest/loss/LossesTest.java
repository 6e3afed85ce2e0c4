package steward.contest.loss;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.contest.loss.Losses.Outcome;

/** The account of lost games. */
class LossesTest {

    private static Losses.Game game(int number, Outcome outcome, String kind, int turns, int behind, double score,
                                    double winner, Map<String, Double> values) {
        return new Losses.Game("game " + number + " (seed 1)", outcome, kind, turns, behind, score, winner, values,
            number == 2 ? "r/2.jsonl" : null);
    }

    @Test
    void kindsWorstGamesAndValuesFillAScreen() {
        Losses losses = new Losses("mine", false);
        losses.add(game(1, Outcome.LOST, "finished", 200, 50, 10, 12, Map.of("laps", 2.0)));
        losses.add(game(2, Outcome.LOST, "finished", 210, 90, 4, 12, Map.of("laps", 1.0)));
        losses.add(game(3, Outcome.LOST, "finished", 220, LeadLog.UNKNOWN, 11, 12, Map.of("laps", 3.0)));
        losses.add(game(4, Outcome.LOST, "failed: late", 3, 3, 0, 1, Map.of()));
        losses.add(game(5, Outcome.WON, "finished", 100, 101, 12, 3, Map.of("laps", 3.0)));
        losses.add(game(6, Outcome.DRAWN, "finished", 100, 101, 3, 3, Map.of("laps", 9.0)));
        assertEquals(List.of(
            "mine lost 4 of 6 games, drew 1, won 1:",
            "  lost   behind for good from turn   how it ended",
            "     3   median 90 (50 to 90)        finished",
            "         worst: game 2 (seed 1), 210 turns, score 4 to 12, behind from turn 90, replay r/2.jsonl",
            "     1   3                           failed: late",
            "         worst: game 4 (seed 1), 3 turns, score 0 to 1, behind from turn 3",
            "value                    in 4 lost games         in 1 won game",
            "score                        6.25 ± 5.19             12.00 ± -",
            "turns                    158.25 ± 103.82            100.00 ± -",
            "laps                         2.00 ± 1.00              3.00 ± -"), losses.lines());
    }

    /** Where fewer is better, 50 to 40 is worse than 40 to 50, of a bot that was ahead until it was out. */
    @Test
    void theWorstGameIsTheFarthestBehindTheWinner() {
        for (boolean lower : new boolean[] {false, true}) {
            Losses losses = new Losses("mine", lower);
            losses.add(game(1, Outcome.LOST, "out", 10, 1, 50, 39, Map.of()));
            losses.add(game(2, Outcome.LOST, "out", 10, 1, 40, 50, Map.of()));
            losses.repeat();
            assertEquals("mine lost 2 of 2 games, drew 0, won 0; 1 other only repeats games:", losses.lines().get(0));
            assertTrue(losses.lines().get(3).contains(lower ? "worst: game 1" : "worst: game 2"),
                () -> losses.lines().get(3));
        }
    }

    @Test
    void aHundredKindsAndValuesFitAScreenToo() {
        Losses losses = new Losses("mine", false);
        for (int k = 0; k < 100; k++) {
            losses.add(game(k, Outcome.LOST, "kind " + k, 1, 1, 0, 1, Map.of("value" + k, 1.0)));
        }
        assertTrue(losses.lines().size() <= 24, () -> String.join("\n", losses.lines()));
        assertEquals(List.of("other lost 0 of 0 games, drew 0, won 0"), new Losses("other", false).lines());
    }
}
