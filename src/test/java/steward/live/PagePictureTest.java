package steward.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.page.PageTestPages;

/** Pictures that a browser takes of pages. */
@Tag("process")
@Tag("slow")
class PagePictureTest {

    @TempDir
    private Path folder;

    @Test
    void aPageThatShowsAnErrorIsNoPicture() throws IOException, InterruptedException {
        assumeTrue(ProgramFinder.find("chromium") != null, "there is no chromium");
        Path page = new PageTestPages(folder)
            .page(Recorded.of(TestScenes.open("cradle"), 7, List.of()).bytes(), "Cradle");
        Path png = folder.resolve("cradle.png");
        PagePicture.take(page, 3.5, png);
        assertTrue(Files.size(png) > 10_000, "an empty picture");

        Path broken = Files.writeString(folder.resolve("broken.html"),
            Files.readString(page).replaceFirst("(?s)(type=\"application/octet-stream\"[^>]*>)[^<]*", "$1<\"&"));
        Path none = folder.resolve("none.png");
        IOException problem = assertThrows(IOException.class, () -> PagePicture.take(broken, 3.5, none));
        assertTrue(problem.getMessage().startsWith("the page shows an error: "), problem.getMessage());
        assertFalse(Files.exists(none));

        Path silent = Files.writeString(folder.resolve("silent.html"),
            Files.readString(page).replace("default-src 'none'; script-src", "default-src 'none'; script-src-attr"));
        assertEquals("the page shows an error: its script has not come to its end",
            assertThrows(IOException.class, () -> PagePicture.take(silent, 3.5, none)).getMessage());
    }
}
