package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Kept replays of a page of many games: up to a size in it, the others in pages beside it. */
class PageReplaysTest {

    private static final String SECRET = "nobody else may read this";

    @TempDir
    private Path folder;

    /** Room for one and a half games, so that one is in the page; the one that is no replay is in neither. */
    @Test
    void whatIsTooMuchForThePageHasPagesBesideIt() throws IOException {
        byte[] race = PageTestPages.withStderr(PageTestRaces.play(PageTestRaces.scene("duel"), 5), SECRET);
        Path file = Files.write(folder.resolve("race.jsonl"), race);
        Path broken = Files.writeString(folder.resolve("broken.jsonl"), "hello\n");
        List<PageReplays.Kept> kept = List.of(new PageReplays.Kept(7, broken, "seven", null),
            new PageReplays.Kept(8, file, "eight", null), new PageReplays.Kept(9, file, "nine", seat -> false),
            new PageReplays.Kept(10, broken, "ten", null));
        long one = ReplayPage.embedded(file, null, null).replay().length();
        PageReplays replays = PageReplays.of(kept, null, one * 3 / 2);
        assertEquals(List.of(8L), List.copyOf(replays.embedded().keySet()));
        assertEquals(List.of(9L, 10L), replays.beyond().stream().map(PageReplays.Kept::game).toList());
        Map<Long, String> linked = replays.writeBeside(folder.resolve("series.html"), null);
        assertEquals(Map.of(9L, "series-games/9.html"), linked);
        String page = Files.readString(folder.resolve("series-games/9.html"), StandardCharsets.UTF_8);
        assertTrue(page.contains("<title>nine</title>"));
        assertFalse(Files.exists(folder.resolve("series-games/10.html")));
        assertFalse(new String(PageTestPages.embedded(page), StandardCharsets.UTF_8).contains(SECRET),
            "stderr that the reader may not see");
        assertTrue(new String(PageTestPages.unpacked(ReplayPage.embedded(file, null, null).replay()),
            StandardCharsets.UTF_8).contains(SECRET), "it is there otherwise");
    }
}
