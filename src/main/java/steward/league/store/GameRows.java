package steward.league.store;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;

/** Writer of games into the tables of a league's database, within a running transaction. Not thread-safe. */
final class GameRows {

    /** In the column {@code counts}: a game that counts in no rating, see {@link StoredGame#allFailed}. */
    static final int ALL_FAILED = 2;

    private final Database database;
    private final TextRows lineups;
    private final TextRows machines;

    /** @param lineups the table of that name */
    GameRows(Database database, TextRows lineups) {
        this.database = database;
        this.lineups = lineups;
        machines = new TextRows(database, "machine", "name");
    }

    /** Forgets what may be rolled back. */
    void forget() {
        lineups.forget();
        machines.forget();
    }

    /**
     * Adds games. One that is there already stays as it is; if it is of no decision, it becomes one of the new game's.
     *
     * @return how many are new
     */
    int add(int season, List<StoredGame> games) {
        long first = database.number("SELECT coalesce(max(id), 0) + 1 FROM game");
        int added = 0;
        for (StoredGame game : games) {
            added += add(season, game, first + added) ? 1 : 0;
        }
        return added;
    }

    /** @param id of the game if it is new */
    private boolean add(int season, StoredGame game, long id) {
        Object[] row = {id, game.name(), season, game.decision() < 0 ? null : game.decision(), game.seed(),
            lineups.number(lineup(game)), game.ranks(), game.attempt(),
            !game.counts() ? 0 : game.allFailed() ? ALL_FAILED : 1, game.turns(), game.problem(), game.played(),
            machines.number(game.machine()), game.replay(),
            game.transcript() == 0 ? null : game.transcript(), 0L};
        List<Object[]> seats = new ArrayList<>();
        long digest = RowDigest.of(Arrays.copyOf(row, row.length - 1));
        for (StoredSeat seat : game.seats()) {
            Object[] values = {season, seat.version(), id, seats.size(), seat.rank(), seat.score(), seat.fault(),
                seat.answers(), seat.meanNanos(), seat.worstNanos(), seat.firstNanos(),
                seat.values().isEmpty() ? null : seat.valuesText()};
            digest += RowDigest.of(values);
            seats.add(values);
        }
        row[row.length - 1] = digest;
        if (database.update("INSERT INTO game (id, name, season, decision, seed, lineup, ranks, attempt, counts, "
                + "turns, problem, played, machine, replay, transcript, digest) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                + "?, ?, ?, ?, ?, ?) ON CONFLICT (name) DO NOTHING", row) == 0) {
            adopt(game.name(), game.decision());
            return false;
        }
        for (Object[] seat : seats) {
            database.update("INSERT INTO seat (season, version, game, seat, rank, score, fault, answers, mean_nanos, "
                + "worst_nanos, first_nanos, own) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", seat);
        }
        return true;
    }

    /** Makes a game that is there, and of no decision, part of one; not of a negative number. */
    List<Long> adopt(byte[] name, int decision) {
        return RowDigest.sealed(database, "game", "UPDATE game SET decision = ?1 WHERE name = ?2 AND decision IS "
            + "NULL AND ?1 >= 0", decision, name);
    }

    private static String lineup(StoredGame game) {
        StringBuilder versions = new StringBuilder();
        for (int version : game.lineup()) {
            versions.append(versions.length() == 0 ? "" : " ").append(version);
        }
        return versions.toString();
    }
}
