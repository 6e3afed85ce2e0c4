package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.codingame.recording.OfficialGame;
import steward.codingame.recording.ServerMeanMax;
import steward.match.TestScenes;

/** {@code steward import}, and what the other commands make of its replays. */
class ImportCommandTest {

    private static final OfficialGame GAME = OfficialGame.play(12);
    private static final int SKETCHED = 33;

    @TempDir
    private Path folder;
    private Path recording;
    private Path replay;

    @BeforeEach
    void write() throws IOException {
        recording = Files.writeString(folder.resolve("game.json"), GAME.json());
        replay = folder.resolve("game.jsonl");
    }

    private void imported(String json) throws IOException {
        Files.writeString(recording, json);
        Cli cli = Cli.run("import", recording.toString(), "--out", replay.toString());
        assertEquals("", cli.err());
        assertEquals(ExitStatus.DONE, cli.status());
    }

    private static void refused(String message, String... arguments) {
        Cli.run(arguments).assertRefused(message);
    }

    private Cli replay(String... arguments) {
        Cli cli = Cli.run(List.of("replay", replay.toString()), arguments).done();
        assertEquals("", cli.err());
        assertFalse(cli.out().contains("NaN") || cli.out().contains("null"), cli.out());
        return cli;
    }

    @Test
    void aGameThatWasImportedHasNoAnswerTimes() throws IOException {
        imported(GAME.json());
        String out = replay().out();
        assertTrue(out.lines().anyMatch(line -> line.matches(" *0  player 0 .* -  +-  +-")), out);
    }

    @Test
    void aChangedGameIsToldWithItsTurn() throws IOException {
        int from = GAME.json().indexOf("\"view\":\" 20\\n") + "\"view\":\" 20\\n".length();
        String json = GAME.json().substring(0, from) + "1" + GAME.json().substring(from);
        imported(json);
        Cli cli = Cli.run("replay", replay.toString(), "--verify");
        assertEquals(ExitStatus.FAILED, cli.status());
        assertTrue(cli.out().startsWith("differs: turn 10, view line 1, word 0: recorded 1"), cli.out());
        assertTrue(cli.out().contains("\n  server: 1") && cli.out().contains("\n  here:   ")
            && cli.out().contains(" frames behind the first difference; ranks and scores\n"), cli.out());
    }

    @Test
    void theReplayIsShownLikeAnyOther() throws IOException {
        imported(GAME.json());
        assertTrue(replay().out().contains("finished after 3 laps"));
        assertTrue(replay("--turn", "10").out().contains("command"));
        assertTrue(replay("--impacts").out().lines().count() > 20);
        String frames = replay("--frames", "--player", "1").out();
        assertTrue(frames.startsWith("3\n"), frames);
        int checkpoints = Integer.parseInt(frames.lines().skip(1).findFirst().orElseThrow());
        assertEquals(2 + checkpoints + 4L * GAME.turns(), frames.lines().count());
    }

    private static String verified() {
        return "verified: states of " + GAME.turns() + " of " + GAME.turns()
            + " turns, as another referee saw them, and the result\n" + VIEWS;
    }

    private static final String VIEWS = "views: N numbers and words equal\nnot compared: " + String.join("; ",
        TestScenes.TYPES.viewWriter("pod-race").orElseThrow().notCompared()) + "\n";

    private static String withoutCount(String printed) {
        return printed.replaceFirst("views: [0-9]{4,6} ", "views: N ");
    }

    @Test
    void aSketchIsShownToo() throws IOException {
        imported(GAME.sketch(SKETCHED));
        assertEquals("verified: states of 26 of 33 turns, as another referee saw them, and the result\n"
            + VIEWS.stripTrailing() + "; 14 texts of frames that the recording lacks; the rest of 26 views that "
            + "end early\n",
            withoutCount(replay("--verify").out()));
        String table = replay().out();
        assertTrue(table.contains("player 1 failed: no answer in the recording"), table);
        assertTrue(table.contains("player 0 wins: the other player is out, 33 turns"), table);
        for (int turn : List.of(1, 5, 10, SKETCHED)) {
            assertTrue(replay("--turn", Integer.toString(turn)).out().startsWith("turn " + turn + "\n"));
        }
        assertTrue(replay("--frames", "--player", "0").out().lines().count() > 4 * SKETCHED);
    }

