package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.game.GameSetup;
import steward.match.Referee;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.match.TimeControl;
import steward.replay.sign.SigningKey;
import steward.replay.verify.SignatureCheck;
import steward.replay.verify.Verification;

/** A replay that is signed: by whom, over what, and what is left of it when it is cut. */
class SignedReplayTest {

    private static final SigningKey KEY = SigningKey.generate();

    private static Recorded duel(SigningKey key) {
        List<Bot> bots = List.of(new SeededBot(1, 0.3), new SeededBot(2, 0.3));
        return Recorded.of(TestScenes.open("duel"), 7, bots, key);
    }

    @Test
    void theHeaderNamesTheSignerAndTheLastLineIsTheSignature() {
        Recorded match = duel(KEY);
        List<String> lines = match.lines();

        assertTrue(lines.get(0).contains(",\"signer\":\"" + KEY.publicKey().text() + "\",\"scene\":"), lines.get(0));
        assertTrue(lines.get(lines.size() - 2).startsWith("{\"type\":\"result\""));
        String last = lines.get(lines.size() - 1);
        assertTrue(last.matches("\\{\"type\":\"signature\",\"signature\":\"[A-Za-z0-9+/]{86}==\"}"), last);
        assertEquals(new SignatureCheck(SignatureCheck.Verdict.RIGHT, KEY.publicKey()), match.verify().signature());
        assertTrue(match.verify().signature().isBy(KEY.publicKey()));
        assertFalse(match.verify().signature().isBy(SigningKey.generate().publicKey()));
        assertEquals(SignatureCheck.UNSIGNED, duel(null).verify().signature());
    }

    /** Ed25519 signatures are deterministic, so signed replays are equal byte for byte, too. */
    @Test
    void twoPlaysAreTheSameBytesWithoutTheTimes() {
        assertEquals(duel(KEY).withoutTimes(), duel(KEY).withoutTimes());
        assertNotEquals(duel(KEY).withoutTimes(), duel(null).withoutTimes());
    }

    /** The signature stays valid when the times are removed, as for comparing replays. */
    @Test
    void theSignatureHoldsWithoutTheTimes() {
        Verification seen = Recorded.verify(duel(KEY).withoutTimes());
        assertTrue(seen.verified());
        assertTrue(seen.signature().isBy(KEY.publicKey()));
    }

    @Test
    @Tag("sized")
    void cutAnywhereItIsUnsigned() {
        byte[] replay = duel(KEY).bytes();
        int signature = duel(KEY).lines().get(duel(KEY).lines().size() - 1).length() + 1;
        for (int cut = duel(KEY).lines().get(0).length() + 1; cut < replay.length - 1; cut += TestSize.of(977, 97)) {
            Verification seen = Recorded.verify(Arrays.copyOf(replay, cut));
            assertTrue(seen.agrees(), "cut at " + cut);
            assertFalse(seen.verified(), "cut at " + cut);
            assertEquals(SignatureCheck.Verdict.CUT_OFF, seen.signature().verdict(), "cut at " + cut);
        }
        Verification seen = Recorded.verify(Arrays.copyOf(replay, replay.length - signature));
        assertTrue(seen.whole());
        assertEquals("r.jsonl: cut off after the result: there is no signature, which the header announces",
            seen.warning());
    }

    /** The result and the signature come in one piece: no reader sees the one without the other. */
    @Test
    void theSignatureIsWrittenWithTheResult() throws IOException, InterruptedException {
        ByteArrayOutputStream kept = new ByteArrayOutputStream();
        int[] pieces = new int[1];
        OutputStream file = new WriteBehind(new OutputStream() {
            @Override
            public void write(int one) {
                throw new AssertionError("byte by byte");
            }

            @Override
            public void write(byte[] bytes, int from, int count) {
                kept.write(bytes, from, count);
                String seen = kept.toString(StandardCharsets.UTF_8);
                pieces[0] += seen.contains("\"result\"") && !seen.endsWith("\"}\n") ? 1 : 0;
            }
        });
        GameSetup setup = TestScenes.open("duel");
        ReplayHeader header = new ReplayHeader("pod-race", setup.scene().json(), 7, List.of("a", "b"),
            List.of("a", "b"), Double.POSITIVE_INFINITY);
        try (ReplayWriter writer = new ReplayWriter(file, header, KEY, null)) {
            new Referee(setup, 7, List.of(new InProcessPlayer("a", new SeededBot(1, 0)), new InProcessPlayer("b",
                new SeededBot(2, 0))), TimeControl.UNLIMITED, writer).play();
        }
        assertEquals(0, pieces[0]);
        assertTrue(Recorded.verify(kept.toByteArray()).signature().isBy(KEY.publicKey()));
    }

    @Test
    void aSignerThatIsNoKeyIsRefused() {
        String signer = KEY.publicKey().text();
        for (String other : List.of("", "x", signer.substring(4), signer.replace('=', ' '),
                "A" + signer.substring(1))) {
            String replay = duel(KEY).text().replace(signer, other);
            assertEquals("r.jsonl:1: signer: found no Ed25519 public key in base64, expected one as steward key makes"
                + " it", assertThrows(ReplayException.class, () -> Recorded.verify(replay)).getMessage());
        }
    }

    /** As the Javadoc of what is signed says; with the tools of any Unix. */
    @Test
    @Tag("process")
    void otherToolsCanCheckIt(@TempDir Path folder) throws IOException, InterruptedException {
        Files.write(folder.resolve("match.jsonl"), duel(KEY).bytes());
        KEY.write(folder.resolve("mine"));
        String script = """
            sed -e '$d' match.jsonl | sed -e 's/,"times":{[^}]*}}$/}/' | sha256sum | cut -d' ' -f1 > digits
            printf 'steward replay sha256:%s\\n' "$(cat digits)" > text
            tail -1 match.jsonl | cut -d'"' -f8 | base64 -d > signature
            openssl pkeyutl -verify -rawin -pubin -inkey mine.pub -in text -sigfile signature
            """;
        assumeTrue(ShellBots.runnable(), "skipped: there is no shell");
        String said = ProcessTest.shell("cd '" + folder + "'\n" + script);
        assumeTrue(!said.contains("not found") && !said.contains("rawin"), "skipped: " + said);
        assertTrue(said.contains("Signature Verified Successfully"), said);
    }
}
