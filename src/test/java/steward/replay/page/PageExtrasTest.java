package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The head of a page for previews of links. */
class PageExtrasTest {

    @ParameterizedTest
    @CsvSource({"https://ex.org/a.html,https://ex.org/a.png", "https://ex.org/g/final,https://ex.org/g/final.png",
        "https://ex.org/race/,https://ex.org/race/index.png", "https://ex.org,https://ex.org/index.png",
        "https://ex.org/a.htm?id=3#t=1,https://ex.org/a.png"})
    void thePictureIsBesideThePage(String site, String picture) {
        assertEquals(picture, PageExtras.picture(site));
    }

    @Test
    void thePageNamesIt() {
        String head = new PageExtras(null, "https://ex.org/a/", "A race").meta("Race");
        assertTrue(head.contains("property=\"og:image\" content=\"https://ex.org/a/index.png\""), head);
    }
}
