package steward.league.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import steward.league.Decision;
import steward.league.RepeatedGroups;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;

/**
 * Queries on the stored games of one season: sums, decisions, lists. Over 400 lines, because each query stands beside
 * the method that reads its rows.
 */
public final class GameQueries {

    private static final String SUMS = "SELECT version, count(*), sum(score), count(fault), sum(answers), "
        + "sum(mean_nanos * 1.0 * answers), max(worst_nanos) FROM seat WHERE season = ?1 AND game NOT IN "
        + "(SELECT id FROM game WHERE counts = 0) AND game NOT IN (SELECT id FROM game WHERE season = ?1 AND counts = "
        + GameRows.ALL_FAILED + ") GROUP BY version";
    private static final String ALL_FAILED = "SELECT version, count(*) FROM seat WHERE game IN (SELECT id FROM game "
        + "WHERE season = ? AND counts = " + GameRows.ALL_FAILED + ") GROUP BY version";
    private static final String GAME = "SELECT g.id, g.name, g.decision, g.seed, g.attempt, g.counts, g.turns, "
        + "g.problem, g.played, m.name, g.replay, s.version, s.rank, s.score, s.fault, s.answers, s.mean_nanos, "
        + "s.worst_nanos, s.first_nanos, s.own, coalesce(g.transcript, 0) "
        + "FROM game g JOIN machine m ON m.id = g.machine JOIN seat s ON s.game = g.id ";

    /** A lineup and the ranks are one number, which is fetched at once. */
    private static final String CLUSTER = "SELECT seed, lineup << 32 | CAST(replace(ranks, ' ', '') AS INTEGER), "
        + "id, coalesce(transcript, 0), lineup FROM game NOT INDEXED WHERE season = ? AND counts = 1";
    private static final String AS_STORED = CLUSTER + " ORDER BY id";
    /** True of games that do not count and are played again. */
    private static final String AGAIN = StoredGame.AGAIN.stream().map(begin -> "problem LIKE '" + begin + "%'")
        .collect(Collectors.joining(" OR "));
    /** Of equal games that of the earliest decision counts, in whatever order threads and workers brought them. */
    private static final String AS_DECIDED = " ORDER BY decision, seed, id";

    private final Database database;
    private final int season;
    private final Season key;

    /**
     * @param key what all its games have in common
     */
    public GameQueries(GameStore store, int season, Season key) {
        database = store.database();
        this.season = season;
        this.key = key;
    }

    public Results results() {
        Results results = new Results(key);
        database.inSnapshot(() -> {
            try (ResultSet row = database.query("SELECT count(*) - count(problem), count(problem), "
                + "count(iif(problem LIKE '" + StoredGame.FORGIVEN + "%', 1, NULL)) FROM game WHERE season = ? AND "
                + "counts = 0", season)) {
                results.addOthers(row.getLong(1), row.getLong(2), row.getLong(3));
            }
            try (ResultSet row = database.query(SUMS, season)) {
                while (row.next()) {
                    results.addSums(row.getInt(1), row.getLong(2), row.getDouble(3), row.getLong(4), row.getLong(5),
                        row.getDouble(6), row.getLong(7));
                }
            }
            try (ResultSet row = database.query(ALL_FAILED, season)) {
                while (row.next()) {
                    results.addAllFailed(row.getInt(1), row.getLong(2));
                }
            }
            if (key.players() == 1) {
                addAlone(results, "g.id <= ?", Long.MAX_VALUE);
            } else {
                addGroups(results);
            }
            return null;
        });
        return results;
    }

    private void addGroups(Results results) throws SQLException {
        Lineups lineups = lineups();
        ClusterCounts clusters = new ClusterCounts(lineups.versions(), chosenSeeds(), false);
        try (ResultSet row = database.query(CLUSTER + AS_DECIDED, season)) {
            while (row.next()) {
                if (!lineups.isRepeat(results, row.getInt(5), row.getLong(4))) {
                    clusters.add(row.getLong(1), row.getLong(2));
                }
            }
        }
        clusters.give(results);
    }

