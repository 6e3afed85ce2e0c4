package steward.league.store;

import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Types;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;

/**
 * Writes the rows of games, within a transaction that has begun. The numbers of lineups and machines are kept, so that
 * they are not looked up for every game. Not thread-safe.
 */
final class GameRows {

    /** In the column {@code counts}: a game that counts in no rating, see {@link StoredGame#allFailed}. */
    static final int ALL_FAILED = 2;

    private final Database database;
    private final Map<String, Long> lineups = new HashMap<>();
    private final Map<String, Long> machines = new HashMap<>();

    GameRows(Database database) {
        this.database = database;
    }

    /** Forgets all numbers: what is rolled back may be among them. */
    void forget() {
        lineups.clear();
        machines.clear();
    }

    /**
     * Adds games. One that is there already stays as it is.
     *
     * @return how many are new
     */
    int add(int season, List<StoredGame> games) throws SQLException {
        int added = 0;
        for (StoredGame game : games) {
            added += add(season, game) ? 1 : 0;
        }
        return added;
    }

    private boolean add(int season, StoredGame game) throws SQLException {
        PreparedStatement row = database.statement("INSERT INTO game (name, season, decision, seed, lineup, ranks, "
            + "attempt, counts, turns, problem, played, machine, replay, transcript) "
            + "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (name) DO NOTHING");
        row.setBytes(1, game.name());
        row.setInt(2, season);
        if (game.decision() < 0) {
            row.setNull(3, Types.INTEGER);
        } else {
            row.setInt(3, game.decision());
        }
        row.setLong(4, game.seed());
        row.setLong(5, lineup(game));
        row.setString(6, game.ranks());
        row.setInt(7, game.attempt());
        row.setInt(8, !game.counts() ? 0 : game.allFailed() ? ALL_FAILED : 1);
        row.setInt(9, game.turns());
        row.setString(10, game.problem());
        row.setLong(11, game.played());
        row.setLong(12, machine(game.machine()));
        row.setString(13, game.replay());
        row.setObject(14, game.transcript() == 0 ? null : game.transcript());
        if (row.executeUpdate() == 0) {
            return false;
        }
        long id = ((Number) database.value("SELECT last_insert_rowid()")).longValue();
        for (int seat = 0; seat < game.seats().size(); seat++) {
            addSeat(season, id, seat, game.seats().get(seat));
        }
        return true;
    }

    private void addSeat(int season, long game, int place, StoredSeat seat) throws SQLException {
        PreparedStatement row = database.statement("INSERT INTO seat (season, version, game, seat, rank, score, fault, "
            + "answers, mean_nanos, worst_nanos, first_nanos, own) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        row.setInt(1, season);
        row.setInt(2, seat.version());
        row.setLong(3, game);
        row.setInt(4, place);
        row.setInt(5, seat.rank());
        row.setDouble(6, seat.score());
        row.setString(7, seat.fault());
        row.setInt(8, seat.answers());
        row.setLong(9, seat.meanNanos());
        row.setLong(10, seat.worstNanos());
        row.setLong(11, seat.firstNanos());
        row.setString(12, seat.values().isEmpty() ? null : seat.valuesText());
        row.executeUpdate();
    }

    private long lineup(StoredGame game) throws SQLException {
        String versions = Arrays.stream(game.lineup()).mapToObj(Integer::toString).collect(Collectors.joining(" "));
        return number(lineups, "lineup", "versions", versions);
    }

    private long machine(String name) throws SQLException {
        return number(machines, "machine", "name", name);
    }

    /** The number of a text in a table of texts; it is known from then on only if the transaction succeeds. */
    private long number(Map<String, Long> known, String table, String column, String text) throws SQLException {
        Long number = known.get(text);
        if (number != null) {
            return number;
        }
        String find = "SELECT id FROM " + table + " WHERE " + column + " = ?";
        Object found = database.value(find, text);
        if (found == null) {
            database.update("INSERT INTO " + table + " (" + column + ") VALUES (?)", text);
            return ((Number) database.value(find, text)).longValue();
        }
        known.put(text, ((Number) found).longValue());
        return ((Number) found).longValue();
    }
}
