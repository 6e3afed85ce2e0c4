package steward.cli.play;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.cli.options.WatchOptions;

/** The options of a match by which people see it. */
@OptionSection("Watching")
final class DisplayOptions {

    @Option(names = "--view", paramLabel = "HTML",
        description = "Writes a page that shows the match to this file: everything in it, opens from disk.")
    private String view;

    @Mixin
    private final WatchOptions watch = new WatchOptions();

    @Option(names = "--open",
        description = "Opens the page of --watch or --view, or one without a name, in the browser.")
    private boolean open;

    /** Refuses what does not go together. */
    void check(CallCheck check, boolean many) {
        check.that(!many || !isAny(),
            "--view, --watch and --open are for one match, expected no --games or --swap with them");
        watch.check(check);
    }

    /** True if anything is to be shown. */
    boolean isAny() {
        return view != null || watch.watch() || open;
    }

    /** The name of the page's file as it was typed, or {@code null}. */
    String view() {
        return view;
    }

    WatchOptions watch() {
        return watch;
    }

    boolean open() {
        return open;
    }
}
