package steward.cli.options;

import java.io.IOException;
import java.net.UnknownHostException;
import picocli.CommandLine.Option;
import steward.files.InputException;
import steward.live.LiveServer;

/** Options for a live page that follows the games that are played. */
@OptionSection("Watching")
public final class WatchOptions {

    private static final int MOST_PORT = 65_535;

    @Option(names = "--watch", description = "Serves a live page of the games to browsers on this machine.")
    private boolean watch;

    @Option(names = "--port", paramLabel = "N", description = "The port of --watch (default: any free port).")
    private Integer port;

    @Option(names = "--host", paramLabel = "NAME", description = "The address that --watch listens on (default: "
        + "loopback). On another address, everybody who can reach this machine can watch, without a password and "
        + "unencrypted.")
    private String host;

    @Option(names = "--viewers", paramLabel = "N", description = "How many browsers --watch serves at the same time "
        + "(default: " + LiveServer.USUAL_VIEWERS + ").")
    private Integer viewers;

    /** Refuses what does not go together. */
    public void check(CallCheck check) {
        check.that(watch || port == null && host == null && viewers == null,
            (port != null ? "--port" : host != null ? "--host" : "--viewers") + " is for --watch, expected both");
        check.that(host == null || !host.isEmpty(), "--host: found an empty text, expected NAME");
        check.range("--port", port, 0, MOST_PORT);
        check.range("--viewers", viewers, 1, LiveServer.MOST_VIEWERS);
    }

    /** The refusal of a call whose host is unknown or whose port is taken. */
    public InputException cannotListen(IOException problem) {
        return new InputException("--watch: cannot listen on " + (host == null ? "" : host + ", ") + "port " + port()
            + ": " + (problem instanceof UnknownHostException ? "found no such host" : problem.getMessage()));
    }

    public boolean watch() {
        return watch;
    }

    /** 0 for any free one. */
    public int port() {
        return port == null ? 0 : port;
    }

    /** {@code null} for this machine alone. */
    public String host() {
        return host;
    }

    public int viewers() {
        return viewers == null ? LiveServer.USUAL_VIEWERS : viewers;
    }
}
