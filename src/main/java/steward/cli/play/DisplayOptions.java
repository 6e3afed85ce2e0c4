package steward.cli.play;

import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;

/** The options of a match by which people see it. */
final class DisplayOptions {

    private static final int MOST_PORT = 65_535;

    @Option(names = "--view", paramLabel = "HTML",
        description = "Writes a page that shows the match to this file: everything in it, opens from disk.")
    private String view;

    @Option(names = "--watch", description = "Serves a page that shows the match while it is played, to "
        + "browsers on this machine; see below.")
    private boolean watch;

    @Option(names = "--port", paramLabel = "N", description = "Where --watch serves (default: any free port).")
    private Integer port;

    @Option(names = "--host", paramLabel = "NAME",
        description = "The address that --watch listens on (default: loopback). With another, everybody who reaches "
            + "this machine can watch, unasked and unencrypted.")
    private String host;

    @Option(names = "--open",
        description = "Opens the page of --watch or --view, or one without a name, in the browser.")
    private boolean open;

    /** What is wrong with the options, or {@code null}. */
    String problem(boolean many) {
        if (many && isAny()) {
            return "--view, --watch and --open are for one match, expected no --games or --swap with them";
        }
        if (!watch && (port != null || host != null)) {
            return (port != null ? "--port" : "--host") + " is for --watch, expected both";
        }
        if (host != null && host.isEmpty()) {
            return "--host: found an empty text, expected NAME";
        }
        return port == null || CallCheck.isWithin(port, 0, MOST_PORT) ? null
            : CallCheck.outside("--port", port, 0, MOST_PORT);
    }

    /** Whether anything is to be shown. */
    boolean isAny() {
        return view != null || watch || open;
    }

    /** The name of the page's file as it was typed, or {@code null}. */
    String view() {
        return view;
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
