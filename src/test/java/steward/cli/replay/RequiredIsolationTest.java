package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.replay.Forge;

/** Isolation can be demanded of a replay, and is believed only if its signer says so. */
@Tag("process")
class RequiredIsolationTest {

    @TempDir
    private Path folder;
    private Path replay;

    @BeforeEach
    void aSignedMatch() {
        replay = folder.resolve("m.jsonl");
        Cli.run("key", "new", folder.resolve("k").toString()).done();
        // They exit at once: what is signed does not depend on how a match went.
        Cli.run("match", "--scene", "duel", "--sandbox", "off", "--seed", "3", "--bot", "sh -c 'exit 0'", "--bot",
            "sh -c 'exit 0'", "--sign", folder.resolve("k").toString(), "--out", replay.toString());
    }

    private Cli verify(Path file, String... words) {
        return Cli.run(List.of("replay", file.toString(), "--verify", "--signed-by",
            folder.resolve("k.pub").toString()), words);
    }

    private Path changed(String from, String to) throws IOException {
        String text = Files.readString(replay);
        assertTrue(text.contains(from), text);
        return Files.writeString(folder.resolve("changed.jsonl"), text.replace(from, to));
    }

    private static void assertFails(String message, Cli call) {
        assertEquals(1, call.status(), call.err());
        assertTrue(call.out().contains(message), call.out());
    }

    @Test
    void aLevelThatIsLowerFails() {
        assertTrue(verify(replay).done().out().contains("bots kept apart: off, memory 0, processes 0"));
        verify(replay, "--require", "off").done();
        assertFails("not verified: the signature says that bots were kept apart at level off, expected it to say at "
            + "least light", verify(replay, "--require", "light"));
    }

    @Test
    void aLevelThatIsForgedOrTakenAwayIsNotSigned() throws IOException {
        assertFails("not verified: the signature is not that of", verify(changed("\"isolation\":\"off",
            "\"isolation\":\"strict"), "--require", "strict"));
        assertFails("not verified: the signature is not that of", verify(changed(
            "\"isolation\":\"off, memory 0, processes 0, file size 0, open files 0\",", ""), "--require", "off"));
        verify(changed("\"times\":{\"sandbox\":\"off\"}", "\"times\":{\"sandbox\":\"strict\"}")).done();
    }

    /** A replay and a key that an earlier version has written. */
    @Test
    void aSignatureOfAnEarlierVersionFailsAndVerifiesWithoutTheDemand() throws IOException {
        Path key = Files.write(folder.resolve("k.pub"), resource("signed-without-isolation.pub"));
        Path earlier = Files.write(folder.resolve("earlier.jsonl"), resource("signed-without-isolation.jsonl"));

        String seen = verify(earlier).done().out();
        assertTrue(seen.startsWith("verified: states of 1 of 1 turn and the result"), seen);
        assertTrue(seen.contains("the key of " + key), seen);
        assertFalse(seen.contains("bots kept apart"), seen);
        assertFails("not verified: the signature does not say how bots were kept apart, as those of earlier versions "
            + "do not, expected it to say at least off", verify(earlier, "--require", "off"));
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = RequiredIsolationTest.class.getResourceAsStream("/replays/" + name)) {
            return in.readAllBytes();
        }
    }

    /** Programs are told as people are: the same status, and the reason. */
    @Test
    void jsonFailsForTheSameReason() {
        String done = verify(replay, "--json", "--require", "off").done().out();
        assertTrue(done.contains("\"verified\":true,\"reason\":null"), done);
        assertTrue(done.contains("\"isolation\":\"off, memory 0, "), done);
        assertFails("\"verified\":false,\"reason\":\"not verified: the signature says that bots were kept apart at "
            + "level off, expected it to say at least strict\"", verify(replay, "--json", "--require", "strict"));
        assertFails("\"reason\":\"not verified: the replay is signed by ", Cli.run("replay", replay.toString(),
            "--verify", "--json", "--signed-by", otherKey()));
    }

    private String otherKey() {
        Cli.run("key", "new", folder.resolve("other").toString()).done();
        return folder.resolve("other.pub").toString();
    }

    /** Neither without its last line, nor without the name of the signer as well. */
    @Test
    void aStrippedSignatureFails() throws IOException {
        List<String> lines = Files.readAllLines(replay);
        String header = Forge.rehash(lines.get(0).replaceFirst(",\"signer\":\"[^\"]*\"", ""));
        lines = new ArrayList<>(lines.subList(1, lines.size() - 1));
        lines.add(0, header);
        Path stripped = Files.write(folder.resolve("stripped.jsonl"), lines);
        Cli.run("replay", stripped.toString(), "--verify").done();
        assertFails("not verified: the replay is unsigned, expected a signature by", verify(stripped));
        assertFails("not verified: the replay is unsigned, expected a signature by", verify(stripped, "--require",
            "off"));
    }

    @Test
    void anUnsignedReplayFails() throws IOException {
        Path unsigned = folder.resolve("unsigned.jsonl");
        Cli.run("match", "--scene", "duel", "--sandbox", "off", "--seed", "3", "--bot", "sh -c 'exit 0'", "--bot",
            "sh -c 'exit 0'", "--out", unsigned.toString());
        assertFails("not verified: the replay is unsigned, expected a signature by", verify(unsigned, "--require",
            "off"));
        List<String> lines = Files.readAllLines(replay);
        Path cut = Files.write(folder.resolve("cut.jsonl"), lines.subList(0, lines.size() - 1));
        assertFails("the replay was cut off before its signature", verify(cut, "--require", "off", "--partial"));
    }
}
