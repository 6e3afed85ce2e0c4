package steward.cli.options;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Options for how people see a match: on the terminal, in a browser, as a page. */
@OptionSection("Watching")
public final class DisplayOptions {

    @Option(names = "--view", paramLabel = "HTML",
        description = "Writes a self-contained page that shows the match or the series to this file; it opens from "
            + "disk.")
    private String view;

    @Mixin
    private final WatchOptions watch = new WatchOptions();

    @Option(names = "--open",
        description = "Opens the page of --watch or --view in the browser; without either, a temporary page.")
    private boolean open;

    /** Refuses what does not go together. */
    public void check(CallCheck check, boolean many) {
        check.that(!many || !watch.watch(), "--watch is for one match, expected no --games or --swap with it");
        watch.check(check);
    }

    /** True if anything is to be shown. */
    public boolean isAny() {
        return view != null || watch.watch() || open;
    }

    /** The name of the page's file as it was typed, or {@code null}. */
    public String view() {
        return view;
    }

    public WatchOptions watch() {
        return watch;
    }

    public boolean open() {
        return open;
    }
}
