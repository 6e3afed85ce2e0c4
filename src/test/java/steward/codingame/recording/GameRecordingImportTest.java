package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.codingame.recording.RecordingImport.Imported;
import steward.game.ChangedWords;
import steward.match.TestSize;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Games played here, in the form of official recordings, imported: they verify, and every change in them is found in
 * the turn that was changed. Over 400 lines, because all cases spoil one game and look for the change in it.
 */
@Execution(ExecutionMode.CONCURRENT)
class GameRecordingImportTest {

    private static final OfficialGame GAME = OfficialGame.play(12);
    /** Lines of a key frame's view: the first line, the pods, the counters. */
    private static final int FIRST_IMPACT = 1 + 8 + 1;
    private static final int TIME = 1;
    private static final int IMPULSE = 8;
    private static final Pattern WORD = Pattern.compile("[^\\s\"]+");

    /** The game with one line of a view changed, or left out. */
    private static ObjectNode spoilt(int frame, int line, UnaryOperator<String> change) {
        return ImportedRecording.changeView(GAME.gameResult(), frame, lines -> {
            String after = change.apply(lines.get(line));
            assertNotEquals(lines.get(line), after, "nothing was spoilt");
            if (after == null) {
                lines.remove(line);
            } else {
                lines.set(line, after);
            }
        });
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

    private static void assertFound(int turn, String field, JsonNode game) {
        ReplayDifference difference = ImportedRecording.verified(game).difference();
        assertNotNull(difference, field);
        assertEquals(turn, difference.turn(), difference.toString());
        assertEquals(field, difference.field(), difference.toString());
    }

    /** Verifies a recording that agrees. @return its counts */
    private static ViewComparison views(String json) {
        ViewComparison views = new ViewComparison();
        assertNull(ImportedRecording.of(json).verified(views).difference());
        return views;
    }

    @Test
    void aWholeGameVerifies() {
        ImportedRecording whole = ImportedRecording.of(GAME.json());
        Verification verification = whole.verified();
        assertNull(verification.difference());
        assertEquals(GAME.turns(), verification.turns());
        assertNull(verification.warning());
        assertTrue(GAME.impactTurns().size() > 10, "impacts are among it");
        String text = whole.text();
        assertTrue(text.contains("\"shieldTimer\":4") && text.contains("\"boostLeft\":false"));
        assertTrue(text.lines().findFirst().orElseThrow().contains("\"heading\":null"));
        assertTrue(text.contains("\"server\":[{\"view\":\" 0\\nCodersStrikeBack")
            && text.contains("\"messages\":[\"go | go\",\"go | go\"]"));
    }

    @Test
    void textsThatTheRecordingLacksAreTold() {
        List<String> more = new ArrayList<>(views(GAME.json()).notCompared());
        ObjectNode game = GAME.gameResult();
        ImportedRecording.frame(game, 4).remove("summary");
        ImportedRecording.frame(game, 5).remove("view");
        ViewComparison views = views(game.toString());
        more.add("2 texts of frames that the recording lacks");
        assertEquals(more, views.notCompared());
    }

    @Test
    @Tag("sized")
    @Tag("slow")
    void severalGamesVerify() {
        Set<String> endings = new TreeSet<>();
        for (long seed = TestSize.of(14, 11); seed < TestSize.of(16, 20); seed++) {
            OfficialGame game = OfficialGame.play(seed);
            ImportedRecording recording = ImportedRecording.of(game.json());
            endings.add(recording.imported().ending());
            Verification verification = recording.verified();
            assertNull(verification.difference());
            assertEquals(game.turns(), verification.turns());
        }
        assertTrue(endings.contains("finished after 3 laps"), endings::toString);
    }

    @Test
    void theInnerObjectsAloneAreTheSame() {
        String whole = ImportedRecording.of(GAME.json()).text();
        assertEquals(whole, ImportedRecording.of(GAME.gameResult().toString()).text());
        assertEquals(whole, ImportedRecording.of("{\"gameResult\":" + GAME.gameResult() + "}").text());
    }

    /** By live rules the last frame shows 0 for the pod that has finished, which the count alone would not tell. */
    @Test
    @Tag("slow")
    void theNextCheckpointsOfTheLastFrameAreCompared() {
        assertTrue(ImportedRecording.of(GAME.json()).imported().ending().startsWith("finished"));
        int count = view(0).split("\n")[3].split(" ").length / 2;
        for (int pod = 0; pod < 4; pod++) {
            for (int other : new int[] {1, 2}) {
                ObjectNode game = spoilt(OfficialGame.keyFrame(GAME.turns()), 1 + 2 * pod,
                    word(10, next -> Integer.toString((Integer.parseInt(next) + other) % count)));
                assertNotNull(ImportedRecording.verified(game).difference(), "pod " + pod + ", " + other);
            }
        }
    }

    /**
     * Of the start, of a turn without impacts and of some with: numbers that are not whole by little more than 1e-9 of
     * them. Neither the number of an impact is compared nor, here, that of the frame and the counters.
     */
    @Test
    @Tag("slow")
    void everyWordOfAPodAndOfAnImpactIsCompared() {
        List<Integer> turns = new ArrayList<>(GAME.impactTurns().subList(0, 4));
        turns.addAll(List.of(0, 40));
        for (int turn : turns) {
            int frame = OfficialGame.keyFrame(turn);
            int pods = turn == 0 ? 5 : 1;
            for (ChangedWords change : ChangedWords.of(view(frame), WORD, GameRecordingImportTest::other)) {
                boolean impact = change.line() > pods + 8 && change.word() > 0;
                if (impact || change.line() >= pods && change.line() < pods + 8) {
                    ObjectNode game = GAME.gameResult();
                    ImportedRecording.frame(game, frame).put("view", change.text());
                    ImportedRecording.cut(game, frame + 3);
                    game.remove("ranks");
                    assertFound(turn, "view line " + change.line() + ", word " + change.word(), game);
                }
            }
        }
        assertFound(40, "view line 5, word 8", spoilt(OfficialGame.keyFrame(40), 5, word(8, heading -> "null")));
    }

    private static String view(int frame) {
        return GAME.gameResult().get("frames").get(frame).get("view").stringValue();
    }

    private static String other(String word) {
        return switch (word) {
            case "0", "0.0" -> "1";
            case "1" -> "0";
            case "null" -> "0.5";
            default -> word.matches("-?[0-9]+") ? plusOne(word)
                : word.matches("-?[0-9.]+(E-?[0-9]+)?") ? Double.toString(Double.parseDouble(word) * (1 + 2e-9))
                : word + "x";
        };
    }

    /** As another library's sines make them. */
    @Test
    void timesAndImpulsesThatAreNearAreCountedApartAndNamed() {
        ViewComparison exact = views(GAME.json());
        assertEquals(0, exact.nearInAll());
        int turn = GAME.impactTurns().get(1);
        for (int word : new int[] {TIME, IMPULSE}) {
            ViewComparison found = views(spoilt(OfficialGame.keyFrame(turn), FIRST_IMPACT,
                word(word, number -> Double.toString(Math.nextUp(Double.parseDouble(number))))).toString());
            assertEquals(1, found.nearInAll());
            assertTrue(found.near().get(0).startsWith("turn " + turn + ", view line 10, word " + word
                + ": recorded "), found.near().get(0));
            assertEquals(exact.values() - 1, found.values());
        }
    }

    /** Behind the first difference the games differ; what the server has shown there is kept. */
    @Test
    void framesBehindTheFirstDifferenceAreKeptAndCounted() {
        ImportedRecording recording = ImportedRecording.of(spoilt(OfficialGame.keyFrame(40), 1,
            word(0, GameRecordingImportTest::plusOne)).toString());
        ViewComparison views = new ViewComparison();
        Verification found = recording.verified(views);
        assertEquals(39, found.turns());
        String behind = 2 * (GAME.turns() - 40) + " frames behind the first difference";
        assertTrue(views.notCompared().contains(behind), views.notCompared()::toString);
        assertTrue(recording.text().contains("{\"view\":\" " + 2 * GAME.turns() + " endReached"), "the last frame");
        String[] here = found.difference().lines().ours().split(" ");
        assertEquals(found.difference().lines().server().split(" ")[0], plusOne(here[0]));
    }

    @Test
    void theCountersOfBothPlayersAreCompared() {
        int frame = OfficialGame.keyFrame(40);
        int counters = FIRST_IMPACT - 1;
        UnaryOperator<String> otherTurns = counter -> counter.substring(0, 2) + "77";
        UnaryOperator<String> otherRank = counter -> (counter.charAt(0) == '1' ? '2' : '1') + counter.substring(1);
        for (int player = 0; player < 2; player++) {
            assertFound(40, "view line 9, word " + player, spoilt(frame, counters, word(player, otherTurns)));
            assertFound(40, "view line 9, word " + player, spoilt(frame, counters, word(player, otherRank)));
        }
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
        return (int) view(OfficialGame.keyFrame(turn)).lines().count() - FIRST_IMPACT;
    }

    /** A view that goes on to its counters shows impacts: where none are, there was none. */
    @Test
    void impactsAreMissedBehindCountersAndNotInViewsThatEndBefore() {
        ObjectNode game = GAME.gameResult();
        for (int turn : GAME.impactTurns()) {
            limit(game, OfficialGame.keyFrame(turn), FIRST_IMPACT);
        }
        assertFound(GAME.impactTurns().get(0), "view line 10", game);
        for (int k = 2; k < game.get("frames").size(); k += 2) {
            limit(game, k, 9);
        }
        ImportedRecording recording = ImportedRecording.of(game.toString());
        assertNull(recording.verified().difference());
        assertTrue(recording.text().contains("\"impacts\":["), "ours are there");
    }

    private static void limit(ObjectNode game, int frame, int count) {
        ImportedRecording.changeView(game, frame, lines -> lines.subList(count, lines.size()).clear());
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
        ViewComparison views = new ViewComparison();
        Verification verification = ImportedRecording.of(game.toString()).verified(views);
        assertNull(verification.difference());
        assertEquals(GAME.turns(), verification.turns());
        assertTrue(views.notCompared().toString().contains("texts of frames that the recording lacks"));
    }

    /** The first 30 turns. @param answers of each player in the last; an empty one is as it was, null is none */
    private static ObjectNode cut(String... answers) {
        ObjectNode game = GAME.gameResult();
        game.remove("scores");
        ImportedRecording.cut(game, 61);
        for (int player = 0; player < answers.length; player++) {
            ObjectNode frame = ImportedRecording.frame(game, 59 + player);
            if (answers[player] == null) {
                frame.remove("stdout");
            } else if (!answers[player].isEmpty()) {
                frame.put("stdout", answers[player]);
            }
        }
        if (answers.length > 0) {
            ImportedRecording.frame(game, 60).remove(List.of("view", "summary"));
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
        assertEnds(ranks(cut("", null), 0, 1), "[null,\"no answer in the recording\"]");
        assertEnds(ranks(cut("", "1 2 SHIELD\n"), 0, 1),
            "[null,\"answered 1 of 2 lines in the recording\"]");
        assertEnds(ranks(cut(null, ""), 1, 0), "[\"no answer in the recording\",null]");
        assertEnds(ranks(cut(null, null), 0, 0),
            "[\"no answer in the recording\",\"no answer in the recording\"]");
        assertEnds(ranks(cut("", "no idea\nwhat to say"), 0, 1), "[null,\"line 1 of 2: X: found");
    }

    private static String assertEnds(ObjectNode game, String faults) {
        ImportedRecording recording = ImportedRecording.of(game.toString());
        assertEquals(new Imported(30, faults.startsWith("[null") || faults.endsWith("null]") ? "all others are out"
            : "all are out"), recording.imported());
        String text = recording.text();
        assertTrue(text.contains("\"faults\":" + faults), () -> text.substring(text.length() - 2000));
        Verification verification = recording.verified();
        assertNull(verification.difference());
        assertEquals(30, verification.turns());
        return text;
    }

    /** The first player fails in a key frame of its own: the other one is not asked any more, and has not failed. */
    @Test
    void thePlayerBehindTheOneThatFailedHasNotFailed() {
        ObjectNode game = ranks(cut(null, null), 1, 0);
        ImportedRecording.cut(game, 60);
        assertTrue(assertEnds(game, "[\"no answer in the recording\",null]")
            .contains("\"messages\":[null,\"not asked any more | not asked any more\"]"));
        ImportedRecording.frame(game, 59).put("keyframe", true);
        assertEnds(game, "[\"no answer in the recording\",null]");
    }

    @Test
    void aTurnWithoutItsKeyFrameKeepsItsFramesAndLacksTexts() {
        ObjectNode game = ranks(cut(null, null), 1, 0);
        ImportedRecording.cut(game, 60);
        String text = assertEnds(game, "[\"no answer in the recording\",null]");
        assertTrue(text.contains("\"server\":[{\"view\":\" 59\\n\"},{}]"), () -> text.substring(text.length() - 2000));
        List<String> told = views(game.toString()).notCompared();
        assertTrue(told.contains("2 texts of frames that the recording lacks"), told::toString);
    }

    /** One within the last turn, one behind it. */
    @Test
    void framesOfTheRefereeThatEndNoTurnAreKeptAndNotCompared() {
        ObjectNode game = cut();
        game.remove("ranks");
        ObjectNode last = ImportedRecording.frame(game, 60);
        last.put("view", last.get("view").stringValue().replaceFirst("60", "61"));
        ArrayNode frames = (ArrayNode) game.get("frames");
        frames.insertObject(60).put("agentId", -1).put("keyframe", false).put("view", " 60\nwithin\n");
        frames.addObject().put("agentId", -1).put("view", " 62\nbehind\n").put("summary", "more");
        ImportedRecording recording = ImportedRecording.of(game.toString());
        ViewComparison views = new ViewComparison();
        Verification found = recording.verified(views);
        assertNull(found.difference());
        assertEquals(30, found.turns());
        assertTrue(recording.text().contains("within") && recording.text().contains("behind"));
        List<String> told = views.notCompared();
        assertTrue(told.contains("2 frames of the referee that end no turn"), told::toString);
    }

    @Test
    void aRecordingThatWasCutOffVerifiesUpToTheCut() {
        ObjectNode game = cut();
        game.remove("ranks");
        ImportedRecording recording = ImportedRecording.of(game.toString());
        assertNull(recording.imported().ending());
        Verification verification = recording.verified();
        assertNull(verification.difference());
        assertEquals(30, verification.turns());
        assertNotNull(verification.warning());
        ImportedRecording.cut(game, 60);
        assertEquals(29, ImportedRecording.of(game.toString()).imported().turns());
    }

    @Test
    void aServerThatEndedEarlierOrLaterIsADifference() {
        assertFound(30, "result", cut());
        ObjectNode game = GAME.gameResult();
        ArrayNode frames = (ArrayNode) game.get("frames");
        for (int more = 0; more < 2; more++) {
            ObjectNode frame = ((ObjectNode) frames.get(frames.size() - 2)).deepCopy();
            frame.put("view", frame.get("view").stringValue().replaceFirst("[0-9]+", "" + frames.size()));
            frames.add(frame);
        }
        assertFound(GAME.turns(), "turns", game);
    }

    @Test
    void otherRanksAreADifference() {
        ObjectNode game = GAME.gameResult();
        int first = game.get("ranks").get(0).intValue();
        ranks(game, 1 - first, first);
        assertFound(GAME.turns(), "ranks line 0, word 0", game);
    }
}
