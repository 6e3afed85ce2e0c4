package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import tools.jackson.databind.JsonNode;

/** Recorded games of Steward's own games, played again with a bot in the place of a player. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class RecordedRunTest extends ShellBotsCase {

    private Path games;
    private String near;
    private String far;

    @BeforeEach
    void play() throws IOException {
        ShellBots.shortDuel(folder);
        near = bots.driver("near", ShellBots.CHECKPOINT);
        far = bots.driver("far", ShellBots.NOWHERE);
        games = Files.createDirectory(folder.resolve("games"));
        for (int game = 1; game <= 2; game++) {
            Cli.run("match", "--scene", folder + "/short.json", "--bot", near, "--bot", far, "--seed", "" + game,
                "--out", games + "/" + game + ".jsonl").done();
        }
    }

    private Cli recorded(Path replays, String as, String bot, String... more) {
        return Cli.run(List.of("match", "--recorded", replays.toString(), "--as", as, "--bot", bot), more);
    }

    @Test
    void theSameBotChangesNothingAnotherDepartsAndOneThatExitsFails() {
        JsonNode same = recorded(games, "near", near, "--json").done().json();
        assertEquals(2, same.get("unchanged").intValue());
        same.get("games").forEach(game -> assertEquals(game.get("recorded"), game.get("points")));

        Cli other = recorded(games, "near", "other=" + far.substring(far.indexOf('=') + 1)).done();
        assertTrue(other.out().contains("departed   2, in turn 2\n"), other.out());
        assertTrue(other.out().contains("departed at turn 2: far is sent other lines\n"), other.out());

        Cli failing = recorded(games, "0", "false", "--strict");
        assertEquals(1, failing.status());
        assertTrue(failing.out().contains("failed     2, in turn 1\n"), failing.out());
    }

    /** A folder is played as far as its files can be read, compressed ones too; one that is named must be there. */
    @Test
    void aFileThatCannotBeReadDoesNotEndAFolder() throws IOException {
        byte[] second = Files.readAllBytes(games.resolve("2.jsonl"));
        try (OutputStream gzip = new GZIPOutputStream(Files.newOutputStream(games.resolve("2.jsonl.gz")))) {
            gzip.write(second);
        }
        byte[] whole = Files.readAllBytes(games.resolve("2.jsonl.gz"));
        Files.write(games.resolve("3.jsonl.gz"), Arrays.copyOf(whole, whole.length / 2));
        Files.createSymbolicLink(games.resolve("4.jsonl"), Path.of("missing"));
        Cli cli = recorded(games, "near", near);
        assertEquals(1, cli.status(), cli.out());
        assertTrue(cli.out().startsWith("5 recorded games, near in the place of near\n"), cli.out());
        assertTrue(cli.out().contains("\nunchanged  3: "), cli.out());
        assertTrue(cli.out().contains("\nnot played 2\n"), cli.out());
        assertEquals(2, recorded(games.resolve("4.jsonl"), "near", near).status());
    }

    /** Without others nobody can be sent anything else: both scores stand beside each other. */
    @Test
    void aGameForOneHasScores() {
        Path replay = folder.resolve("search.jsonl");
        Cli.run("match", "--scene", "search-race", "--bot", "builtin:driver", "--seed", "3", "--time-factor", "20",
            "--out", replay.toString()).done();
        JsonNode game = recorded(replay, "0", "builtin:coaster", "--json", "--time-factor", "20").done().json()
            .get("games").get(0);
        assertEquals("unchanged", game.get("outcome").stringValue());
        assertTrue(game.get("score").doubleValue() > 0, game.toString());
        assertTrue(game.get("recordedScore").doubleValue() != game.get("score").doubleValue(), game.toString());
        assertTrue(game.get("points").isNull() && game.get("recorded").isNull(), game.toString());
    }
}
