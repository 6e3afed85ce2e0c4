package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.match.TestScenes;
import steward.numerics.Angles;
import steward.replay.Recorded;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;

/**
 * Replays that were written by the program as it was then, and are never written anew. Formats 1 and 2: three pods
 * between walls, without any rounding of places or speeds, so that the last bit of every sine and cosine stands in
 * their states; with messages, stderr, a boost, a shield, impacts and a fault in turn 9. And an imported match of
 * format 2, which lacks states and impacts.
 */
class FrozenReplaysTest {

    static String frozen(String name) {
        try (InputStream in = FrozenReplaysTest.class.getResourceAsStream("/replays/" + name + ".jsonl")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new AssertionError(problem);
        }
    }

    private static Verification verifyWith(String name, int line, String from, String to) {
        List<String> lines = new ArrayList<>(frozen(name).lines().toList());
        assertTrue(lines.get(line).contains(from), lines.get(line));
        lines.set(line, lines.get(line).replace(from, to));
        return Recorded.verify(String.join("\n", lines) + "\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"format-1", "format-2"})
    void areVerified(String name) {
        assertEquals(Recorded.whole(24), Recorded.verify(frozen(name)));
    }

    @Test
    void anImportedOneIsVerifiedAsFarAsItGoes() {
        assertEquals(new Verification(16, 12, true, null, null, ImpactCounts.NONE, ViewCounts.NONE, null,
            SignatureCheck.UNSIGNED),
            Recorded.verify(frozen("format-2-imported")));
    }

    @ParameterizedTest
    @CsvSource({"format-1, 1", "format-2, 2", "format-2-imported, 2"})
    void theirAnglesAreThoseOfThen(String name, int format) {
        try (ReplayReader reader = Recorded.reader(frozen(name).getBytes(StandardCharsets.UTF_8))) {
            assertEquals(format, reader.format());
            assertEquals(Angles.FDLIBM, reader.header().angles());
            assertEquals(Angles.FDLIBM, new Resimulation(reader.header(), TestScenes.TYPES, "r")
                .setup().scene().angles());
        }
    }

    /** The hashes of one format are none of the other. */
    @ParameterizedTest
    @CsvSource({"format-1, 1, 2", "format-2, 2, 1"})
    void hashesOfTheOtherFormatDiffer(String name, int format, int other) {
        Verification seen = verifyWith(name, 0, "\"format\":" + format, "\"format\":" + other);
        assertEquals("headerHash", seen.difference().field());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "format-1 |  0 | \"timeFactor\":40 | \"timeFactor\":41 | headerHash",
        "format-2 |  0 | \"timeFactor\":40 | \"timeFactor\":41 | headerHash",
        "format-1 |  4 | turn 4: | turn 5: | inputHash",
        "format-2 |  4 | turn 4: | turn 5: | inputHash",
        "format-1 |  9 | @text 8000 | @text 8001 | inputHash",
        "format-2 |  9 | @text 8000 | @text 8001 | inputHash",
        "format-2 |  9 | \"shieldTimer\":1 | \"shieldTimer\":2 | state.bodies[1].shieldTimer",
        "format-1 | 25 | \"rank\":1 | \"rank\":0 | standing[0].rank",
        "format-2 | 25 | \"rank\":1 | \"rank\":0 | standing[0].rank",
        "format-2-imported | 16 | \"turn\":16 | \"turn\":17 | turn",
        "format-2-imported | 3 | \"x\":6752 | \"x\":6753 | state.bodies[0].x"})
    void anEditIsFound(String name, int line, String from, String to, String field) {
        assertEquals(field, verifyWith(name, line, from, to).difference().field());
    }

    /** Of a header as it was written then, {@code imported} behind the hash made every outcome optional. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        " 0 | }$ | ,\"imported\":true} | imported: found behind headerHash, expected before it",
        " 0 | }$ | ,\"more\":1} | more: unknown field, expected one of type, format, game, seed, players, timeFactor, "
            + "imported, scene, drawing, start, headerHash",
        " 0 | ,\"game\" | ,\"angles\":\"fdlibm\",\"game\" | angles: unknown field, expected one of type, format, game, "
            + "seed, players, timeFactor, imported, scene, drawing, start, headerHash",
        " 3 | }$ | ,\"faults\":[null,null,null]} | faults: found behind times, expected before it",
        "25 | ,\"times\" | ,\"data\":{},\"times\" | data: found behind resultHash, expected before it",
        "25 | ,\"times\" | ,\"stderr\":[],\"times\" | stderr: unknown field, expected one of type, turns, ending, "
            + "standing, players, data, resultHash, times"})
    void fieldsThatTheyDoNotHaveAreRefused(int line, String from, String to, String message) {
        List<String> lines = new ArrayList<>(frozen("format-2").lines().toList());
        lines.set(line, lines.get(line).replaceFirst(from, to));
        String replay = String.join("\n", lines) + "\n";
        ReplayException refusal = assertThrows(ReplayException.class, () -> Recorded.verify(replay));
        assertTrue(refusal.getMessage().startsWith("r.jsonl:" + (line + 1) + ": " + message), refusal.getMessage());
    }

    /** An imported match whose outcomes were emptied compares nothing, and so is not verified. */
    @Test
    void anImportThatShowsNothingIsNotVerified() {
        String empty = frozen("format-2-imported")
            .replaceAll("\"outcome\":\\{.*\\}(?=,\"(messages|stderr|times)\")", "\"outcome\":{}");
        Verification seen = Recorded.verify(empty);
        assertEquals(0, seen.states());
        assertTrue(seen.agrees());
        assertFalse(seen.verified());
    }
}
