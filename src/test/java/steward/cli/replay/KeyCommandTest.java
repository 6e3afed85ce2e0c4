package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.replay.Forge;

/** {@code steward key}, {@code match --sign} and {@code replay --verify --signed-by}. */
@Tag("process")
class KeyCommandTest {

    @TempDir
    private static Path folder;
    private static Path mine;
    private static Path other;
    private static Path signed;
    private static Path unsigned;
    private static String fingerprint;

    @BeforeAll
    static void play() {
        mine = folder.resolve("mine.key");
        other = folder.resolve("other.key");
        signed = folder.resolve("signed.jsonl");
        unsigned = folder.resolve("unsigned.jsonl");
        Cli made = Cli.run("key", "new", mine.toString()).done();
        assertTrue(made.out().startsWith("Private key: " + mine + "\nPublic key:  " + mine
            + ".pub\nFingerprint: SHA256:"), made.out());
        fingerprint = made.out().replaceAll("(?s).*Fingerprint: (.*)\n", "$1");
        assertEquals(ExitStatus.DONE, Cli.run("key", "new", other.toString()).status());
        assertEquals(ExitStatus.DONE, match(signed, "--sign", mine.toString()).status());
        assertEquals(ExitStatus.DONE, match(unsigned).status());
    }

    private static Cli match(Path out, String... more) {
        return Cli.run(List.of("match", "--scene", "duel", "--bot", "builtin:racer", "--bot", "builtin:racer", "--seed",
            "1", "--no-deadline", "--quiet", "--out", out.toString()), more);
    }

    private static Cli verify(Path replay, Path key) {
        return key == null ? Cli.run("replay", replay.toString(), "--verify")
            : Cli.run("replay", replay.toString(), "--verify", "--signed-by", key.toString());
    }

    private static Path pub(Path key) {
        return Path.of(key + ".pub");
    }

