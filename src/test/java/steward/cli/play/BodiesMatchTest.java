package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A scene of somebody's own is played between two programs, one of JSON and one of lines, and verifies. */
@Tag("process")
class BodiesMatchTest {

    private static final String SCENE = """
        { "name": "push", "game": "bodies", "players": 2, "time": { "firstAnswerMs": 10000, "answerMs": 10000 },
          "field": { "width": 400, "height": 200, "walls": "box" },
          "bodies": { "listed": [ { "x": 100, "y": 100, "radius": 10, "owner": 0 },
            { "x": 300, "y": 101, "radius": 10, "owner": 1 } ] },
          "play": { "maximumTurns": 30, "maximumThrust": 2, "contactPoints": 3 },
          "accuracy": { "advance": "event", "arithmetic": "exact" } }
        """;
    private static final String JSON = """
        read setup
        while read frame; do echo '{"thrusts":[{"x":1,"y":0}]}'; done
        """;
    private static final String LINES = """
        for line in 1 2 3; do read setup; done
        while read scores; do read one; read other; echo '-1 0 here I come'; done
        """;

    @TempDir
    private Path folder;

    private String written(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text).toString();
    }

    @Test
    void twoProgramsPushOneDiscEach() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        String replay = folder.resolve("push.jsonl").toString();
        Cli match = Cli.run("match", "--scene", written("push.json", SCENE), "--sandbox", "off", "--seed", "1",
            "--json", "--out", replay, "--bot", "a=sh " + written("a.sh", JSON), "--bot",
            "b=codingame:sh " + written("b.sh", LINES));
        assertEquals(ExitStatus.DONE, match.status(), match.err());
        JsonNode players = JsonMapper.shared().readTree(match.out()).get("players");
        int score = players.get(0).get("score").asInt();
        assertTrue(score > 0 && score % 3 == 0, match.out());
        assertEquals(score, players.get(1).get("score").asInt(), "each impact is a contact of both");
        assertTrue(Files.readString(Path.of(replay)).contains("here I come"));
        Cli verified = Cli.run("replay", replay, "--verify");
        assertEquals(ExitStatus.DONE, verified.status(), verified.err());
    }
}
