package steward.cli.play;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.concurrent.CompletableFuture;
import steward.cli.options.DisplayOptions;
import steward.cli.options.WatchOptions;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.cli.streams.EnterKey;
import steward.cli.streams.Streams;
import steward.cli.streams.TeeOutputStream;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.live.LiveRecording;
import steward.live.LiveServer;
import steward.replay.page.PageExtras;
import steward.replay.page.ReplayPage;

/**
 * Display of a match: a page in a file, a page that follows the match while it is played, or both. Bytes written here
 * are kept in memory until the match has been shown.
 */
final class MatchDisplay implements AutoCloseable {

    /** How long a match waits for its first viewer when it cannot be continued from the terminal, in milliseconds. */
    private static final long VIEWER_MS = 60_000;
    /** How often a match that waits without end checks for viewers, in milliseconds. */
    private static final long GLANCE_MS = 100;
    /** How long slow or silently disconnected viewers are served after the match, in milliseconds. */
    private static final long DELIVERY_MS = 10_000;
    /** How long their pages have to fetch the copy that they keep, in milliseconds. */
    private static final long COPY_MS = 3000;

    private final Streams streams;
    /** Where the addresses and files are printed. */
    private final PrintStream said;
    private final String title;
    private final boolean open;
    private final LiveRecording recording = new LiveRecording();
    private Path page;
    /** Where the page is written: beside its place, or at it if that is a device. */
    private Path part;
    private OutputStream pageFile;
    private LiveServer server;

    private MatchDisplay(Streams streams, PrintStream said, String title, boolean open) {
        this.streams = streams;
        this.said = said;
        this.title = title;
        this.open = open;
    }

    /**
     * Opens the file and starts to serve, so that neither can fail after the match.
     *
     * @param said   where to say what is where
     * @param title  of the pages
     * @param replay another file that is written, or {@code null}
     * @throws InputException if the file cannot be written or the port is taken
     */
    static MatchDisplay prepare(Streams streams, PrintStream said, DisplayOptions options, String title, Path replay,
                        boolean overwrite) {
        MatchDisplay show = new MatchDisplay(streams, said, title, options.open());
        try {
            if (options.view() != null || options.open() && !options.watch().watch()) {
                show.preparePage(options.view(), replay, overwrite);
            }
            if (options.watch().watch()) {
                show.server = serve(options.watch(), title, show.recording);
            }
            return show;
        } catch (InputException problem) {
            show.close();
            throw problem;
        }
    }

    private void preparePage(String typed, Path replay, boolean overwrite) {
        Path path = typed == null ? Pages.unnamed() : OutputFiles.path(typed);
        if (OutputFiles.isSame(path, replay)) {
            throw new InputException("--view: found the file of --out, expected another one");
        }
        OutputFiles.check(path, overwrite || typed == null);
        page = path;
        // An older page stays until the new one is complete: that is written beside it and then moved.
        part = Files.exists(path) && !Files.isRegularFile(path) ? path
            : path.resolveSibling("." + path.getFileName() + "." + ProcessHandle.current().pid() + ".part");
        try {
            pageFile = OutputFiles.open(part, true);
        } catch (InputException problem) {
            throw new InputException(problem.getMessage().replace(part.toString(), path.toString()));
        }
        if (part != page) {
            part.toFile().deleteOnExit();                                // also after Ctrl-C
        }
    }

    private static LiveServer serve(WatchOptions options, String title, LiveRecording recording) {
        try {
            return LiveServer.start(options.host(), options.port(), options.viewers(), title, recording,
                PageExtras.of(Games.types(true)));
        } catch (IOException problem) {
            throw options.cannotListen(problem);
        }
    }

    /** True if the match is watched while it is played. */
    boolean isWatched() {
        return server != null;
    }

    /** Returns the stream that a match is written to, from its start: here, and to its file if it has one. */
    OutputStream with(OutputStream file) {
        recording.clear();
        return file == null ? recording : new TeeOutputStream(file, recording);
    }

    /** Prints where the match can be watched and waits for a viewer: until Enter on a terminal, else a limited time. */
    void awaitViewer() throws InterruptedException {
        if (server == null) {
            return;
        }
        said.println("Watch the match at");
        said.println(server.address());
        said.println(streams.inTerminal() ? "Waiting for a browser. Enter plays without one, Ctrl-C ends."
            : "Waiting for a browser, at most " + VIEWER_MS / 1000 + " seconds.");
        said.flush();
        if (!server.isLoopback()) {
            streams.warn("whoever reaches this machine can watch the match");
        }
        if (open) {
            Pages.open(streams, server.address());
        }
        if (!streams.inTerminal()) {
            server.awaitViewer(VIEWER_MS);
            return;
        }
        CompletableFuture<Void> enter = EnterKey.pressed(streams);
        while (!enter.isDone() && !server.awaitViewer(GLANCE_MS)) {
            continue;
        }
    }

    /** After the match: writes its page, opens it, and waits until the viewers have seen the end. */
    void finish() throws InterruptedException {
        recording.close();
        if (page != null) {
            Pages.write(pageFile, ReplayPage.of(recording.replay(), "match", title, PageExtras.of(Games.types(true))),
                page);
            movePage();
            said.println("Page: " + page);
            said.flush();
            if (open && server == null) {
                URI address = page.toAbsolutePath().toUri();
                Pages.open(streams, address);
            }
        }
        if (server != null) {
            server.awaitDelivery(DELIVERY_MS, COPY_MS);
        }
    }

    private void movePage() {
        try {
            pageFile.close();
            if (part != page) {
                Files.move(part, page, StandardCopyOption.ATOMIC_MOVE);
            }
        } catch (IOException problem) {
            throw new FailedException(page + ": cannot be written: " + problem.getMessage());
        }
    }

    /** Ends the service; a page that was not written leaves no file. */
    @Override
    public void close() {
        recording.close();
        if (server != null) {
            server.close();
        }
        try {
            if (pageFile != null) {
                pageFile.close();
            }
            if (part != null && part != page) {
                Files.deleteIfExists(part);
            }
        } catch (IOException problem) {
            streams.warn(page + ": cannot be closed: " + problem.getMessage());
        }
    }
}
