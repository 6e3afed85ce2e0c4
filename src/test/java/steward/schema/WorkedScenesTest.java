package steward.schema;

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
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Scenes of the page of scenes, made and run as they stand there; what the page says of them is what is printed. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class WorkedScenesTest {

    private static final String PAGE = "docs/scenes.md";
    private static final String AT_REST = " turns, all bodies are slower than the scene's restBelow";

    @TempDir
    private Path folder;
    private PageShell shell;

    @BeforeEach
    void prepare() throws IOException {
        PageShell.need("python3");
        shell = new PageShell(folder, "");
        for (String file : List.of("plot.py", "break.json", "balls.csv")) {
            Files.copy(Path.of("docs/scenes", file), folder.resolve(file));
        }
    }

    private void scene(String name) throws IOException {
        Files.writeString(folder.resolve(name + ".json"),
            PageShell.fenced(PAGE, "```json\\R(\\{ \"name\": \"" + name + "\".*?)```", 0));
    }

    private static void assertSays(String words) throws IOException {
        assertTrue(Files.readString(Path.of(PAGE)).replaceAll("\\s+", " ").contains(words), words);
    }

    /** From the middle of its first parabola, at a speed of 1, it falls n (n + 1) u in n turns: 690 u in turn 26. */
    @Test
    void aBallIsDroppedAndPlotted() throws IOException, InterruptedException {
        scene("drop");
        shell.run(0, PAGE, "steward run drop.json", AT_REST);
        shell.run(0, PAGE, "steward replay drop.jsonl", "verified: ");
        assertTrue(Files.size(folder.resolve("drop.html")) > 10_000);
        assertEquals("26", Files.readAllLines(folder.resolve("drop/impacts.csv")).get(1).split(",")[0]);
        shell.run(0, PAGE, "python3 plot.py drop/states.csv y");
        String plot = Files.readString(folder.resolve("drop.svg"));
        assertTrue(plot.contains("y [u]: 100 to 7"), plot);
        assertEquals(Files.readAllLines(folder.resolve("drop/states.csv")).size() - 1,
            plot.split("points=\"")[1].split("\"")[0].split(" ").length);
    }

    @Test
    void aBreakHasPockets() throws IOException, InterruptedException {
        shell.runLine(0, "steward run break.json --out break.jsonl", AT_REST);
        assertSays("`steward run break.json` pots three");
        assertEquals(3, Files.readString(folder.resolve("break.jsonl")).split("\"kind\":\"death\"", -1).length - 1);
    }

    @Test
    void theDiscsOfABowlComeToRest() throws IOException, InterruptedException {
        scene("my-bowl");
        shell.runLine(0, "steward run my-bowl.json --seed 7", AT_REST);
        assertSays("It comes to rest, as `steward run my-bowl.json --seed 7` does");
    }
}
