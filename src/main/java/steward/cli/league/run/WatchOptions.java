package steward.cli.league.run;

import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;

/** The options of the page that follows a run. */
final class WatchOptions {

    private static final int MOST_PORT = 65_535;

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--watch", description = "Serves a page that shows the league while it is played, to browsers on "
        + "this machine.")
    private boolean watch;

    @Option(names = "--port", paramLabel = "N", description = "Where --watch serves (default: any free port).")
    private Integer port;

    @Option(names = "--host", paramLabel = "NAME", description = "The address that --watch listens on (default: "
        + "loopback). With another, everybody who reaches this machine can watch, unasked and unencrypted.")
    private String host;

    @Option(names = "--open", description = "Opens the page of --watch in the browser.")
    private boolean open;

    /** Refuses options that do not go together. */
    void check() {
        check.that(watch || port == null && host == null && !open,
            (port != null ? "--port" : host != null ? "--host" : "--open") + " is for --watch, expected both");
        check.that(host == null || !host.isEmpty(), "--host: found an empty text, expected NAME");
        check.range("--port", port, 0, MOST_PORT);
    }

    boolean watch() {
        return watch;
    }

    /** 0 for any free one. */
    int port() {
        return port == null ? 0 : port;
    }

    /** {@code null} for this machine alone. */
    String host() {
        return host;
    }

    boolean open() {
        return open;
    }
}
