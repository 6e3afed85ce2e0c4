package steward.cli.shared;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.live.Browser;
import steward.replay.page.PageExtras;
import steward.replay.page.ReplayPage;
import steward.text.TextFormat;

/** Pages that show a match, written and opened, with their titles. */
public final class Pages {

    private static final int TITLE = 80;

    private Pages() { }

    /** A page's heading. */
    public static String title(List<String> players) {
        return TextFormat.shorten(TextFormat.plain(String.join(" against ", players)), TITLE);
    }

    /** A path for a page without a given name. */
    public static Path unnamed() {
        try {
            return Files.createTempFile("steward-", ".html");
        } catch (IOException problem) {
            throw new InputException("--open: no temporary file for the page can be had: " + problem.getMessage());
        }
    }

    /**
     * The page of a recorded match.
     *
     * @throws steward.replay.ReplayException if it is damaged
     */
    public static byte[] of(Path replay, String title) {
        return ReplayPage.of(read(replay), replay.toString(), title, PageExtras.of(Games.types()));
    }

    public static byte[] read(Path replay) {
        try {
            return Files.readAllBytes(replay);
        } catch (IOException problem) {
            throw new UncheckedIOException(replay + ": cannot be read: " + problem.getMessage(), problem);
        }
    }

    /** Writes a file, a new one or also one that exists. */
    public static void write(Path file, byte[] content, boolean overwrite) {
        try (OutputStream out = OutputFiles.open(file, overwrite)) {
            write(out, content, file);
        } catch (IOException problem) {
            throw new FailedException(file + ": cannot be closed: " + problem.getMessage());
        }
    }

    public static void write(OutputStream file, byte[] html, Path path) {
        try {
            file.write(html);
            file.flush();
        } catch (IOException problem) {
            throw new FailedException(path + ": cannot be written: " + problem.getMessage());
        }
    }

    /** Opens a page in the browser. A failure to open it is only a warning, because the page exists. */
    public static void open(Streams streams, URI page) throws InterruptedException {
        String problem = Browser.ofSystem().open(page);
        if (problem != null) {
            streams.err().println("steward: no browser could be opened: " + problem + "; the page is at " + page);
        }
    }
}
