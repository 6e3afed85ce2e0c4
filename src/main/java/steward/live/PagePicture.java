package steward.live;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.command.ProgramFinder;
import steward.files.Folders;
import steward.replay.page.PageTemplate;

/** Screenshot of a page, taken with a browser of the Chromium family that is on the PATH. */
public final class PagePicture {

    private static final List<String> BROWSERS = List.of("chromium", "chromium-browser", "google-chrome", "chrome",
        "microsoft-edge", "msedge");
    /** The size that previews of links have, in CSS pixels. */
    private static final String SIZE = "1200,630";
    private static final int MOST_SECONDS = 60;
    /** Mark of a page that could not show its match: an attribute of its body with the reason. */
    private static final Pattern PROBLEM = Pattern.compile("<body[^>]* data-problem=\"([^\"]*)\"");

    private PagePicture() { }

    /**
     * Takes the picture.
     *
     * @param page a page that is a file
     * @param time in turns
     * @param png  is written; a file that is there is replaced
     * @throws IOException if there is no browser, it takes no picture, the page shows an error, or the file cannot be
     *                     written
     */
    public static void take(Path page, double time, Path png) throws InterruptedException, IOException {
        Path browser = browser();
        Path profile = Files.createTempDirectory("steward-picture");
        try {
            Path taken = profile.resolve("picture.png");
            Path elements = profile.resolve("page.html");
            ProcessBuilder call = new ProcessBuilder(browser.toString(), "--headless", "--no-sandbox", "--disable-gpu",
                "--hide-scrollbars", "--force-prefers-reduced-motion",
                "--blink-settings=preferredColorScheme=0", "--user-data-dir=" + profile.resolve("profile"),
                "--window-size=" + SIZE, "--virtual-time-budget=4000", "--screenshot=" + taken, "--dump-dom",
                page.toUri() + "#t=" + time + "&picture")
                .redirectError(ProcessBuilder.Redirect.DISCARD).redirectOutput(elements.toFile());
            call.environment().put("TMPDIR", profile.toString());   // Chromium leaves its socket behind
            Process process = call.start();
            if (!process.waitFor(MOST_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly().waitFor();
            }
            if (!Files.isRegularFile(taken)) {
                throw new IOException(browser + " took no picture");
            }
            Matcher problem = PROBLEM.matcher(Files.readString(elements));
            if (problem.find()) {
                throw new IOException("the page shows an error: " + PageTemplate.unescape(problem.group(1)));
            }
            Files.write(png, Files.readAllBytes(taken));
        } finally {
            try {
                Folders.delete(profile);
            } catch (IOException inUse) {
                profile.toFile().deleteOnExit();
            }
        }
    }

    private static Path browser() throws IOException {
        return BROWSERS.stream().map(ProgramFinder::find).filter(Objects::nonNull).findFirst().orElseThrow(() ->
            new IOException("found no browser on the PATH, expected one of " + String.join(", ", BROWSERS)
                + "; or open the page and press P"));
    }
}