    /** Seeds that several pairings may have: of games outside of the schedule, and of a list. */
    private Set<Long> chosenSeeds() throws SQLException {
        Set<Long> seeds = listedSeeds();
        try (ResultSet row = database.query("SELECT seed FROM game NOT INDEXED WHERE season = ? AND decision IS NULL",
            season)) {
            while (row.next()) {
                seeds.add(row.getLong(1));
            }
        }
        return seeds;
    }

    /** Seeds of several decisions; there are none where those are in a row, which costs less to see. */
    private Set<Long> listedSeeds() throws SQLException {
        Set<Long> seeds = new HashSet<>();
        try (ResultSet row = database.query("SELECT seed FROM decision WHERE season = ?1 AND EXISTS (SELECT 1 FROM "
            + "decision WHERE season = ?1 AND seed - number <> (SELECT seed - number FROM decision WHERE season = ?1 "
            + "LIMIT 1)) GROUP BY seed HAVING count(*) > 1", season)) {
            while (row.next()) {
                seeds.add(row.getLong(1));
            }
        }
        return seeds;
    }

    /**
     * Versions by seat of all lineups, by number.
     *
     * @param numbers of the lineups for {@link Results#isRepeat}, without those with a bot that draws by lot
     */
    private record Lineups(Map<Integer, int[]> versions, Map<Integer, Long> numbers) {

        boolean isRepeat(Results results, int lineup, long transcript) {
            Long number = transcript == 0 ? null : numbers.get(lineup);
            return number != null && results.isRepeat(number, transcript);
        }

        /** The transcript; 0 if a bot draws by lot: equal games are independent then. */
        long transcript(int lineup, long transcript) {
            return numbers.containsKey(lineup) ? transcript : 0;
        }
    }

    private Lineups lineups() throws SQLException {
        Set<Integer> random = new HashSet<>();
        try (ResultSet row = database.query("SELECT id FROM version WHERE random = 1")) {
            while (row.next()) {
                random.add(row.getInt(1));
            }
        }
        Map<Integer, int[]> lineups = new HashMap<>();
        Map<Integer, Long> numbers = new HashMap<>();
        try (ResultSet row = database.query("SELECT id, versions FROM lineup")) {
            while (row.next()) {
                int[] versions = numbers(row.getString(2));
                lineups.put(row.getInt(1), versions);
                if (Arrays.stream(versions).noneMatch(random::contains)) {
                    numbers.put(row.getInt(1), Results.lineup(versions));
                }
            }
        }
        return new Lineups(lineups, numbers);
    }

    private void addAlone(Results results, String which, long upTo) throws SQLException {
        Lineups lineups = lineups();
        long count = 0;
        try (ResultSet row = database.query("SELECT g.seed, s.version, s.score, g.lineup, "
            + "coalesce(g.transcript, 0) FROM game g JOIN seat s ON s.game = g.id WHERE g.season = ? AND g.counts = 1 "
            + "AND " + which + " ORDER BY g.decision, g.seed, g.id", season, upTo)) {
            while (row.next()) {
                if (lineups.isRepeat(results, row.getInt(4), row.getLong(5))) {
                    continue;
                }
                results.addAlone(row.getLong(1), row.getInt(2), row.getDouble(3));
                count++;
            }
        }
        results.addAloneGames(count);
    }

    static int[] numbers(String text) {
        return text.isEmpty() ? new int[0] : Arrays.stream(text.split(" ")).mapToInt(Integer::parseInt).toArray();
    }

