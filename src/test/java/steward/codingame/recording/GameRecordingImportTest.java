package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.codingame.recording.RecordingImport.Imported;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Games played here, in the form of official recordings, imported: they verify, and every change in them is found in
 * the turn that was changed.
 */
@Execution(ExecutionMode.CONCURRENT)
class GameRecordingImportTest {

    private static final OfficialGame GAME = OfficialGame.play(12);
    /** Lines of a key frame's view: the first line, the pods, the counters. */
    private static final int FIRST_IMPACT = 1 + 8 + 1;
    private static final int IMPACT_WORDS = 11;
    private static final int TIME = 1;
    private static final int IMPULSE = 8;

    private final ByteArrayOutputStream replay = new ByteArrayOutputStream();

    private Imported imported(String json) {
        replay.reset();
        try {
            return RecordingImport.of(json, "game.json", TestScenes.TYPES).write(replay);
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }

    private Verification verified(String json) {
        imported(json);
        return TextMatches.verify(replay.toByteArray());
    }

    private String text() {
        return replay.toString(StandardCharsets.UTF_8);
    }

    /** The game with one line of a view changed. */
    private static String spoilt(int frame, int line, UnaryOperator<String> change) {
        ObjectNode game = GAME.gameResult();
        ObjectNode spoiltFrame = (ObjectNode) game.get("frames").get(frame);
        List<String> lines = new ArrayList<>(spoiltFrame.get("view").stringValue().lines().toList());
        String before = lines.get(line);
        String after = change.apply(before);
        assertNotEquals(before, after, "nothing was spoilt");
        if (after == null) {
            lines.remove(line);
        } else {
            lines.set(line, after);
        }
        spoiltFrame.put("view", String.join("\n", lines) + "\n");
        return game.toString();
    }

    private static UnaryOperator<String> word(int number, UnaryOperator<String> change) {
        return line -> {
            String[] words = line.split(" ");
            words[number] = change.apply(words[number]);
            return String.join(" ", words);
        };
    }

    private static String plusOne(String number) {
        return Long.toString((long) Double.parseDouble(number) + 1);
    }

    /** More than a unit in the last place of a sine or cosine can make. */
    private static String farther(String number) {
        return Double.toString(Double.parseDouble(number) * (1 + 0x1p-20));
    }

    private void assertFound(int turn, String field, String json) {
        ReplayDifference difference = verified(json).difference();
        assertNotNull(difference, field);
        assertEquals(turn, difference.turn(), difference.toString());
        assertEquals(field, difference.field(), difference.toString());
    }

    @Test
    void aWholeGameVerifies() {
        Verification verification = verified(GAME.json());
        assertNull(verification.difference());
        assertEquals(GAME.turns(), verification.turns());
        assertNull(verification.warning());
        assertTrue(GAME.impactTurns().size() > 10, "impacts are among it");
        assertTrue(text().contains("\"shieldTimer\":4") && text().contains("\"boostLeft\":false"));
        assertTrue(text().lines().findFirst().orElseThrow().contains("\"heading\":null"));
        assertTrue(text().contains("\"server\":[{\"view\":\" 0\\nCodersStrikeBack")
            && text().contains("\"messages\":[\"go | go\",\"go | go\"]"));
    }

    @Test
    void textsThatTheRecordingLacksAreTold() {
        List<String> all = verified(GAME.json()).views().notCompared();
        ObjectNode game = GAME.gameResult();
        ((ObjectNode) game.get("frames").get(4)).remove("summary");
        ((ObjectNode) game.get("frames").get(5)).remove("view");
        Verification verification = verified(game.toString());
        assertNull(verification.difference());
        List<String> more = new ArrayList<>(all);
        more.add("2 texts of frames that the recording lacks");
        assertEquals(more, verification.views().notCompared());
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void severalGamesVerify() {
        Set<String> endings = new TreeSet<>();
        for (long seed = TestSize.of(14, 11); seed < TestSize.of(16, 20); seed++) {
            OfficialGame game = OfficialGame.play(seed);
            Imported imported = imported(game.json());
            endings.add(imported.ending());
            Verification verification = TextMatches.verify(replay.toByteArray());
            assertNull(verification.difference());
            assertEquals(game.turns(), verification.turns());
        }
        assertTrue(endings.contains("finished after 3 laps"), endings::toString);
    }

    @Test
    void theInnerObjectsAloneAreTheSame() {
        imported(GAME.json());
        String whole = text();
        imported(GAME.gameResult().toString());
        assertEquals(whole, text());
        imported("{\"gameResult\":" + GAME.gameResult() + "}");
        assertEquals(whole, text());
    }

    @Test
    @Tag("slow")
    void everyDigitOfAPodIsCompared() {
        int frame = OfficialGame.keyFrame(40);
        assertFound(40, "view line 1, word 0", spoilt(frame, 1, word(0, GameRecordingImportTest::plusOne)));
        assertFound(40, "view line 3, word 1", spoilt(frame, 3, word(1, GameRecordingImportTest::plusOne)));
        assertFound(40, "view line 5, word 2", spoilt(frame, 5, word(2, GameRecordingImportTest::plusOne)));
        assertFound(40, "view line 7, word 3", spoilt(frame, 7, word(3, GameRecordingImportTest::plusOne)));
        assertFound(40, "view line 5, word 8", spoilt(frame, 5, word(8, GameRecordingImportTest::farther)));
        assertFound(40, "view line 5, word 8", spoilt(frame, 5, word(8, heading -> "null")));
        assertFound(40, "view line 1, word 9", spoilt(frame, 1, word(9, up -> up.equals("0") ? "1" : "0")));
        assertFound(40, "view line 7, word 10", spoilt(frame, 7, word(10, next -> next.equals("0") ? "1" : "0")));
        assertFound(0, "view line 11, word 0", spoilt(0, 5 + 6, word(0, GameRecordingImportTest::plusOne)));
        assertFound(0, "view line 5, word 8", spoilt(0, 5, word(8, unset -> "0.5")));
    }

    /** By live rules the last frame shows 0 for the pod that has finished, which the count alone would not tell. */
    @Test
    @Tag("slow")
    void theNextCheckpointsOfTheLastFrameAreCompared() {
        assertTrue(imported(GAME.json()).ending().startsWith("finished"));
        for (int pod = 0; pod < 4; pod++) {
            for (int other : new int[] {1, 2}) {
                ObjectNode result = GAME.gameResult();
                ObjectNode frame = (ObjectNode) result.get("frames").get(OfficialGame.keyFrame(GAME.turns()));
                List<String> lines = new ArrayList<>(frame.get("view").stringValue().lines().toList());
                int count = result.get("frames").get(0).get("view").stringValue().split("\n")[3].split(" ").length / 2;
                lines.set(1 + 2 * pod, word(10, next -> Integer.toString((Integer.parseInt(next) + other) % count))
                    .apply(lines.get(1 + 2 * pod)));
                frame.put("view", String.join("\n", lines) + "\n");
                assertNotNull(verified(result.toString()).difference(), "pod " + pod + ", " + other);
            }
        }
    }

    /** Time and impulse by more than 1e-9 of them; the number of an impact is not compared. */
    @Test
    @Tag("slow")
    void eachNumberOfEachImpactOfSomeTurnsIsCompared() {
        for (int turn : GAME.impactTurns().subList(0, 4)) {
            for (int line = FIRST_IMPACT; line < FIRST_IMPACT + impactsOf(turn); line++) {
                for (int word = 1; word < IMPACT_WORDS; word++) {
                    boolean near = word == TIME || word == IMPULSE;
                    UnaryOperator<String> change = near ? number -> Double.toString(
                        Double.parseDouble(number) * (1 + 2e-9)) : GameRecordingImportTest::plusOne;
                    assertFound(turn, "view line " + line + ", word " + word, spoilt(OfficialGame.keyFrame(turn), line,
                        word(word, change)));
                }
            }
        }
    }

    /** As another library's sines make them. */
    @Test
    void timesAndImpulsesThatAreNearAreCountedApartAndNamed() {
        Verification exact = verified(GAME.json());
        assertEquals(0, exact.views().nearInAll());
        int turn = GAME.impactTurns().get(1);
        for (int word : new int[] {TIME, IMPULSE}) {
            Verification found = verified(spoilt(OfficialGame.keyFrame(turn), FIRST_IMPACT, word(word,
                number -> Double.toString(Math.nextUp(Double.parseDouble(number))))));
            assertNull(found.difference());
            assertEquals(1, found.views().nearInAll());
            assertTrue(found.views().near().get(0).startsWith("turn " + turn + ", view line 10, word " + word
                + ": recorded "), found.views().near().get(0));
            assertEquals(exact.views().values() - 1, found.views().values());
        }
    }

    /** Behind the first difference the games differ; what the server has shown there is kept. */
    @Test
    void framesBehindTheFirstDifferenceAreKeptAndCounted() {
        Verification found = verified(spoilt(OfficialGame.keyFrame(40), 1, word(0, GameRecordingImportTest::plusOne)));
        assertEquals(39, found.turns());
        String behind = 2 * (GAME.turns() - 40) + " frames behind the first difference";
        assertTrue(found.views().notCompared().contains(behind),
            found.views().notCompared()::toString);
        assertTrue(text().contains("{\"view\":\" " + 2 * GAME.turns() + " endReached"), "the last frame");
        String[] here = found.difference().lines().ours().split(" ");
        assertEquals(found.difference().lines().server().split(" ")[0], plusOne(here[0]));
    }

    @Test
    void theCountersOfBothPlayersAreCompared() {
        int frame = OfficialGame.keyFrame(40);
        int counters = FIRST_IMPACT - 1;
        UnaryOperator<String> otherTurns = counter -> counter.substring(0, 2) + "77";
        UnaryOperator<String> otherRank = counter -> (counter.charAt(0) == '1' ? '2' : '1') + counter.substring(1);
        assertFound(40, "view line 9, word 0", spoilt(frame, counters, word(0, otherTurns)));
        assertFound(40, "view line 9, word 1", spoilt(frame, counters, word(1, otherTurns)));
        assertFound(40, "view line 9, word 0", spoilt(frame, counters, word(0, otherRank)));
        assertFound(40, "view line 9, word 1", spoilt(frame, counters, word(1, otherRank)));
        assertFound(0, "view line 13, word 1", spoilt(0, 5 + 8, word(1, otherTurns)));
    }

    @Test
    void aMissingAndAnAdditionalImpactAreFound() {
        int turn = GAME.impactTurns().get(2);
        int frame = OfficialGame.keyFrame(turn);
        int last = FIRST_IMPACT + impactsOf(turn) - 1;
        assertFound(turn, "view line " + last, spoilt(frame, last, line -> null));
        assertFound(turn, "view line " + (last + 1), spoilt(frame, last, line -> line + "\n" + line));
        int quiet = turn + 1;
        while (GAME.impactTurns().contains(quiet)) {
            quiet++;
        }
        assertFound(quiet, "view line " + FIRST_IMPACT, spoilt(OfficialGame.keyFrame(quiet), FIRST_IMPACT - 1,
            line -> line + "\n0 0.5 1 0 0 0 0 0 240 0 0"));
    }

    private static int impactsOf(int turn) {
        String view = GAME.gameResult().get("frames").get(OfficialGame.keyFrame(turn)).get("view").stringValue();
        return (int) view.lines().count() - FIRST_IMPACT;
    }

    /** A view that goes on to its counters shows impacts: where none are, there was none. */
    @Test
    void impactsAreMissedBehindCountersAndNotInViewsThatEndBefore() {
        ObjectNode game = GAME.gameResult();
        for (int turn : GAME.impactTurns()) {
            ObjectNode frame = (ObjectNode) game.get("frames").get(OfficialGame.keyFrame(turn));
            frame.put("view", String.join("\n", frame.get("view").stringValue().lines().limit(FIRST_IMPACT).toList()));
        }
        assertFound(GAME.impactTurns().get(0), "view line 10", game.toString());
        for (int k = 2; k < game.get("frames").size(); k += 2) {
            ObjectNode frame = (ObjectNode) game.get("frames").get(k);
            frame.put("view", String.join("\n", frame.get("view").stringValue().lines().limit(9).toList()));
        }
        assertNull(verified(game.toString()).difference());
        assertTrue(text().contains("\"impacts\":["), "ours are there");
    }

    @Test
    void missingPartsAreLeftOut() {
        ObjectNode game = GAME.gameResult();
        game.remove("ranks");
        ArrayNode frames = (ArrayNode) game.get("frames");
        for (int k = 0; k < frames.size(); k++) {
            ObjectNode frame = (ObjectNode) frames.get(k);
            frame.remove(k % 3 == 0 ? List.of("agentId", "keyframe") : List.of("agentId"));
            if (k % 2 == 1 || k % 10 == 4) {
                frame.remove(List.of("view", "summary"));
            }
        }
        ObjectNode first = (ObjectNode) frames.get(0);
        first.put("view", String.join("\r\n", first.get("view").stringValue().lines().limit(4).toList()));
        Verification verification = verified(game.toString());
        assertNull(verification.difference());
        assertEquals(GAME.turns(), verification.turns());
        assertTrue(verification.views().notCompared().toString().contains("texts of frames that the recording lacks"));
    }

    /** Keeps so many turns, and changes the frames of the last. */
    private static ObjectNode cut(int turns, String stdout0, String stdout1) {
        ObjectNode game = GAME.gameResult();
        game.remove("scores");
        ArrayNode frames = (ArrayNode) game.get("frames");
        while (frames.size() > 1 + 2 * turns) {
            frames.remove(frames.size() - 1);
        }
        for (int player = 0; player < 2; player++) {
            ObjectNode frame = (ObjectNode) frames.get(2 * turns - 1 + player);
            String stdout = player == 0 ? stdout0 : stdout1;
            if (stdout == null) {
                frame.remove("stdout");
            } else if (!stdout.equals("as it was")) {
                frame.put("stdout", stdout);
            }
            if (stdout == null || !stdout.equals("as it was")) {
                ((ObjectNode) frames.get(2 * turns)).remove(List.of("view", "summary"));
            }
        }
        return game;
    }

    private static ObjectNode ranks(ObjectNode game, int... ranks) {
        ArrayNode array = game.putArray("ranks");
        Arrays.stream(ranks).forEach(array::add);
        return game;
    }

    @Test
    void aPlayerThatStopsAnsweringEndsTheGame() {
        assertEnds(ranks(cut(30, "as it was", null), 0, 1), "[null,\"no answer in the recording\"]");
        assertEnds(ranks(cut(30, "as it was", "1 2 SHIELD\n"), 0, 1),
            "[null,\"answered 1 of 2 lines in the recording\"]");
        assertEnds(ranks(cut(30, null, "as it was"), 1, 0), "[\"no answer in the recording\",null]");
        assertEnds(ranks(cut(30, null, null), 0, 0),
            "[\"no answer in the recording\",\"no answer in the recording\"]");
        assertEnds(ranks(cut(30, "as it was", "no idea\nwhat to say"), 0, 1), "[null,\"line 1 of 2: X: found");
    }

    private void assertEnds(ObjectNode game, String faults) {
        Imported imported = imported(game.toString());
        assertEquals(30, imported.turns());
        assertEquals(faults.startsWith("[null") || faults.endsWith("null]") ? "all others are out" : "all are out",
            imported.ending());
        assertTrue(text().contains("\"faults\":" + faults), text().substring(text().length() - 2000));
        Verification verification = TextMatches.verify(replay.toByteArray());
        assertNull(verification.difference());
        assertEquals(30, verification.turns());
    }

    /** The first player fails in a key frame of its own: the other one is not asked any more, and has not failed. */
    @Test
    void thePlayerBehindTheOneThatFailedHasNotFailed() {
        ObjectNode game = ranks(cut(30, null, null), 1, 0);
        ArrayNode frames = (ArrayNode) game.get("frames");
        frames.remove(frames.size() - 1);
        assertEnds(game, "[\"no answer in the recording\",null]");
        assertTrue(text().contains("\"messages\":[null,\"not asked any more | not asked any more\"]"));
        ((ObjectNode) frames.get(frames.size() - 1)).put("keyframe", true);
        assertEnds(game, "[\"no answer in the recording\",null]");
    }

    @Test
    void aRecordingThatWasCutOffVerifiesUpToTheCut() {
        ObjectNode game = cut(30, "as it was", "as it was");
        game.remove("ranks");
        assertNull(imported(game.toString()).ending());
        Verification verification = TextMatches.verify(replay.toByteArray());
        assertNull(verification.difference());
        assertEquals(30, verification.turns());
        assertNotNull(verification.warning());
        ArrayNode frames = (ArrayNode) game.get("frames");
        frames.remove(frames.size() - 1);
        assertEquals(29, imported(game.toString()).turns());
    }

    @Test
    void aServerThatEndedEarlierOrLaterIsADifference() {
        assertFound(30, "result", cut(30, "as it was", "as it was").toString());
        ObjectNode game = GAME.gameResult();
        ArrayNode frames = (ArrayNode) game.get("frames");
        for (int more = 0; more < 2; more++) {
            ObjectNode frame = ((ObjectNode) frames.get(frames.size() - 2)).deepCopy();
            frame.put("view", frame.get("view").stringValue().replaceFirst("[0-9]+", "" + frames.size()));
            frames.add(frame);
        }
        assertFound(GAME.turns(), "turns", game.toString());
    }

    @Test
    void otherRanksAreADifference() {
        ObjectNode game = GAME.gameResult();
        int first = game.get("ranks").get(0).intValue();
        ranks(game, 1 - first, first);
        assertFound(GAME.turns(), "ranks line 0, word 0", game.toString());
    }
}
