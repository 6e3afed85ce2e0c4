package steward.cli.league.view;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.league.page.WorkerRow;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.machines.check.WorkerBook;

/**
 * Reader of a league's stored games into a {@link WorkerBook}: which worker played what, and who is doubtful. It also
 * makes the rows of the workers' table.
 */
public final class WorkerBooks {

    private WorkerBooks() { }

    /** Reads all games, if a worker has played any. */
    public static WorkerBook read(GameQueries games, GameStore store) {
        Map<Integer, String> names = new HashMap<>();
        WorkerBook book = new WorkerBook(version -> names.computeIfAbsent(version, any -> store.versions().stream()
            .filter(each -> each.id() == version).map(GameStore.Version::display).findFirst().orElse("?")));
        if (games.isPlayedOn(WorkerBook.WORKER)) {
            games.games(book::add);
        }
        return book;
    }

    /** Returns the workers' rows where the league is not being played. */
    static List<WorkerRow> rows(WorkerBook book) {
        return book.lines().stream().map(line -> new WorkerRow(line.name(), line.suspended()
            ? WorkerRow.SUSPENDED : line.aside() > 0 ? "caught" : "",
            line.games(), line.aside(), Double.NaN, line.faults(), line.repeated(), null, -1, line.doubts())).toList();
    }
}