    /** Tells a schedule of the decisions of its season and of their games that are over, also whether these repeat. */
    public void tell(Schedule schedule, RepeatedGroups repeated) {
        database.inSnapshot(() -> {
            Lineups lineups = lineups();
            Map<Integer, List<Integer>> groups = new HashMap<>();
            lineups.versions().forEach((number, versions) -> groups.put(number, list(versions)));
            // Side by side, so that few decisions wait for their games. Several numbers are fetched as one, since that
            // costs more than finding them. Games stand in the order of the table: an index would look up each row.
            try (ResultSet decision = database.query("SELECT iif(dropped, -1, 1) * (number << 32 | lineup), seed, "
                     + "paused FROM decision WHERE season = ? ORDER BY number", season);
                 ResultSet game = database.query("SELECT decision << 32 | lineup, iif(counts = 1, transcript, NULL) "
                     + "FROM game NOT INDEXED WHERE season = ? AND decision IS NOT NULL AND (counts > 0 OR problem IS "
                     + "NOT NULL AND NOT (" + AGAIN + "))", season)) {
                int told = -1;
                while (game.next()) {
                    long over = game.getLong(1);
                    int number = (int) (over >>> Integer.SIZE);
                    while (told < number && decision.next()) {
                        told = tell(schedule, decision, groups);
                    }
                    int[] lineup = lineups.versions().get((int) over);
                    schedule.over(number, lineup);
                    long transcript = game.getLong(2);
                    if (transcript != 0) {
                        repeated.add(number, lineups.transcript((int) over, transcript), lineup);
                    }
                }
                while (decision.next()) {
                    tell(schedule, decision, groups);
                }
            }
            return null;
        });
    }

    private int tell(Schedule schedule, ResultSet row, Map<Integer, List<Integer>> groups) throws SQLException {
        long found = row.getLong(1);
        long both = Math.abs(found);
        String paused = key.players() > 1 ? null : row.getString(3);
        schedule.made(new Decision((int) (both >>> Integer.SIZE), row.getLong(2), groups.get((int) both),
            paused == null ? List.of() : list(numbers(paused))), found < 0);
        return (int) (both >>> Integer.SIZE);
    }

    private static List<Integer> list(int... numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }

    /** Takes a game of the schedule that counts. */
    public interface KnownTaker {
        void game(int decision, long seed, int[] lineup, double score, long transcript, int... ranks);
    }

    /** The results, without sums of versions, of the schedule's decisions below a number. */
    public Results resultsBefore(int decision) {
        Results results = new Results(key);
        database.inSnapshot(() -> {
            if (key.players() == 1) {
                addAlone(results, "g.decision < ?", decision);
                return null;
            }
            Lineups lineups = lineups();
            ClusterCounts clusters = new ClusterCounts(lineups.versions(), listedSeeds(), false);
            try (ResultSet row = database.query(CLUSTER + " AND decision < ?" + AS_DECIDED, season, decision)) {
                while (row.next()) {
                    if (!lineups.isRepeat(results, row.getInt(5), row.getLong(4))) {
                        clusters.add(row.getLong(1), row.getLong(2));
                    }
                }
            }
            clusters.give(results);
            return null;
        });
        return results;
    }

    /** Tells of every game of the schedule that counts, from a decision on; the score is that of the first player. */
    public void known(int from, KnownTaker taker) {
        database.inSnapshot(() -> {
            Lineups lineups = lineups();
            boolean scored = key.players() == 1;
            try (ResultSet row = database.query("SELECT g.decision, g.seed, g.lineup, g.ranks, "
                + "coalesce(g.transcript, 0), " + (scored
                ? "s.score FROM game g JOIN seat s ON s.game = g.id" : "0.0 FROM game g NOT INDEXED")
                + " WHERE g.season = ? AND g.decision >= ? AND g.counts = 1", season, from)) {
                while (row.next()) {
                    taker.game(row.getInt(1), row.getLong(2), lineups.versions().get(row.getInt(3)), row.getDouble(6),
                        lineups.transcript(row.getInt(3), row.getLong(5)), numbers(row.getString(4)));
                }
            }
            return null;
        });
    }

