package steward.cli.shared;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.MatchResult;

/** The line that says how a match ended. */
class MatchHeadlineTest {

    private static MatchResult.PlayerResult player(String name, int rank, double score) {
        return new MatchResult.PlayerResult(name, rank, score, null, null, 1, 0, 0, 0, 0);
    }

    /** A player alone neither wins nor loses against another: the score says how it was. */
    @Test
    void aPlayerAloneHasAScoreAndNoWin() {
        assertEquals("me: finished after 3 laps, score 239.39, 240 turns (search-race, seed 7)",
            MatchReport.headline("search-race", 7, new MatchResult(240, "finished after 3 laps",
                List.of(player("me", 0, 239.39)))));
    }

    @Test
    void ofSeveralTheWinnerIsNamed() {
        assertEquals("b wins: finished after 1 lap, 1 turn (duel, seed 7)", MatchReport.headline("duel", 7,
            new MatchResult(1, "finished after 1 lap", List.of(player("a", 1, 0), player("b", 0, 1)))));
    }
}
