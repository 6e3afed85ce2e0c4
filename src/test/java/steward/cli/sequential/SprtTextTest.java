package steward.cli.sequential;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.streams.Colour;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;

/** Text on the state of a test. */
@Execution(ExecutionMode.CONCURRENT)
class SprtTextTest {

    @Test
    void aRatioThatRoundsToZeroHasNoSign() {
        Gsprt test = new Gsprt(0, 10, 0.05, 0.05, Gsprt.Model.LOGISTIC);
        int found = 0;
        for (int lost = 1; lost < 400; lost++) {
            ScoreCounts scores = new ScoreCounts(2);
            scores.add(0, lost);
            scores.add(1, lost + 3);
            double ratio = test.ratio(scores);
            if (ratio < 0 && ratio > -0.005) {
                found++;
                String text = new SprtText(test, "one", "other").standing(scores);
                assertTrue(text.startsWith("LLR 0.00 (-2.94 to 2.94), "), text);
            }
        }
        assertTrue(found > 0, "no ratio is just below 0");
    }

    @Test
    void aDifferenceThatRoundsToZeroHasNoSign() {
        ScoreCounts scores = new ScoreCounts(2);
        scores.add(0, 10_001);
        scores.add(1, 10_000);
        String text = new SprtText(new Gsprt(0, 10, 0.05, 0.05, Gsprt.Model.LOGISTIC), "one", "other")
            .lines(scores, new SprtText.Unused(0, 0, 0), Colour.NONE).get(4);
        assertTrue(text.contains(", Elo 0.0 (-"), text);
    }
}
