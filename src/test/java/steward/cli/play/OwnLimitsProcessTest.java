package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;

/** Bots with limits of their own, in a scene that gives them half a minute and more. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class OwnLimitsProcessTest extends ShellBotsCase {

    /** A bot that never answers. */
    private static final String MUTE = "mute=sleep 100";

    private String driver;
    private String scene;

    @BeforeEach
    void makeScene() throws IOException {
        ShellBots.shortDuel(folder);
        scene = folder.resolve("short.json").toString();
        driver = bots.driver("still", ShellBots.NOWHERE);
    }

    private Cli run(String call, String... more) {
        return Cli.run(List.of(call.replace("TMP", folder.toString()).split(" ")), more);
    }

    /** Every command that starts bots by name: 30 ms, times 2. */
    @ParameterizedTest
    @ValueSource(strings = {"match --seed 1 --bot", "match --games 1 --bot", "sprt --games 2 --bot",
        "play --json-league --scene"})
    void aBotIsOutAfterItsOwnLimit(String call) {
        boolean named = call.endsWith("--bot");
        Cli played = named ? run(call, MUTE, "--bot", driver, "--scene", scene, "--time-limit", "mute=20,30",
            "--time-factor", "2") : run(call, scene, MUTE.replace("=", "=json:"), driver.replace("=", "=json:"),
            "--time-limit", "mute=20,30",
            "--time-factor", "2");
        assertTrue((played.out() + played.err()).contains("no answer within 60 ms"),
            played.out() + played.err());
    }

    @Test
    void theTunedBotsLimitIsThatOfAllItsValues() {
        Cli ended = run("tune --games 16 --seeds 1 --time-limit mute=20,30 --scene " + scene, "--bot",
            "mute=sleep {s:100..200}", "--against", driver);
        assertEquals(1, ended.status(), ended.out() + ended.err());
        assertTrue(ended.out().contains("no answer within 30 ms"), ended.out() + ended.err());
    }

    @Test
    void theLimitsOfACheckAreThoseOfTheBot() {
        Cli check = run("check --time-limit mute=20,30 --scene " + scene, MUTE);
        assertEquals(1, check.status(), check.out() + check.err());
        assertTrue(check.out().contains("no answer within 30 ms"), check.out());
    }

    /** Nobody answers within 1 ms, but there are no deadlines. */
    @Test
    void withoutDeadlinesThereAreNoOwnLimitsEither() throws IOException {
        Path replay = folder.resolve("r.jsonl");
        String fault = run("match --no-deadline --json --time-limit still=1,1 --scene " + scene + " --out " + replay,
            "--bot", driver, "--bot", driver.replace("still=", "other=")).done().json().get("players").get(0)
            .get("fault").toString();
        assertEquals("null", fault);
        assertTrue(Files.readString(replay).contains("\"time\":{\"firstAnswerMs\":1,\"answerMs\":1}},"), "the header");
    }

    /** A bot is told its limits, a replay says them, and what it was sent follows from that. */
    @Test
    void aBotIsToldItsLimitsAndTheReplayToo() throws IOException {
        Path sent = folder.resolve("sent.txt");
        Path replay = folder.resolve("r.jsonl");
        run("match --time-limit told=40000,50000 --sandbox off --scene " + scene + " --out " + replay, "--bot", driver,
            "--bot", bots.witness("told", ShellBots.NOWHERE, 0, sent)).done();
        String lines = Files.readString(sent);
        assertTrue(lines.startsWith("{\"type\":\"setup\",\"game\":\"pod-race\",\"player\":1,\"players\":2,\"time\":"
            + "{\"firstAnswerMs\":50000,\"answerMs\":40000},"), lines);
        assertEquals(lines, run("replay " + replay + " --frames --player 1").done().out());
        assertTrue(run("replay " + replay + " --frames --player 0").done().out().contains("\"time\":"
            + "{\"firstAnswerMs\":60000,\"answerMs\":30000},"), "the other has those of the scene");
        run("replay " + replay + " --verify").done();
        String shown = run("replay " + replay).done().out();
        assertTrue(shown.contains(", answers within 40000 ms, the first within 50000 ms"), shown);
    }
}
