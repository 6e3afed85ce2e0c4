package steward.cli.league;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Json;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.FolderLock;
import steward.league.LeagueFolder;
import steward.league.store.BadRow;
import steward.league.store.GameStore;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward league verify}: finds rows of the database that cannot be used. */
@Command(name = "verify", description = "Lists the rows of a league's database that cannot be used.",
    footer = {
        "", "Other commands refuse a database with such a row. --drop takes these rows out,",
        "with the games that need them, and keeps a copy of the database as it was. Each",
        "row has a digest, which finds accidental changes; it does not prevent forgery.",
        "Replays are checked by 'steward replay --verify'. A database of an earlier",
        "version is first brought up to date, and a copy of it kept.",
        "", "--json: integrity (by SQLite), games, rows (table, key, column, value,",
        "expected; the first 100), more, setAside (rows, games, copy) or null.",
        "", "Exit status: 0 every row can be used, or now can; 1 some cannot.",
        "", "Example:",
        "  steward league verify night --drop"})
final class VerifyCommand extends ProgramCommand {

    /** Rows that are listed at most. */
    private static final int LISTED = 100;

    /** The word of SQLite for a database that is whole. */
    private static final String SOUND = "ok";

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--drop", description = "Removes the rows, and the games that need them.")
    private boolean drop;

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() {
        LeagueFolder folder = drop ? league.openToWrite(streams) : league.open();
        if (!Files.exists(folder.database())) {
            throw new InputException(folder.path() + ": found a league without games, expected one that has been "
                + "played; 'steward league run " + folder.path() + "' plays it");
        }
        if (drop || GameStore.isBehind(folder)) {
            try (FolderLock lock = FolderLock.take(folder); GameStore store = GameStore.unchecked(folder, true)) {
                store.before().ifPresent(copy -> streams.err().println("steward: " + folder.database()
                    + ": brought up to date; as it was: " + copy));
                return verify(folder, store);
            }
        }
        try (GameStore store = GameStore.unchecked(folder, false)) {
            return verify(folder, store);
        }
    }

    private int verify(LeagueFolder folder, GameStore store) {
        String whole = drop ? SOUND : store.integrity();
        List<BadRow> rows = whole.equals(SOUND) ? store.badRows(LISTED + 1) : List.of();
        if (!json) {
            list(folder, store, whole, rows);
        }
        Dropped dropped = drop && !rows.isEmpty() ? drop(folder, store) : null;
        if (json) {
            print(store, whole, rows, dropped);
        } else if (dropped != null) {
            streams.out().println("Set aside: " + TextFormat.count(dropped.rows, "row") + ", with "
                + TextFormat.count(dropped.games, "game") + "; the database as it was: " + dropped.copy);
        }
        return drop || whole.equals(SOUND) && rows.isEmpty() ? ExitStatus.DONE : ExitStatus.FAILED;
    }

    private void list(LeagueFolder folder, GameStore store, String whole, List<BadRow> rows) {
        if (!whole.equals(SOUND)) {
            streams.out().println(folder.database() + ": SQLite finds it damaged: " + TextFormat.plain(whole));
            return;
        }
        rows.stream().limit(LISTED).forEach(row -> streams.out().println(row));
        streams.out().println(rows.isEmpty() ? "Every row can be used: " + TextFormat.count(store.games(), "game")
            : rows.size() > LISTED ? "and more" : TextFormat.count(rows.size(), "row") + " cannot be used; --drop sets "
                + (rows.size() == 1 ? "it" : "them") + " aside");
    }

    private void print(GameStore store, String whole, List<BadRow> rows, Dropped dropped) {
        Json.print(streams, Fields.of("integrity", whole, "games", store.games(),
            "rows", Fields.each(rows.subList(0, Math.min(LISTED, rows.size())), row -> Fields.of("table", row.table(),
                "key", row.key(), "column", row.column(), "value", row.value(), "expected", row.expected())),
            "more", rows.size() > LISTED, "setAside", dropped == null ? null : Fields.of("rows", dropped.rows,
                "games", dropped.games, "copy", dropped.copy)));
    }

    /** Rows set aside, the games that needed them, and the database as it was. */
    private record Dropped(long rows, long games, Path copy) { }

    private static Dropped drop(LeagueFolder folder, GameStore store) {
        Path copy = OutputFiles.copyBeside(folder.database(), "before-drop");
        long before = store.games();
        store.backup(copy.toAbsolutePath());
        long rows = store.dropBadRows();
        return new Dropped(rows, before - store.games(), copy);
    }
}
