package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import tools.jackson.databind.JsonNode;

/** Why a bot lost: {@code match --why}, {@code league why} and the page of a league say alike. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class WhyTest {

    private static final String END = "at most 8 turns are played";

    @TempDir
    private Path folder;
    private String scene;
    private String near;
    private String far;
    private String bad;

    @BeforeEach
    void bots() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        ShellBots.shortDuel(folder);
        ShellBots.drawn(folder.resolve("short.json"));
        scene = folder.resolve("short.json").toString();
        ShellBots shell = new ShellBots(folder);
        near = shell.driver("near", ShellBots.CHECKPOINT);
        far = shell.driver("far", ShellBots.NOWHERE);
        bad = "bad=sh " + Files.writeString(folder.resolve("bad.sh"), """
            read setup; read first
            echo '[PDATA] depth = 4' >&2
            echo '{"pods":[{"x":1,"y":1,"thrust":100}]}'
            read second; exit 3
            """);
    }

    @Test
    void aMatchSaysHowTheFirstBotLost() {
        JsonNode why = Cli.run("match", "--scene", scene, "--bot", far, "--bot", near, "--games", "3", "--swap",
            "--seed", "1", "--why", "--json").json().get("why");
        assertEquals(6, why.get("lost").intValue());
        assertEquals(END, why.get("kinds").get(0).get("kind").stringValue());
        int behind = why.get("kinds").get(0).get("behindFrom").intValue();
        assertTrue(behind >= 1 && behind <= 8, "the other is nearer from the first turns on: " + behind);
        String won = Cli.run("match", "--scene", scene, "--bot", near, "--bot", far, "--games", "3", "--why").done()
            .out();
        assertTrue(won.contains("near lost 0 of 3 games, drew 0, won 3\n"), won);
    }

    /** A bot between the two others reports a number in each game; those that anybody lost are kept, so all are. */
    @Test
    void whatABotReportedStandsInLostAndWonGamesSideBySide() throws IOException {
        String tells = "tells=sh " + Files.writeString(folder.resolve("tells.sh"), "echo '[PDATA] depth = 4' >&2\n"
            + "exec sh '" + folder.resolve("pod.sh") + "' 9000 5200 0\n");
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--keep", "lost", "--seed", "1").done();
        for (String bot : new String[] {tells, near, far}) {
            Cli.run("league", "add", league, bot).done();
        }
        Cli.run("league", "run", league, "--games", "12").done();
        JsonNode why = Cli.run("league", "why", league, "tells", "--json").json();
        assertEquals(4, why.get("lost").intValue(), why.toString());
        assertEquals(4, why.get("won").intValue(), why.toString());
        JsonNode depth = why.get("values").get(why.get("values").size() - 2);
        assertEquals("depth", depth.get("name").stringValue(), why.toString());
        assertEquals(4, depth.get("lostMean").doubleValue());
        assertEquals(4, depth.get("wonMean").doubleValue(), why.toString());
        Cli unread = Cli.run("league", "why", league, "tells", "--replays", "0").done();
        assertTrue(unread.out().contains("Of 4 won games no replay was read: what bots reported"), unread.out());
    }

    /** All games of this scene are one: two are left, one from each seat. */
    @Test
    void gamesThatOnlyRepeatOthersAreLeftOut() throws IOException {
        ShellBots.shortDuel(folder);
        String text = Cli.run("match", "--scene", scene, "--bot", far, "--bot", near, "--games", "3", "--swap",
            "--seed", "1", "--why").done().out();
        assertTrue(text.contains("far lost 2 of 2 games, drew 0, won 0; 4 others only repeat games:"), text);
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--seed", "1").done();
        Cli.run("league", "add", league, near).done();
        Cli.run("league", "add", league, far).done();
        Cli.run("league", "run", league, "--games", "6").done();
        String why = Cli.run("league", "why", league, "far").done().out();
        assertTrue(why.contains("far lost 2 of 2 games, drew 0, won 0; 4 others only repeat games:"), why);
    }

    @Test
    void nobodyLosesWhereEachPlaysAlone() {
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", "search-race").done();
        Cli.run("league", "add", league, "builtin:driver").done();
        Cli.run("league", "run", league, "--games", "2").done();
        Cli.run("league", "why", league, "driver").assertRefused("found a league in which each plays alone");
    }

    /** The replays of a league, played again, say what was seen while a match was played. */
    @Test
    void aLeagueAndItsPageSayTheSame() throws IOException {
        String text = Cli.run("match", "--scene", scene, "--bot", bad, "--bot", near, "--games", "2", "--swap",
            "--seed", "1", "--why", "--out", folder.resolve("games").toString()).done().out();
        assertTrue(text.contains("bad lost 4 of 4 games, drew 0, won 0:\n"), text);
        assertTrue(text.contains("failed: exited with status 3"), text);
        assertTrue(text.contains("depth                        4.00 ± 0.00"), text);
        String league = folder.resolve("league").toString();
        Cli.run("league", "init", league, "--scene", scene, "--keep", "all", "--seed", "1").done();
        for (String bot : new String[] {bad, near, far}) {
            Cli.run("league", "add", league, bot).done();
        }
        Cli.run("league", "run", league, "--games", "12").done();
        JsonNode why = Cli.run("league", "why", league, "far", "--json").json();
        assertEquals(4, why.get("lost").intValue(), why.toString());
        assertEquals(4, why.get("won").intValue());
        assertEquals(END, why.get("kinds").get(0).get("kind").stringValue());
        assertTrue(Files.exists(Path.of(why.get("kinds").get(0).get("replay").stringValue())));
        JsonNode failed = Cli.run("league", "why", league, "bad", "--json").json();
        assertEquals("failed: exited with status 3 before answering",
            failed.get("kinds").get(0).get("kind").stringValue());
        assertTrue(failed.get("kinds").get(0).get("behindFrom").intValue() <= 2, "it failed in its second turn");
        String unread = Cli.run("league", "why", league, "far", "--replays", "0").done().out();
        assertTrue(unread.contains("Of 4 lost games no replay was read"), unread);
        Path page = folder.resolve("page.html");
        Cli.run("league", "page", league, "--out", page.toString()).done();
        assertTrue(Files.readString(page).contains("far lost 4 of 8 games, drew 0, won 4:"));
    }
}