    /** Mean Max, packed: what a server does not show of it is nowhere missed. */
    @Test
    @Tag("process")
    void aGameWithViewsOfItsOwnIsShownFedAndPlayedOn() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (OutputStream out = new GZIPOutputStream(packed)) {
            out.write(ServerMeanMax.play(5, 300).json().getBytes(StandardCharsets.UTF_8));
        }
        Files.write(recording, packed.toByteArray());
        assertEquals(ExitStatus.DONE, Cli.run("import", recording.toString(), "--out", replay.toString()).status());
        assertTrue(replay("--verify").out().contains(" numbers and words equal\n"));
        replay();
        replay("--turn", "10");
        replay("--impacts");
        replay("--frames", "--player", "1");
        String again = folder.resolve("again.jsonl").toString();
        Cli fed = Cli.run("feed", replay.toString(), "--player", "0", "--from-turn", "9", "--replace", "--out", again,
            "--", "builtin:gatherer");
        assertEquals("", fed.err());
        assertTrue(Cli.run("replay", again, "--verify").out().startsWith("verified"), fed.out());
        Files.write(recording, Arrays.copyOf(packed.toByteArray(), packed.size() / 2));
        refused("found a file of gzip that is damaged or was cut off, expected all of it", "import",
            recording.toString(), "--out", folder.resolve("cut.jsonl").toString());
    }

    /** Four turns of the Poker Chip Race, imported when outcomes were what the server showed. */
    @Test
    void anImportOfAnEarlierVersionIsWatchedAndAskedToBeMadeAnew() throws IOException {
        try (InputStream in = ImportCommandTest.class.getResourceAsStream(
            "/pokerchiprace/import-of-earlier-version.jsonl")) {
            Files.write(replay, in.readAllBytes());
        }
        String page = folder.resolve("page.html").toString();
        for (String[] look : new String[][] {{}, {"--turn", "3"}, {"--impacts"}, {"--map"}, {"--view", page},
            {"--frames", "--player", "1"}}) {
            Cli cli = Cli.run(List.of("replay", replay.toString()), look).done();
            assertFalse(cli.out().contains("NaN") || cli.out().contains("null"), cli.out());
        }
        refused(replay + ":1: imported: found an import of an earlier version, expected one of this version: 'steward "
            + "import' makes it anew from the recording", "replay", replay.toString(), "--verify");
    }

    @Test
    void aReplayThatExistsIsKept() throws IOException {
        Files.writeString(replay, "precious");
        refused("exists already, and is kept; --overwrite", "import", recording.toString(), "--out",
            replay.toString());
        assertEquals("precious", Files.readString(replay));
        assertEquals(ExitStatus.DONE, Cli.run("import", recording.toString(), "--out", replay.toString(),
            "--overwrite").status());
        assertEquals(verified(), withoutCount(replay("--verify").out()));
    }

    @Test
    void aRefusedRecordingLeavesNoReplay() throws IOException {
        String out = replay.toString();
        refused("game.json: frame 4, view line 0: found \" oops", "import",
            Files.writeString(recording, GAME.json().replace("\" 4\\n", "\" oops 4\\n")).toString(),
            "--out", out);
        refused("game.json:1:", "import", Files.writeString(recording, "{").toString(), "--out", out);
        assertFalse(Files.exists(replay));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Test
    void aGameComesAndGoesByPipes() {
        String replay = Cli.piped(bytes(GAME.json()), "import", "-", "--out", "-").done().out();
        assertEquals(verified(), withoutCount(Cli.piped(bytes(replay), "replay", "-", "--verify").done().out()));
        Cli.piped(new byte[0], "import", "-", "--out", "-").assertRefused("");
        Cli.piped(bytes(replay), "replay", "-", "--view", "-", "--open").assertRefused("");
        String page = Cli.piped(bytes(replay), "replay", "-", "--view", "-").done().out();
        assertTrue(page.startsWith("<!DOCTYPE html>"), () -> page.substring(0, 20));
    }

    /** Between programs, where the input is a pipe and not a file. */
    @Test
    @Tag("process")
    @Tag("campaign")
    void pipesOfAShellAreRead() throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        assertEquals(verified() + "status 0\n", withoutCount(ProcessTest.shell("cat " + recording + " | "
            + ProcessTest.steward("import", "-", "--out", "-") + " | "
            + ProcessTest.steward("replay", "-", "--verify"))));
    }
}