    @Test
    void onlyTheOwnerCanReadAPrivateKey() throws IOException {
        assertTrue(FileSystems.getDefault().supportedFileAttributeViews().contains("posix"));
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(mine)));
        assertTrue(Files.readString(mine).matches(
            "-----BEGIN PRIVATE KEY-----\n[A-Za-z0-9+/]{64}\n-----END PRIVATE KEY-----\n"));
        assertTrue(Files.readString(pub(mine)).matches(
            "-----BEGIN PUBLIC KEY-----\n[A-Za-z0-9+/]{59}=\n-----END PUBLIC KEY-----\n"));
    }

    @Test
    void aKeyIsNeverReplaced() throws IOException {
        byte[] before = Files.readAllBytes(mine);
        Cli.run("key", "new", mine.toString()).assertRefused("exists already, and is kept");
        assertEquals(List.of(before.length), List.of(Files.readAllBytes(mine).length));
        Path lonely = Files.writeString(folder.resolve("lonely.pub"), "x");
        assertEquals(ExitStatus.UNUSABLE, Cli.run("key", "new", folder.resolve("lonely").toString()).status());
        assertFalse(Files.exists(folder.resolve("lonely")), "no private key without its public one");
        assertEquals("x", Files.readString(lonely));
        assertEquals(ExitStatus.UNUSABLE, Cli.run("key", "new", folder.resolve("no/such").toString()).status());
        assertEquals(ExitStatus.UNUSABLE, Cli.run("key", "old", mine.toString()).status());
    }

    @Test
    void eitherFileShowsTheFingerprint() {
        assertEquals(new Cli(ExitStatus.DONE, fingerprint + "\n", ""), Cli.run("key", "show", mine.toString()));
        assertEquals(new Cli(ExitStatus.DONE, fingerprint + "\n", ""), Cli.run("key", "show", pub(mine).toString()));
        assertNotEquals(fingerprint + "\n", Cli.run("key", "show", other.toString()).out());
    }

    @Test
    void whoHasSignedIsCheckedOnlyWhenAsked() {
        String states = verify(unsigned, null).out();
        assertTrue(states.matches("verified: states of (\\d+) of \\1 turns and the result\n"), states);
        Matcher said = Pattern.compile("(signed by .*)\nbots kept apart: (off|light|strict), memory 0, .*\n").matcher(
            verify(signed, null).done().out().substring(states.length()));
        assertTrue(said.matches(), () -> verify(signed, null).out());
        assertEquals("signed by " + fingerprint + ", not checked against anyone", said.group(1));
        said.reset(verify(signed, pub(mine)).done().out().substring(states.length()));
        assertTrue(said.matches(), () -> verify(signed, pub(mine)).out());
        assertEquals("signed by " + fingerprint + ", the key of " + pub(mine), said.group(1));
    }

    @Test
    void unsignedOrSignedBySomebodyElse() {
        String wanted = Cli.run("key", "show", other.toString()).out().strip();
        assertEquals(new Cli(ExitStatus.FAILED, "not verified: the replay is unsigned, expected a signature by "
            + wanted + ", the key of " + pub(other) + "\n", ""), verify(unsigned, pub(other)));
        assertEquals(new Cli(ExitStatus.FAILED, "not verified: the replay is signed by " + fingerprint
            + ", expected a signature by " + wanted + ", the key of " + pub(other) + "\n", ""),
            verify(signed, pub(other)));
    }

    @Test
    void aSignedReplayThatWasCut() throws IOException {
        List<String> lines = Files.readAllLines(signed);
        Path cut = Files.write(folder.resolve("cut.jsonl"), lines.subList(0, lines.size() - 1));
        Cli seen = verify(cut, null);
        assertEquals(ExitStatus.FAILED, seen.status());
        assertTrue(seen.out().endsWith("\nunsigned up to the cut: the signature by " + fingerprint + " is missing\n"),
            seen.out());
        assertEquals(ExitStatus.DONE, Cli.run("replay", cut.toString(), "--verify", "--partial").status());
        Cli asked = Cli.run("replay", cut.toString(), "--verify", "--partial", "--signed-by", pub(mine).toString());
        assertEquals(ExitStatus.FAILED, asked.status());
        assertTrue(asked.out().startsWith("not verified: the replay was cut off before its signature"), asked.out());
    }

    @Test
    void anAlteredMessageOfASignedReplay() throws IOException {
        String text = Files.readString(signed).replaceFirst("\"bot\":\"builtin:racer\"", "\"bot\":\"builtin:veteran\"");
        List<String> lines = new ArrayList<>(text.lines().toList());
        lines.set(0, Forge.rehash(lines.get(0)));
        Path forged = Files.write(folder.resolve("forged.jsonl"), lines);
        assertEquals(new Cli(ExitStatus.FAILED, "not verified: the signature is not that of " + fingerprint
            + " for these lines\n", ""), verify(forged, null));
    }

    @Test
    @Tag("campaign")
    void manyGamesAreSignedEach() throws IOException {
        Path many = folder.resolve("many");
        assertEquals(ExitStatus.DONE, match(many, "--games", "2", "--sign", mine.toString()).status());
        for (String game : List.of("game-0001.jsonl", "game-0002.jsonl")) {
            assertEquals(ExitStatus.DONE, verify(many.resolve(game), pub(mine)).status(), game);
        }
    }

    @Test
    void keysThatAreNone() throws IOException {
        String pem = Files.readString(mine);
        Path file = folder.resolve("wrong");
        String ec = "-----BEGIN PUBLIC KEY-----\n" + Base64.getEncoder().encodeToString(new byte[44])
            + "\n-----END PUBLIC KEY-----\n";
        for (String text : List.of("", "hello", pem.replace("PRIVATE", "PUBLIC"), pem.replaceFirst("\n[A-Za-z]", "\n="),
                pem.substring(0, 40), ec, ec.replace("PUBLIC", "PRIVATE"), pem.replaceFirst("\nMC4", "\nMC5"))) {
            Files.writeString(file, text);
            for (Cli cli : List.of(match(folder.resolve("never.jsonl"), "--sign", file.toString()),
                    verify(signed, file), Cli.run("key", "show", file.toString()))) {
                assertEquals(ExitStatus.UNUSABLE, cli.status(), text + cli.out());
                assertTrue(cli.err().startsWith("steward: " + file + ": found ") && cli.err().lines().count() == 1,
                    cli.err());
            }
            assertFalse(Files.exists(folder.resolve("never.jsonl")));
        }
        assertTrue(verify(signed, folder.resolve("none")).err().contains("found no such file, expected a public key"));
        assertTrue(verify(signed, mine).err().contains("found a private key, expected a public key"));
        assertTrue(match(folder.resolve("never.jsonl"), "--sign", pub(mine).toString()).err()
            .contains("found a public key, expected a private key"));
        assertEquals(ExitStatus.UNUSABLE, verify(signed, folder).status());
    }
}