    /** Takes whether a version failed in a game of the schedule; returns whether an earlier one is wanted. */
    public interface FailureTaker {
        boolean game(int decision, boolean failed);
    }

    /** Tells of the games of the schedule of a version, the latest first. */
    public void failures(int version, FailureTaker taker) {
        database.with(() -> {
            try (ResultSet row = database.query("SELECT g.decision, s.fault IS NOT NULL FROM seat s JOIN game g "
                + "ON g.id = s.game WHERE s.season = ? AND s.version = ? AND g.counts > 0 AND g.decision IS NOT NULL "
                + "ORDER BY s.game DESC", season, version)) {
                boolean more = true;
                while (more && row.next()) {
                    more = taker.game(row.getInt(1), row.getBoolean(2));
                }
            }
            return null;
        });
    }

    /** The number after that of the last decision. */
    public int nextDecision() {
        return (int) (long) database.with(() -> number("SELECT coalesce(max(number), -1) + 1 FROM decision "
            + "WHERE season = ?", season));
    }

    /** Returns how the ratings of these versions went. */
    public RatingPath path(List<LeagueTable.Entry> entries, LeagueTable.Reference reference) {
        RatingPath.Collector path = new RatingPath.Collector(entries, reference);
        database.inSnapshot(() -> {
            long first = number("SELECT coalesce(min(id), 0) FROM game WHERE season = ?", season);
            long last = number("SELECT coalesce(max(id), 0) FROM game WHERE season = ?", season);
            long points = RatingPath.points(entries.size());
            long step = Math.max(1, (last - first + points) / points);
            if (last == 0) {
                return null;
            }
            if (key.players() == 1) {
                pathAlone(path, first, step);
            } else {
                pathOfClusters(path, first, step);
            }
            return null;
        });
        return path.path();
    }

    private void pathAlone(RatingPath.Collector path, long first, long step) throws SQLException {
        Lineups lineups = lineups();
        Results results = new Results(key);
        try (ResultSet row = database.query("SELECT g.id, s.version, g.seed, s.score, g.lineup, "
            + "coalesce(g.transcript, 0) FROM game g JOIN seat s ON s.game = g.id WHERE g.season = ? AND g.counts = 1 "
            + "ORDER BY g.id", season)) {
            long end = first + step;
            while (row.next()) {
                if (row.getLong(1) >= end) {
                    path.take(results);
                    end += (row.getLong(1) - end) / step * step + step;
                }
                if (lineups.isRepeat(results, row.getInt(5), row.getLong(6))) {
                    continue;
                }
                results.addAlone(row.getLong(3), row.getInt(2), row.getDouble(4));
                results.addAloneGames(1);
                results.addSums(row.getInt(2), 1, 0, 0, 0, 0, 0);
            }
        }
        path.take(results);
    }

    private void pathOfClusters(RatingPath.Collector path, long first, long step) throws SQLException {
        Lineups lineups = lineups();
        ClusterCounts clusters = new ClusterCounts(lineups.versions(), chosenSeeds(), true);
        Results results = new Results(key);
        try (ResultSet row = database.query(AS_STORED, season)) {
            long end = first + step;
            while (row.next()) {
                if (row.getLong(3) >= end) {
                    clusters.give(results);
                    path.take(results);
                    end += (row.getLong(3) - end) / step * step + step;
                }
                if (!lineups.isRepeat(results, row.getInt(5), row.getLong(4))) {
                    clusters.add(row.getLong(1), row.getLong(2));
                }
            }
        }
        clusters.give(results);
        path.take(results);
    }

    private long number(String sql, Object... values) throws SQLException {
        return ((Number) database.value(sql, values)).longValue();
    }

    /** All games, in the order in which they were stored. */
    public void games(Consumer<StoredGame> reader) {
        read(reader, GAME + "WHERE g.season = ? ORDER BY g.id, s.seat", season);
    }

