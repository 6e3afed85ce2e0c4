package steward.league.store;

import java.nio.file.Path;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.List;
import java.util.Optional;
import steward.files.InputException;
import steward.files.Remedied;
import steward.league.Season;
import steward.league.StoredGame;

/**
 * A part of a league's schedule in a file of its own: the games of some decisions with their transcripts, to be merged
 * into the league. It has the tables of a league, and of its own {@code part}, with one row that says which part it is,
 * and {@code transcript}, with the transcripts, compressed by gzip. One program at a time uses it. Thread-safe.
 */
public final class PartStore implements AutoCloseable {

    private static final List<String> TABLES = List.of(
        "CREATE TABLE IF NOT EXISTS part (part INTEGER NOT NULL, parts INTEGER NOT NULL, games INTEGER NOT NULL, "
            + "seed INTEGER NOT NULL, pairing TEXT NOT NULL)",
        "CREATE TABLE IF NOT EXISTS transcript (game INTEGER PRIMARY KEY REFERENCES game, text BLOB NOT NULL)");

    private final Database database;
    private final GameStore games;
    private final Head head;
    private final Season season;
    private final int number;

    /**
     * Head of a part: the part and the whole that it is of.
     *
     * @param part    from 1
     * @param parts   how many there are
     * @param games   of the league in all, when every part is played
     * @param seed    of the league's first decision
     * @param pairing who meets whom, as league.json says it
     */
    public record Head(int part, int parts, long games, long seed, String pairing) {

        /** Describes the difference to another, for a person; {@code null} if there is none. */
        String difference(Head other) {
            return part != other.part || parts != other.parts
                ? "part " + part + "/" + parts + ", expected part " + other.part + "/" + other.parts
                : games != other.games ? "a part of " + games + " games, expected one of " + other.games
                : seed != other.seed ? "the seed " + seed + ", expected the league's, " + other.seed
                : !pairing.equals(other.pairing) ? "the pairing '" + pairing + "', expected the league's, '"
                    + other.pairing + "'" : null;
        }
    }

    private PartStore(Database database, Head head, Season season, int number) {
        this.database = database;
        games = new GameStore(database);
        this.head = head;
        this.season = season;
        this.number = number;
    }

    /**
     * Opens a part to play it, new or again.
     *
     * @throws InputException if it cannot be used, or is another part, or one of another season
     */
    public static PartStore write(Path file, Head head, Season season) {
        Database database = Database.part(file, true);
        try {
            GameStore games = new GameStore(database);
            Optional<Season> last = games.lastSeason();
            if (last.isPresent() && !last.get().key().equals(season.key())) {
                throw new InputException(file + ": found a part of another season, expected one of this league's: "
                    + season.difference(last.get()));
            }
            refuseReplays(database, file);
            Optional<Head> found = database.inTransaction(() -> {
                for (String table : TABLES) {
                    database.execute(table);
                }
                Optional<Head> there = head(database);
                if (there.isEmpty()) {
                    database.update("INSERT INTO part (part, parts, games, seed, pairing) VALUES (?, ?, ?, ?, ?)",
                        head.part(), head.parts(), head.games(), head.seed(), head.pairing());
                }
                return there;
            });
            String difference = found.map(there -> there.difference(head)).orElse(null);
            if (difference != null) {
                throw new InputException(file + ": found " + difference,
                    List.of(new Remedied.Remedy("out", "with another file begins a new one")));
            }
            return new PartStore(database, head, season, games.open(season));
        } catch (InputException refused) {
            database.close();
            throw refused;
        }
    }

    /**
     * Opens a part to merge it.
     *
     * @throws InputException if it cannot be used
     */
    public static PartStore read(Path file) {
        Database database = Database.part(file, false);
        try {
            GameStore games = GameStore.checked(database);
            Optional<Season> season = games.lastSeason();
            Optional<Head> head = season.isEmpty() ? Optional.empty() : database.with(() -> head(database));
            if (head.isEmpty()) {
                throw new InputException(file + ": found no part of a league in it, expected one, as 'steward league "
                    + "shard' makes it");
            }
            refuseReplays(database, file);
            return new PartStore(database, head.get(), season.get(), games.season(season.get()).orElseThrow());
        } catch (InputException refused) {
            database.close();
            throw refused;
        }
    }

    /** Refuses a part of an earlier form, which is left as it is. */
    private static void refuseReplays(Database database, Path file) {
        if (database.with(() -> database.value("SELECT 1 FROM sqlite_master WHERE name = 'recording'")) != null) {
            throw new InputException(file + ": found a part with replays, expected one with transcripts, as 'steward "
                + "league shard' makes it since; play the part again into another file");
        }
    }

    private static Optional<Head> head(Database database) throws SQLException {
        try (ResultSet row = database.query("SELECT part, parts, games, seed, pairing FROM part")) {
            return row.next() ? Optional.of(new Head(row.getInt(1), row.getInt(2), row.getLong(3), row.getLong(4),
                row.getString(5))) : Optional.empty();
        }
    }

    public Head head() {
        return head;
    }

    public Season season() {
        return season;
    }

    public GameStore games() {
        return games;
    }

    public GameQueries queries() {
        return new GameQueries(games, number, season);
    }

    /** Returns how many games it has. */
    public long count() {
        return games.games(number);
    }

    /**
     * Stores the attempts at a game with their transcripts, all or none; those that are there stay as they are.
     *
     * @param transcripts one for each attempt, compressed by gzip, or {@code null} where it has no result
     */
    public void add(List<StoredGame> attempts, List<byte[]> transcripts) {
        games.add(number, attempts, () -> {
            for (int k = 0; k < attempts.size(); k++) {
                if (transcripts.get(k) != null) {
                    database.update("INSERT OR IGNORE INTO transcript (game, text) "
                        + "SELECT id, ? FROM game WHERE name = ?", transcripts.get(k), attempts.get(k).name());
                }
            }
            return null;
        });
    }

    /** The transcript of a game by its number, compressed by gzip; {@code null} if there is none. */
    public byte[] transcript(long game) {
        return database.with(() -> (byte[]) database.value("SELECT text FROM transcript WHERE game = ?", game));
    }

    @Override
    public void close() {
        database.close();
    }
}
