package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.bot.process.BotProcess;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import steward.contest.Contest;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.minigame.MiniScenes;
import tools.jackson.databind.JsonNode;

/** Which bot of a match speaks which protocol, and what bots that speak in lines leave in results and replays. */
@Tag("process")
@Timeout(60)
class ProtocolTest extends ShellBotsCase {

    /** Two lines a turn are read; in the fourth an answer is written twice; data is reported. */
    private static final String LINES = """
        #!/bin/sh
        turn=0
        while read -r a; do
          read -r b
          turn=$((turn + 1))
          echo "[PDATA] turn = $turn" >&2
          echo "[PDATA+] asked = 1" >&2
          echo "[TDATA] scene = silver" >&2
          early=
          [ $turn != 4 ] || early="10500 3500 90 early\\n"
          printf "${early}10500 3500 100 message $turn\\n"
        done
        """;

    private String lines;

    @BeforeEach
    void writeBot() throws IOException {
        lines = "sh " + Files.writeString(folder.resolve("lines.sh"), LINES);
    }

    private static JsonNode match(String... arguments) {
        return Cli.run(List.of("match", "--scene=duel", "--seed=1", "--no-deadline", "--json"), arguments).done()
            .json();
    }

    @Test
    void messagesDataAndWarningsReachResultAndReplay() throws IOException {
        Path file = folder.resolve("x.jsonl");
        JsonNode result = match("--out", file.toString(), "--bot", "a=codingame:" + lines,
            "--bot", bots.driver("b", ShellBots.CHECKPOINT));
        int turns = result.get("turns").intValue();
        JsonNode player = result.get("players").get(0);
        assertEquals("{\"scene\":\"silver\"}", result.get("data").toString());
        // From the fifth turn on, answers are there before the bot has written to stderr: what it says comes later.
        String told = player.get("data").get("turn").stringValue();
        assertEquals(told, player.get("data").get("asked").stringValue());
        assertTrue(Math.abs(Integer.parseInt(told) - turns + 1) <= 1, told + " of " + turns);
        assertEquals("{}", result.get("players").get(1).get("data").toString());
        assertTrue(player.get("warnings").toString().matches("\\[\"lines beyond the answer in \\d+ turns?\"]"),
            player.toString());
        List<String> replay = Files.readAllLines(file);
        assertTrue(replay.get(0).contains("\"protocol\":\"codingame\"") && replay.get(0).contains("\"json\""));
        assertTrue(replay.get(3).contains("\"messages\":[\"message 3\",null]"), replay.get(3));
        assertTrue(replay.get(4).contains("\"messages\":[\"early\",null]"), replay.get(4));
        assertTrue(replay.get(5).contains("\"messages\":[\"message 4\",null]"), replay.get(5));
        String last = replay.get(replay.size() - 1);
        assertTrue(last.contains("\"data\":{\"asked\":\"" + told + "\",\"turn\":\"" + told + "\"}"), last);
        assertTrue(last.contains("\"data\":{\"scene\":\"silver\"}"), last);
        assertEquals("verified: states of " + turns + " of " + turns + " turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
        String table = Cli.run("replay", file.toString()).out();
        assertTrue(table.contains("warning: a wrote more lines than it was asked for, in "), table);
        String frames = Cli.run("replay", file.toString(), "--frames", "--player", "0").out();
        assertEquals(2L * turns, frames.lines().count(), "a single-pod turn is two lines, and there is no setup");
    }

    /** A match in which one bot uses a protocol that the scene does not have is refused before anything starts. */
    @Test
    void aSceneWithoutTheProtocolIsRefusedUpFront() {
        GameSetup mute = MiniScenes.pond("\"players\": 3", "\"players\": 2");
        List<Contest.Entrant> mixed = List.of(new Contest.Entrant("a", "./a", Protocol.JSON, List.of("./a")),
            new Contest.Entrant("b", "codingame:./b", Protocol.CODINGAME, List.of("./b")));
        InputException problem = assertThrows(InputException.class, () -> Contest.checkPlayable(mute, mixed));
        assertEquals("bot 'codingame:./b': the scene \"pond\" has no codingame protocol, "
            + "expected a bot that speaks json", problem.getMessage());
        Contest.checkPlayable(mute, mixed.subList(0, 1));
        List<Seat> seats = mixed.stream().map(entrant ->
            new Seat(new BotProcess(entrant.name(), entrant.words()), entrant.protocol())).toList();
        assertEquals("the scene \"pond\" has no codingame protocol, expected bots that speak json",
            assertThrows(IllegalArgumentException.class, () -> Referee.of(mute, 1, seats, TimeControl.UNLIMITED,
                new MatchListener() { })).getMessage());
    }
}
