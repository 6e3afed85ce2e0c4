package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.replay.JsonLeaves;
import steward.replay.JsonLeaves.Leaf;
import steward.replay.Recorded;
import steward.replay.ReplayException;
import steward.scene.json.SceneException;

/** A replay in which something was changed: the verifier names the turn, and never lets it pass. */
@Execution(ExecutionMode.CONCURRENT)
class EditedReplayTest {

    private static Recorded match;
    private static List<String> lines;

    /** A short walled race of three: player 2 fails in turn 9, the others do in turn 30. */
    @BeforeAll
    static void playMatch() {
        List<Bot> bots = List.of(stopping(30, 1), stopping(30, 2), stopping(9, 3));
        match = Recorded.of(TestScenes.changed("walled-race", "\"players\": 2", "\"players\": 3"), 20, bots);
        lines = match.lines();
        assertEquals(Recorded.whole(30), match.verify());
        assertTrue(match.text().contains("\"impacts\""), "the match needs impacts");
    }

    private static Bot stopping(int last, long seed) {
        return new AlteredBot(new SeededBot(seed, 0.8), last, answer -> "stop 1234567890");
    }

    private static Verification verifyWith(int lineNumber, String line) {
        List<String> changed = new ArrayList<>(lines);
        changed.set(lineNumber, line);
        return Recorded.verify(String.join("\n", changed) + "\n");
    }

    /** Permitted outcome of an edit of one digit. */
    private enum Verdict { NAMES_THE_TURN, REFUSED, PASSES }

    private static Verdict edit(int lineNumber, int at, char digit) {
        byte[] bytes = lines.get(lineNumber).getBytes(StandardCharsets.UTF_8);
        bytes[at] = (byte) digit;
        try {
            Verification verification = verifyWith(lineNumber, new String(bytes, StandardCharsets.UTF_8));
            if (verification.verified()) {
                return Verdict.PASSES;
            }
            int turn = Math.min(lineNumber, 30);                  // the result is compared after the last turn
            assertEquals(turn, verification.difference().turn(), () -> verification.difference() + " in line "
                + (lineNumber + 1));
            return Verdict.NAMES_THE_TURN;
        } catch (ReplayException refusal) {
            assertTrue(refusal.getMessage().startsWith("r.jsonl:" + (lineNumber + 1) + ":"), refusal.getMessage());
            return Verdict.REFUSED;
        }
    }

    private static boolean isDigit(byte b) {
        return b >= '0' && b <= '9';
    }

    /** True if the value was measured, and so cannot be verified. */
    private static boolean isFree(String path) {
        return path.startsWith("/times/");
    }

    /** Also the seed of a map without a draw, a bot's command, a time limit: what has no effect on this match. */
    @Test
    void oneDigitOfTheHeader() {
        byte[] bytes = lines.get(0).getBytes(StandardCharsets.UTF_8);
        int tried = 0;
        int named = 0;
        for (int at = 0; at < bytes.length; at++) {
            if (isDigit(bytes[at]) && (at % 3 == 0 || at < 200)) {
                int place = at;
                char digit = (char) ('0' + (bytes[at] - '0' + 1) % 10);
                Verdict verdict;
                try {
                    verdict = edit(0, at, digit);
                } catch (SceneException refusal) {
                    verdict = Verdict.REFUSED;
                }
                assertFalse(verdict == Verdict.PASSES, () -> "byte " + place + " of the header made " + digit);
                tried++;
                named += verdict == Verdict.NAMES_THE_TURN ? 1 : 0;
            }
        }
        assertTrue(tried > 100 && named > 20, "digits tried: " + tried + ", named as turn 0: " + named);
    }

    /** Tries all short fields; of the many coordinates one of so many. */
    @Test
    @Tag("slow")
    @Tag("sized")
    void oneDigitOfATurnOrOfTheResult() {
        int of = TestSize.of(20, 5);
        SplitMix64 random = new SplitMix64(2026);
        Map<String, Map<Verdict, Integer>> seen = new TreeMap<>();
        for (int number = 1; number < lines.size(); number++) {
            byte[] bytes = lines.get(number).getBytes(StandardCharsets.UTF_8);
            for (Leaf leaf : JsonLeaves.of(lines.get(number))) {
                int[] digits = IntStream.range(leaf.from(), leaf.to()).filter(k -> isDigit(bytes[k])).toArray();
                boolean tried = number > 30 || leaf.path().split("/").length <= 3 || random.nextInt(of) == 0;
                if (!tried || digits.length == 0) {
                    continue;
                }
                int at = digits[random.nextInt(digits.length)];
                char digit = (char) ('0' + (bytes[at] - '0' + random.nextInt(1, 9)) % 10);
                Verdict verdict = edit(number, at, digit);
                int line = number;
                if (!isFree(leaf.path())) {
                    assertFalse(verdict == Verdict.PASSES, () -> "line " + (line + 1) + ", " + leaf.path() + ", byte "
                        + at + " made " + digit + ": " + lines.get(line).substring(leaf.from(), leaf.to()));
                }
                String kind = leaf.path().replaceAll("/[0-9]+", "");
                seen.computeIfAbsent(kind, k -> new TreeMap<>()).merge(verdict, 1, Integer::sum);
            }
        }
        assertTrue(seen.keySet().containsAll(List.of("/turn", "/commands/x", "/commands/thrust", "/outcome/hash",
            "/outcome/state/bodies/x", "/outcome/state/bodies/heading", "/outcome/state/turnsLeft",
            "/outcome/impacts/impulse", "/outcome/paths/knots", "/times/answerNanos", "/faults", "/turns",
            "/standing/score")), seen::toString);
    }

