package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.Recorded;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.scene.SceneFiles;

/** {@code steward replay --frames}: exactly the lines that a bot wrote down as it played. */
@Timeout(60)
class FramePrinterTest {

    @TempDir
    private Path folder;

    private void same(Recorded recorded) throws IOException {
        Path file = Files.write(folder.resolve("x.jsonl"), recorded.bytes());
        for (int player = 0; player < recorded.sent().size(); player++) {
            Cli cli = Cli.run("replay", file.toString(), "--frames", "--player", Integer.toString(player)).done();
            assertEquals(recorded.sent().get(player).toString(), cli.out());
        }
    }

    @Test
    void ofBothBotsOfADuel() throws IOException {
        same(Recorded.duel(11));
    }

    /** The first turn with the line before it. */
    @Test
    void ofOneTurn() throws IOException {
        Recorded recorded = Recorded.duel(11);
        Path file = Files.write(folder.resolve("x.jsonl"), recorded.bytes());
        List<String> lines = recorded.sent().get(1).toString().lines().toList();
        String[] call = {"replay", file.toString(), "--frames", "--player", "1", "--turn", "1"};
        assertEquals(lines.get(0) + "\n" + lines.get(1) + "\n", Cli.run(call).out());
        call[6] = "7";
        assertEquals(lines.get(7) + "\n", Cli.run(call).out());
        String turn = Cli.run("replay", file.toString(), "--turn", "7").out();
        assertTrue(turn.contains("  sent     " + lines.get(7) + "\n"), turn);
        assertEquals(lines.get(7) + "\n", Cli.run("replay", file.toString(), "--turn", "7", "--json").json().get("sent")
            .get(1).stringValue());
    }

    /** What was recorded is shown all the same. */
    @Test
    void ofAMatchThatCannotBePlayedAgain() throws IOException {
        Path file = Files.writeString(folder.resolve("x.jsonl"),
            new String(Recorded.duel(11).bytes(), StandardCharsets.UTF_8)
                .replaceFirst("\"thrust\":120", "\"thrust\":7"));
        Cli turn = Cli.run("replay", file.toString(), "--turn", "7").done();
        assertTrue(turn.out().contains("what bots were sent is not known: ")
            && turn.out().contains("state after the turn"), turn.out());
    }

    @Test
    void aBotThatFailedWasSentThatTurnAndNothingMore() throws IOException {
        Recorded recorded = Recorded.play(Games.open("duel"), 11, "df", 5);
        assertTrue(recorded.result().anyFault());
        assertEquals(6, recorded.sent().get(1).toString().lines().count());
        same(recorded);
    }

    /** Of three, one stands and is out by the rules while the others go on: no more turns for it, but the end. */
    @Test
    void aBotThatIsOutWasStillSentTheEnd() throws IOException {
        String three = SceneFiles.load("duel").text().replace("\"players\": 2", "\"players\": 3")
            .replace("\"turnsWithoutCheckpoint\": 50", "\"turnsWithoutCheckpoint\": 39");
        Path scene = Files.writeString(folder.resolve("three.json"), three);
        Recorded recorded = Recorded.play(Games.open(scene.toString()), 2, "dsd", 0);
        String sent = recorded.sent().get(1).toString();
        assertTrue(recorded.result().turns() > 40, recorded.result().ending());
        assertEquals(42, sent.lines().count());
        assertTrue(sent.lines().skip(41).findFirst().orElseThrow().startsWith("{\"type\":\"end\""));
        same(recorded);
    }

    @Test
    @Tag("process")
    void ofABotProgramThatKeptItsInput() throws IOException {
        ShellBots bots = new ShellBots(folder);
        Path[] kept = {folder.resolve("kept0"), folder.resolve("kept1")};
        Path file = folder.resolve("x.jsonl");
        Cli.run("match", "--scene", "duel", "--no-deadline", "--out", file.toString(),
            "--bot", bots.witness("a", ShellBots.CHECKPOINT, 0, kept[0]),
            "--bot", bots.witness("b", ShellBots.CHECKPOINT, 9, kept[1])).done();
        for (int player = 0; player < kept.length; player++) {
            Cli cli = Cli.run("replay", file.toString(), "--frames", "--player", Integer.toString(player));
            assertEquals(Files.readString(kept[player]), cli.out());
        }
        assertEquals(10, Files.readAllLines(kept[1]).size());
    }

    /** With one pod each there are two lines a turn, the own pod and the other, and none before and after. */
    @Test
    @Tag("process")
    void ofABotThatSpeaksLines() throws IOException {
        Path kept = folder.resolve("kept");
        Path file = folder.resolve("x.jsonl");
        String bot = "codingame:sh -c 'while IFS= read -r own && IFS= read -r other; do "
            + "printf \"%s\\n%s\\n\" \"$own\" \"$other\" >>" + kept + "; echo " + ShellBots.CHECKPOINT + " 100; done'";
        Cli match = Cli.run("match", "--scene", "duel", "--time-factor", "100", "--out", file.toString(), "--bot", bot,
            "--bot", new ShellBots(folder).driver("far", ShellBots.NOWHERE), "--json");
        assertTrue(match.json().get("players").get(0).get("fault").isNull(), match.out());
        assertEquals(Files.readString(kept),
            Cli.run("replay", file.toString(), "--frames", "--player", "0").out());
        assertEquals(2 * match.json().get("turns").intValue(), Files.readAllLines(kept).size());
    }

    @Test
    void ofACutReplayUpToTheCut() throws IOException {
        Recorded recorded = Recorded.duel(11);
        byte[] half = Arrays.copyOf(recorded.bytes(), recorded.bytes().length / 2);
        Path file = Files.write(folder.resolve("cut.jsonl"), half);
        Cli cli = Cli.run("replay", file.toString(), "--frames", "--player", "0").done();
        assertTrue(cli.err().contains("cut off"), cli.err());
        assertTrue(recorded.sent().get(0).toString().startsWith(cli.out()));
        assertFalse(cli.out().contains("\"type\":\"end\""));
    }

    @Test
    void ofAnEditedReplayEndsWhereItDiffers() throws IOException {
        String text = new String(Recorded.duel(11).bytes(), StandardCharsets.UTF_8);
        String edited = text.replaceFirst("(\"turn\":4,\"commands\":\\[\\[\\{.*?\"thrust\":)120", "$1121");
        assertFalse(text.equals(edited));
        Path file = Files.writeString(folder.resolve("edited.jsonl"), edited);
        Cli cli = Cli.run("replay", file.toString(), "--frames", "--player", "0");
        assertEquals(ExitStatus.FAILED, cli.status());
        assertTrue(cli.err().contains("turn 4 differs"), cli.err());
    }
}
