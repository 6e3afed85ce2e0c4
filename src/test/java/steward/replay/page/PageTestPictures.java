package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Pictures and clips that the page makes of a match, in a real browser. */
class PageTestPictures extends PageTestCase {

    /** Keeps what the page saves, in place of a file. */
    private static final String KEEP = """
        window.kept = [];
        URL.createObjectURL = blob => { kept.push(blob); return '#'; };
        HTMLAnchorElement.prototype.click = function () { window.keptName = this.download; };""";
    /** The colour of a pixel near the left end of a player's cell, as #rrggbb. */
    private static final String COLOUR = """
        const canvas = document.createElement('canvas');
        Object.assign(canvas, { width: image.width, height: image.height });
        const ctx = canvas.getContext('2d', { willReadFrequently: true });
        ctx.drawImage(image, 0, 0);
        const [...rgba] = ctx.getImageData(image.width / 2 * arguments[0] + 2, 20, 1, 1).data;
        return '#' + rgba.slice(0, 3).map(part => part.toString(16).padStart(2, '0')).join('');""";

    private static Path page;

    @BeforeAll
    static void play() {
        page = pages.page(PageTestRaces.play(PageTestRaces.scene("duel"), 5), "Duel");
    }

    /** Reads a kept picture as a browser does. */
    private static void read() {
        browser.run("createImageBitmap(kept[0]).then(image => (window.image = image))");
        browser.await("no image comes of it", () -> browser.is("window.image"));
    }

    /** A GIF begins with its name, and has its width and height in two bytes each, the low one first. */
    @Test
    void aRangeOfTurnsBecomesAGif() {
        browser.open(page, "#t=2");
        browser.run(KEEP);
        browser.press("r");
        assertEquals("2", browser.run("return document.getElementById('clip-from').value"));
        browser.run("document.getElementById('clip-from').value = 2;"
            + "document.getElementById('clip-to').value = 3.2; document.getElementById('clip-as').value = 'gif'");
        browser.click("button[value=make]");
        browser.await("no GIF is made", () -> browser.is("window.kept.length === 1"));
        assertTrue(browser.is("keptName.endsWith('-2-3.2.gif') && kept[0].type === 'image/gif'"));
        browser.run("kept[0].arrayBuffer().then(bytes => (window.gif = new Uint8Array(bytes)))");
        browser.await("it is not read", () -> browser.is("window.gif"));
        assertEquals("GIF89a", browser.run("return String.fromCharCode(...gif.subarray(0, 6))"));
        assertTrue(browser.is("(gif[6] | gif[7] << 8) <= 640"));
        read();
        assertTrue(browser.is("image.width === (gif[6] | gif[7] << 8)"), "a browser reads it");
    }

    /** The strip at the top of the picture has a cell for each player, with a bar in its colour. */
    @Test
    void thePictureHasThePlayersOfTheMatch() {
        browser.open(page, "#t=2");
        browser.run(KEEP);
        browser.press("p");
        browser.await("no picture is made", () -> browser.is("window.kept.length === 1"));
        read();
        for (int player = 0; player < 2; player++) {
            assertEquals(browser.run("return steward.colourOf(arguments[0])", player), browser.run(COLOUR, player));
        }
    }

    /** In a frame without an origin, such as a notebook's, files cannot be saved. */
    @Test
    void aPageThatMaySaveNothingOpensItsPicture() throws IOException {
        Path outer = Files.writeString(folder.resolve("outer.html"), "<!DOCTYPE html><iframe width=\"800\" "
            + "height=\"500\" sandbox=\"allow-scripts\" src=\"" + page.getFileName() + "#t=3\"></iframe>");
        browser.openPlain(outer);
        browser.enterFrame();
        browser.run("document.querySelector('[data-key=p]').click()");
        browser.await("no picture is there", () ->
            browser.is("document.querySelector('.sheet-content img')?.naturalWidth > 400"));
        assertTrue(browser.text(".sheet-content").startsWith("Save it from here"), browser.text(".sheet-content"));
    }

    @Test
    void aLinkToAPictureShowsNoControls() {
        browser.open(page, "#t=3&picture");
        assertEquals(3, browser.number("steward.time()"));
        assertTrue(browser.is("[...document.querySelectorAll('button, aside, .transport')]"
            + ".every(each => !each.offsetWidth)"));
        assertTrue(browser.is("document.getElementById('field').offsetWidth === innerWidth"), "the field is all");
        assertTrue(browser.text("#scores").contains("swift"), browser.text("#scores"));
    }

    @Test
    void aPhoneHasTheButtonsToShare() {
        browser.size(390, 800);
        browser.open(page, "#t=3");
        assertTrue(browser.is("[...document.querySelectorAll('.controls .share')].length === 3 "
            + "&& [...document.querySelectorAll('.controls .share')].every(each => each.offsetWidth > 40)"));
        assertTrue(browser.is("document.documentElement.scrollWidth <= innerWidth"), "nothing is wider");
    }
}
