package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.ReplayHeader;

/** Ordinary turns are settled by their bytes alone, which is what makes verifying quick; everything else is not. */
class TurnCheckTest {

    private final Recorded match = Recorded.of(TestScenes.open("duel"), 4, List.of(new Silent(5), new Silent(6)));
    private final List<String> lines = match.lines();

    /** A bot that leaves no message. */
    private static final class Silent implements Bot {

        private final SeededBot bot;

        Silent(long seed) {
            bot = new SeededBot(seed, 0.3);
        }

        @Override
        public void setup(String line) {
            bot.setup(line);
        }

        @Override
        public String turn(String line) {
            return bot.turn(line).replaceFirst(",\"message\".*", "}");
        }
    }

    private static byte[] bytes(String line) {
        return line.getBytes(StandardCharsets.UTF_8);
    }

    private TurnCheck check() {
        return new TurnCheck(new Resimulation(Recorded.reader(match.bytes()).header(), TestScenes.TYPES, "r.jsonl"),
            ReplayHeader.FORMAT);
    }

    @Test
    void turnsWithNothingUnusualAreSettledByTheirBytes() {
        TurnCheck check = check();
        assertTrue(lines.size() > 30, "the match is short");
        assertTrue(match.text().contains("\"impacts\""), "the match needs impacts");
        for (String line : lines.subList(1, lines.size() - 1)) {
            assertEquals(TurnCheck.Found.SAME, check.check(bytes(line)), line);
        }
        assertEquals(TurnCheck.Found.NOTHING, check.check(bytes(lines.get(lines.size() - 1))), "the result");
    }

    @Test
    void whatIsUnusualIsLeftToTheReaderOfAllFields() {
        String first = lines.get(1);
        assertEquals(TurnCheck.Found.NOTHING, check().check(bytes(" " + first)));
        assertEquals(TurnCheck.Found.NOTHING, check().check(bytes(first.replace("\"turn\":1,", "\"turn\":2,"))));
        assertEquals(TurnCheck.Found.NOTHING, check().check(bytes(first.substring(0, first.indexOf("outcome")))));
        assertEquals(TurnCheck.Found.PLAYED, check().check(bytes(first.replace("\"state\"", "\"stage\""))));
        assertEquals(TurnCheck.Found.PLAYED, check().check(bytes(first + "}")));
        TurnCheck check = check();
        String played = first.replace("\"state\"", "\"stage\"");
        assertEquals(TurnCheck.Found.PLAYED, check.check(bytes(played)));
        assertArrayEquals(bytes(first.replaceFirst(".*\"outcome\":(.*),\"times\".*", "$1")),
            Arrays.copyOf(check.outcome(), check.outcomeLength()), "what came of it is kept");
    }

    /** The last turn once more, with the next number: it looks ordinary, but there is no such turn. */
    @Test
    void aTurnBehindTheEndIsNotPlayed() {
        int last = lines.size() - 2;
        List<String> longer = new ArrayList<>(lines.subList(0, last + 1));
        longer.add(lines.get(last).replace("\"turn\":" + last, "\"turn\":" + (last + 1)));

        Difference difference = Recorded.verify(String.join("\n", longer) + "\n").difference();

        assertNotNull(difference, "it passed");
        assertEquals(last + 1, difference.turn());
        assertTrue(difference.found().startsWith("the match is over"), difference.toString());
    }
}
