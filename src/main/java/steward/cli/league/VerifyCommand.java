package steward.cli.league;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.league.FolderLock;
import steward.league.LeagueFolder;
import steward.league.store.BadRow;
import steward.league.store.GameStore;
import steward.text.TextFormat;

/** {@code steward league verify}: rows of the database that cannot be used. */
@Command(name = "verify", description = "Lists the rows of a league's database that cannot be used.",
    footer = {"",
        "Other commands refuse a database with such a row. --drop takes these rows out,",
        "with the games that need them, and keeps a copy of the database as it was.",
        "A value that is only untrue, such as another score, is not found: replays are",
        "checked by steward replay --verify.",
        "", "Exit status: 0 every row can be used, or now can; 1 some cannot.",
        "", "Example:", "  steward league verify night --drop"})
final class VerifyCommand implements Callable<Integer> {

    /** Rows that are listed at most. */
    private static final int LISTED = 100;

    private final Streams streams;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--drop", description = "Sets the rows aside, and the games that need them.")
    private boolean drop;

    VerifyCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        LeagueFolder folder = drop ? league.openToWrite(streams) : league.open();
        if (!Files.exists(folder.database())) {
            throw new InputException(folder.path() + ": found a league without games, expected one that has been "
                + "played; 'steward league run " + folder.path() + "' plays it");
        }
        return drop ? dropped(folder) : listed(folder);
    }

    private int listed(LeagueFolder folder) {
        try (GameStore store = GameStore.unchecked(folder, false)) {
            String whole = store.integrity();
            if (!whole.equals("ok")) {
                streams.out().println(folder.database() + ": SQLite finds it damaged: " + TextFormat.plain(whole));
            }
            return whole.equals("ok") && list(store) ? ExitStatus.DONE : ExitStatus.FAILED;
        }
    }

    /** True if there is none. */
    private boolean list(GameStore store) {
        List<BadRow> rows = store.badRows(LISTED + 1);
        rows.stream().limit(LISTED).forEach(row -> streams.out().println(row));
        streams.out().println(rows.isEmpty() ? "Every row can be used: " + TextFormat.count(store.games(), "game")
            : rows.size() > LISTED ? "and more" : TextFormat.count(rows.size(), "row") + " cannot be used; --drop sets "
                + (rows.size() == 1 ? "it" : "them") + " aside");
        return rows.isEmpty();
    }

    private int dropped(LeagueFolder folder) {
        try (FolderLock lock = FolderLock.take(folder); GameStore store = GameStore.unchecked(folder, true)) {
            if (list(store)) {
                return ExitStatus.DONE;
            }
            Path copy = copyOf(folder);
            long before = store.games();
            store.backup(copy.toAbsolutePath());
            long rows = store.dropBadRows();
            streams.out().println("Set aside: " + TextFormat.count(rows, "row") + ", with "
                + TextFormat.count(before - store.games(), "game") + "; the database as it was: " + copy);
            return ExitStatus.DONE;
        }
    }

    private static Path copyOf(LeagueFolder folder) {
        for (int number = 1;; number++) {
            Path copy = folder.database().resolveSibling("league.db.before-drop-" + number);
            if (Files.notExists(copy)) {
                return copy;
            }
        }
    }
}