    /** True if any game was played on a machine whose name begins so. */
    public boolean isPlayedOn(String machine) {
        return database.with(() -> database.value("SELECT 1 FROM machine WHERE substr(name, 1, length(?)) = ? LIMIT 1",
            machine, machine) != null);
    }

    /** The last games, the latest first. */
    public List<StoredGame> last(int most) {
        List<StoredGame> games = new ArrayList<>();
        read(games::add, GAME + "WHERE g.id IN (SELECT id FROM game WHERE season = ? ORDER BY id DESC LIMIT ?) "
            + "ORDER BY g.id DESC, s.seat", season, most);
        return games;
    }

    /** All games of a version, the latest first. */
    public void gamesOf(int version, Consumer<StoredGame> reader) {
        read(reader, GAME + "WHERE g.id IN (SELECT game FROM seat WHERE season = ? AND version = ?) "
            + "ORDER BY g.id DESC, s.seat", season, version);
    }

    /** All games that have a replay, the latest first. */
    public List<StoredGame> withReplay(int most) {
        List<StoredGame> games = new ArrayList<>();
        read(games::add, GAME + "WHERE g.id IN (SELECT id FROM game WHERE replay IS NOT NULL AND season = ? "
            + "ORDER BY id DESC LIMIT ?) ORDER BY g.id DESC, s.seat", season, most);
        return games;
    }

    /** The files of all kept replays, of any season. */
    public Set<String> allReplays() {
        return database.with(() -> {
            Set<String> files = new HashSet<>();
            try (ResultSet row = database.query("SELECT replay FROM game WHERE replay IS NOT NULL")) {
                while (row.next()) {
                    files.add(row.getString(1));
                }
            }
            return files;
        });
    }

    /** A game by its number, or {@code null}. */
    public StoredGame game(long id) {
        return one("g.id = ?", id);
    }

    /** A game by its name, of any season, or {@code null}. */
    public StoredGame game(byte[] name) {
        return one("g.name = ?", name);
    }

    private StoredGame one(String which, Object value) {
        List<StoredGame> games = new ArrayList<>();
        read(games::add, GAME + "WHERE " + which + " ORDER BY s.seat", value);
        return games.isEmpty() ? null : games.get(0);
    }

    private void read(Consumer<StoredGame> reader, String sql, Object... values) {
        database.with(() -> {
            try (ResultSet row = database.query(sql, values)) {
                StoredGame game = null;
                List<StoredSeat> seats = new ArrayList<>();
                while (row.next()) {
                    if (game == null || row.getLong(1) != game.id()) {
                        deliver(reader, game, seats);
                        game = head(row);
                        seats.clear();
                    }
                    seats.add(new StoredSeat(row.getInt(12), row.getInt(13), row.getDouble(14), row.getString(15),
                        row.getInt(16), row.getLong(17), row.getLong(18), row.getLong(19),
                        StoredSeat.values(row.getString(20))));
                }
                deliver(reader, game, seats);
            }
            return null;
        });
    }

    private static StoredGame head(ResultSet row) throws SQLException {
        int found = row.getInt(3);
        int decision = row.wasNull() ? -1 : found;     // asked before another column is read
        return new StoredGame(row.getLong(1), row.getBytes(2), decision, row.getLong(4),
            row.getInt(5), row.getInt(6) > 0, row.getInt(7), row.getString(8), row.getLong(9), row.getString(10),
            row.getString(11), row.getLong(21), List.of());
    }

    private static void deliver(Consumer<StoredGame> reader, StoredGame head, List<StoredSeat> seats) {
        if (head != null) {
            reader.accept(new StoredGame(head.id(), head.name(), head.decision(), head.seed(), head.attempt(),
                head.counts(), head.turns(), head.problem(), head.played(), head.machine(), head.replay(),
                head.transcript(), seats));
        }
    }
}
