package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.ShellBotsCase;
import tools.jackson.databind.JsonNode;

/** Why a bot lost, on the page of a league; {@code match --why} and {@code league why} are in golden files. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class WhyTest extends ShellBotsCase {

    private String scene;
    private String near;
    private String far;
    private String bad;
    @BeforeEach
    void writeBots() throws IOException {
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        scene = folder.resolve("short.json").toString();
        near = bots.driver("near", ShellBots.CHECKPOINT);
        far = bots.driver("far", ShellBots.NOWHERE);
        bad = "bad=sh " + Files.writeString(folder.resolve("bad.sh"), """
            read setup; read first
            echo '[PDATA] depth = 4' >&2
            echo '{"pods":[{"x":1,"y":1,"thrust":100}]}'
            read second; exit 3
            """);
    }

    @Test
    void thePageOfALeagueSaysIt() throws IOException {
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--keep", "all", "--seed", "1").done();
        for (String bot : new String[] {bad, near, far}) {
            Cli.run("league", "add", league, bot).done();
        }
        Cli.run("league", "run", league, "--games", "12").done();
        JsonNode why = Cli.run("league", "why", league, "far", "--json").json();
        assertTrue(Files.exists(Path.of(why.get("kinds").get(0).get("replay").stringValue())));
        Path page = folder.resolve("page.html");
        Cli.run("league", "page", league, "--out", page.toString()).done();
        assertTrue(Files.readString(page).contains("far lost 4 of 8 games, drew 0, won 4:"));
    }
}
