package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.cli.Cli;
import steward.replay.page.PageTestCase;
import steward.replay.page.PageTestRaces;

/** Two replays side by side in a real browser: one clock, what differs, and pairs that do not belong together. */
@Tag("slow")
@Timeout(300)
class BesidePageTest extends PageTestCase {

    private Path one;
    private List<String> lines;

    @BeforeEach
    void play() throws IOException {
        one = folder.resolve("one.jsonl");
        Files.write(one, PageTestRaces.play(PageTestRaces.scene("duel"), 5));
        lines = Files.readAllLines(one);
    }

    private Cli beside(Path other) {
        return Cli.run("replay", one.toString(), "--beside", other.toString(), "--view", folder + "/both.html",
            "--overwrite");
    }

    private Path other(List<String> text) throws IOException {
        return Files.writeString(folder.resolve("other.jsonl"),
            text.stream().collect(Collectors.joining("\n", "", "\n")));
    }

    /** All turns are equal, and another has won. */
    @Test
    void resultsThatDifferAreTold() throws IOException {
        int last = lines.size() - 1;
        lines.set(last, lines.get(last).replaceFirst("\"ending\":\"[^\"]*\"", "\"ending\":\"crashed\""));
        assertTrue(beside(other(lines)).out().endsWith("No turn of both differs; the results differ\n"));
        browser.open(folder.resolve("both.html"), "#t=4.00");
        browser.run("steward.seek(1e9)");
        assertTrue(browser.text("#h-differs").contains(": 1 difference"), browser.text("#h-differs"));
        assertTrue(browser.text("#differs").contains("crashed"), browser.text("#differs"));
    }

    /** Another thrust and another state in turn 5, and an end four turns earlier than the first match's. */
    @Test
    void theFirstTurnThatDiffersIsMarkedAndTheShorterMatchStops() throws IOException {
        int turns = lines.size() - 2;
        lines.set(5, lines.get(5).replaceFirst("\"thrust\":\\d+", "\"thrust\":77")
            .replaceFirst("\"vx\":-?\\d+", "\"vx\":4321").replaceFirst("\"hash\":\"....", "\"hash\":\"0000"));
        Cli cli = beside(other(lines.subList(0, turns - 3)));
        assertEquals(0, cli.status(), cli.err());
        assertTrue(cli.out().contains("The first turn that differs: 5; " + folder + "/other.jsonl ends after turn "
            + (turns - 4)), cli.out());
        browser.open(folder.resolve("both.html"), "#t=4.00");
        assertEquals("Turn 4: no difference · first turn that differs: 5", browser.text("#h-differs"));
        browser.click("#first");
        assertEquals(5, browser.number("steward.matches[0].time()"));
        assertEquals(5, browser.number("steward.matches[1].time()"));
        String differences = browser.text("#differs");
        assertTrue(differences.contains("command") && differences.contains("thrust 77"), differences);
        assertTrue(differences.contains(": vx") && differences.contains("4321"), differences);
        assertEquals(2, differences.lines().count(), differences);
        browser.run("steward.seek(1e9)");
        assertEquals(turns, browser.number("steward.matches[0].time()"));
        assertEquals(turns - 4, browser.number("steward.matches[1].time()"));
        assertTrue(browser.text("#h-differs").endsWith("one match is over"), browser.text("#h-differs"));
        for (int width : new int[] {390, 1280}) {
            browser.size(width, 800);
            assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), "wider than " + width);
        }
        assertEquals(List.of(), browser.requests(), "nothing is asked of a network");
    }

    @Test
    void equalMatchesHaveNoDifference() {
        assertTrue(beside(one).out().endsWith("No turn of both differs\n"));
    }

    @Test
    void matchesOfAnotherSeedSceneOrPlayersAreRefusedByName() throws IOException {
        String header = lines.get(0);
        refused("another seed in " + folder + "/other.jsonl: 6, expected 5",
            header.replace("\"seed\":\"5\"", "\"seed\":\"6\""));
        refused("other players in", header.replaceFirst("\"name\":\"[^\"]*\",\"bot\"", "\"name\":\"else\",\"bot\""));
        refused("another scene in", header.replaceFirst("\"maximumTurns\":\\d+", "\"maximumTurns\":9"));
    }

    private void refused(String words, String header) throws IOException {
        lines.set(0, header);
        Cli cli = beside(other(lines));
        assertEquals(2, cli.status(), words);
        assertTrue(cli.err().contains("--beside: found " + words), cli.err());
    }
}