    /** The last digits of a long number, where several texts mean the same double. */
    @Test
    @Tag("sized")
    void everyDigitOfOneHeadingOfATurn() {
        int most = TestSize.of(1, Integer.MAX_VALUE);
        int edited = 0;
        for (Leaf leaf : JsonLeaves.of(lines.get(5))) {
            if (leaf.path().endsWith("/heading") && (most > 1 || leaf.to() - leaf.from() > 10) && edited++ < most) {
                for (int at = leaf.from(); at < leaf.to(); at++) {
                    char old = lines.get(5).charAt(at);
                    for (char digit = '0'; digit <= '9'; digit++) {
                        if (Character.isDigit(old) && digit != old) {
                            assertFalse(edit(5, at, digit) == Verdict.PASSES, leaf + " byte " + at);
                        }
                    }
                }
            }
        }
        assertTrue(edited > 0, "there is a long number");
    }

    @Test
    void everyOtherSeedDiffers() {
        String seed = "\"seed\":\"20\"";
        for (String other : List.of("21", "0", "-20", "9223372036854775807")) {
            Verification verification = verifyWith(0, lines.get(0).replace(seed, "\"seed\":\"" + other + "\""));
            assertEquals(0, verification.difference().turn());
            String said = verification.difference().toString();
            assertTrue(said.startsWith("start, "), said);
        }
    }

    @Test
    void theFieldAndBothValuesAreNamed() {
        String line = lines.get(7).replaceFirst("(\"state\":\\{\"bodies\":\\[\\{\"id\":0,\"player\":0,\"x\":)(\\d+)",
            "$177777");
        String before = lines.get(7)
            .replaceFirst(".*\"state\":\\{\"bodies\":\\[\\{\"id\":0,\"player\":0,\"x\":(\\d+).*", "$1");

        assertEquals("turn 7, state.bodies[0].x: recorded 77777, re-simulated " + before,
            verifyWith(7, line).difference().toString());
    }

    /** Lines of the replay in another order: the header is 0, the result 31. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0-9 11-31       | turn 10, turn: recorded 11, re-simulated 10",
        "0-10 10-31      | turn 11, turn: recorded 10, re-simulated 11",
        "0-9 11 10 12-31 | turn 10, turn: recorded 11, re-simulated 10",
        "0-11 31         | turn 11, result: recorded an end of the match, re-simulated the match goes on"})
    void linesThatAreMissingDoubledOrSwapped(String order, String difference) {
        List<String> changed = new ArrayList<>();
        for (String part : order.split(" ")) {
            String[] ends = part.split("-");
            changed.addAll(lines.subList(Integer.parseInt(ends[0]), Integer.parseInt(ends[ends.length - 1]) + 1));
        }
        assertEquals(difference, Recorded.verify(String.join("\n", changed) + "\n").difference().toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "31 | \"turns\":30            | \"turns\":29               | turns",
        "31 | \"ending\":\"all are out | \"ending\":\"all are fine   | ending",
        "31 | \"rank\":0              | \"rank\":1                 | standing[0].rank",
        "31 | \"score\":-1            | \"score\":5                | standing[0].score",
        "31 | \"out\":\"not           | \"out\":\"yes              | standing[0].out",
        "31 | \"fault\":\"not JSON    | \"fault\":\"not nice       | players[0].fault",
        "31 | \"name\":\"P0           | \"name\":\"P1              | players[0].name",
        "9  | \"faults\":\\[[^]]*],     | ``                       | commands[2]"})
    void theFieldThatSaysSomethingElseIsNamed(int number, String regex, String to, String field) {
        String line = lines.get(number).replaceFirst(regex, to);
        assertNotEquals(lines.get(number), line);

        ReplayDifference difference = verifyWith(number, line).difference();

        assertEquals(Math.min(number, 30), difference.turn());
        assertEquals(field, difference.field());
    }

    /** Line 6 is one of those that are settled by their bytes: it has no faults, messages or stderr. */
    @ParameterizedTest
    @ValueSource(strings = {"}", "]", "x", "0", ",", "{}", "]}}", ",\"turn\":20}"})
    void somethingBehindATurn(String more) {
        ReplayException refusal = assertThrows(ReplayException.class, () -> verifyWith(5, lines.get(5) + more));

        assertTrue(refusal.getMessage().startsWith("r.jsonl:6:"), refusal.getMessage());
    }

    @Test
    void somethingBehindTheResult() {
        ReplayException refusal = assertThrows(ReplayException.class, () -> Recorded.verify(match.text() + "{}\n"));

        assertEquals("r.jsonl:33: found more behind the result, expected the end of the file", refusal.getMessage());
    }
}
