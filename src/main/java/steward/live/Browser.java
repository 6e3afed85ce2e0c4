package steward.live;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import steward.bot.command.ProgramFinder;

/** Web browser of the user, opened through the system's own program for that. */
public final class Browser {

    /**
     * A program that cannot open anything fails at once; one that runs longer than this, in milliseconds, has opened
     * it.
     */
    private static final long FAILS_WITHIN_MS = 1500;

    /** Variables of which one is set where there is a display. */
    private static final List<String> DISPLAYS = List.of("DISPLAY", "WAYLAND_DISPLAY", "BROWSER");

    private static final String NO_DISPLAY = "there is no display to show it on";

    private final List<String> opener;

    /** @param opener a program that takes an address as its last argument; none where nothing can be shown */
    Browser(List<String> opener) {
        this.opener = opener;
    }

    public static Browser ofSystem() {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        if (system.contains("mac")) {
            return new Browser(List.of("open"));
        }
        if (system.contains("windows")) {
            return new Browser(List.of("rundll32", "url.dll,FileProtocolHandler"));
        }
        // Without a display xdg-open would start a browser in the terminal, which this program uses.
        return new Browser(DISPLAYS.stream().anyMatch(name -> System.getenv(name) != null)
            ? List.of("xdg-open") : List.of());
    }

    /** Returns why no page can be opened, or {@code null} if there is a program that may. */
    public String missing() {
        return opener.isEmpty() ? NO_DISPLAY
            : ProgramFinder.find(opener.get(0)) == null ? "there is no " + opener.get(0) : null;
    }

    /** Opens an address; does not wait for the browser to end. @return {@code null}, or why it could not be opened */
    public String open(URI address) throws InterruptedException {
        if (opener.isEmpty()) {
            return NO_DISPLAY;
        }
        List<String> words = new ArrayList<>(opener);
        words.add(address.toString());
        Process process;
        try {
            process = new ProcessBuilder(words).redirectInput(nothing()).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        } catch (IOException missing) {
            return "there is no " + opener.get(0);
        }
        boolean ended = process.waitFor(FAILS_WITHIN_MS, TimeUnit.MILLISECONDS);
        return !ended || process.exitValue() == 0 ? null
            : opener.get(0) + " exited with status " + process.exitValue();
    }

    /** No input: a text-mode browser must not take what is typed. */
    private static ProcessBuilder.Redirect nothing() {
        boolean windows = File.separatorChar == '\\';
        return ProcessBuilder.Redirect.from(new File(windows ? "NUL" : "/dev/null"));
    }
}
