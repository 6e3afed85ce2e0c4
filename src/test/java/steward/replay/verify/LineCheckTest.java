package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Forge;
import steward.replay.Recorded;
import steward.replay.ReplayReader;

/** Ordinary turns are settled by their bytes alone, which is what makes verifying quick; everything else is not. */
class LineCheckTest {

    private final Recorded match = Recorded.of(TestScenes.open("duel"), 4, List.of(silent(5), silent(6)));
    private final List<String> lines = match.lines();

    /** A bot that leaves no message. */
    private static Bot silent(long seed) {
        return new AlteredBot(new SeededBot(seed, 0.3),
            (turn, answer) -> answer.replaceFirst(",\"message\".*", "}"));
    }

    private static byte[] bytes(String line) {
        return line.getBytes(StandardCharsets.UTF_8);
    }

    private LineCheck check() {
        ReplayReader reader = Recorded.reader(match.bytes());
        LineCheck check = new LineCheck(reader,
            new Resimulation(reader.header(), null, TestScenes.TYPES, "r.jsonl"), null);
        assertNull(check.header());
        return check;
    }

    @Test
    void turnsWithNothingUnusualAreSettledByTheirBytes() {
        LineCheck check = check();
        assertTrue(lines.size() > 30, "the match is short");
        assertTrue(match.text().contains("\"impacts\""), "the match needs impacts");
        for (String line : lines.subList(1, lines.size() - 1)) {
            assertTrue(check.isSame(bytes(line)), line);
        }
        assertFalse(check.isSame(bytes(lines.get(lines.size() - 1))), "the result");
    }

    @Test
    void whatIsUnusualIsLeftToTheReaderOfAllFields() {
        String first = lines.get(1);
        assertFalse(check().isSame(bytes(" " + first)));
        assertFalse(check().isSame(bytes(first.replace("\"turn\":1,", "\"turn\":2,"))));
        assertFalse(check().isSame(bytes(first.substring(0, first.indexOf("outcome")))));
        assertFalse(check().isSame(bytes(first.replace("\"state\"", "\"stage\""))));
        assertFalse(check().isSame(bytes(first.replaceFirst("\"turnHash\":\"[0-9a-f]", "\"turnHash\":\"x"))));
        assertFalse(check().isSame(bytes(first + "}")));
    }

    /** One turn, with or without the comparison of bytes before: played once, with the same result. */
    @Test
    void theQuickLookChangesNoVerdict() {
        String first = lines.get(1);
        for (String line : List.of(first, first.replaceFirst(",\"times\".*", "}"),
                first.replaceFirst("\"answerNanos\":\\[", "\"answerNanos\":[1.5,"),
                first.replaceFirst("\"vx\":-?[0-9]+", "\"vx\":12345"),
                Forge.rehash(first.replace("\"state\":", "\"state\": ")),
                Forge.rehash(first.replaceFirst("\"x\":(\\d+)", "\"x\":$1.0")),
                Forge.rehash(first.replaceFirst(",\"turnHash\"", ",\"messages\":[\"hello\",null],\"turnHash\"")),
                Forge.rehash(first.replaceFirst(",\"outcome\"", ",\"faults\":[\"late\",null],\"outcome\"")),
                first.replaceFirst("(\"turnHash\":\")[0-9a-f]", "$1x"))) {
            ReplayReader reader = Recorded.reader(bytes(lines.get(0) + "\n" + line + "\n"));
            byte[] bytes = reader.nextLine();
            LineCheck slow = check();
            LineCheck quick = check();
            ReplayDifference told = slow.turn(bytes, reader.turn(bytes));
            ReplayReader again = Recorded.reader(bytes(lines.get(0) + "\n" + line + "\n"));
            ReplayDifference then = quick.isSame(again.nextLine()) ? null : quick.turn(bytes, again.turn(bytes));
            assertEquals(told, then, line);
            assertEquals(line.equals(first) || !line.contains("\"times\"") || line.contains("1.5")
                || line.contains("hello"), told == null, line);
        }
    }

    /** The last turn once more, with the next number: it looks ordinary, but there is no such turn. */
    @Test
    void aTurnBehindTheEndIsNotPlayed() {
        int last = lines.size() - 2;
        List<String> longer = new ArrayList<>(lines.subList(0, last + 1));
        longer.add(lines.get(last).replace("\"turn\":" + last, "\"turn\":" + (last + 1)));

        ReplayDifference difference = Recorded.verify(String.join("\n", longer) + "\n").difference();

        assertNotNull(difference, "it passed");
        assertEquals(last + 1, difference.turn());
        assertTrue(difference.found().startsWith("the match is over"), difference.toString());
    }
}
