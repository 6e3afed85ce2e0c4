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
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.league.Decision;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.pairing.KnownResults;
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
    private static final String GAME = "SELECT g.id, g.name, coalesce(g.decision, -1), g.seed, g.attempt, g.counts, "
        + "g.turns, g.problem, g.played, m.name, g.replay, s.version, s.rank, s.score, s.fault, s.answers, "
        + "s.mean_nanos, s.worst_nanos, s.first_nanos, s.own, g.transcript, g.ranks "
        + "FROM game g JOIN machine m ON m.id = g.machine JOIN seat s ON s.game = g.id ";

    /** Seeds that several pairings may have: those of several decisions. There are none where those are in a row. */
    private static final String LISTED = "SELECT seed FROM decision WHERE season = ?1 AND EXISTS (SELECT 1 FROM "
        + "decision WHERE season = ?1 AND seed - number <> (SELECT seed - number FROM decision WHERE season = ?1 "
        + "LIMIT 1)) GROUP BY seed HAVING count(*) > 1";
    /** Also those of games outside of the schedule. */
    private static final String CHOSEN = LISTED + " UNION ALL SELECT seed FROM game NOT INDEXED WHERE season = ?1 AND "
        + "decision IS NULL";
    /** True of games that do not count and are played again. */
    private static final String AGAIN = StoredGame.AGAIN.stream().map(begin -> "problem LIKE '" + begin + "%'")
        .collect(Collectors.joining(" OR "));
    /** Of equal games that of the earliest decision counts, in whatever order threads and workers brought them. */
    private static final String AS_DECIDED = " ORDER BY g.decision, g.seed, g.id";

    private final Database database;
    private final int season;
    private final Season key;

    /** @param key what all its games have in common */
    public GameQueries(GameStore store, int season, Season key) {
        database = store.database();
        this.season = season;
        this.key = key;
    }

    public Results results() {
        Results results = new Results(key);
        return database.inSnapshot(() -> {
            database.each("SELECT count(*) - count(problem), count(problem), count(iif(problem LIKE '"
                + StoredGame.FORGIVEN + "%', 1, NULL)) FROM game WHERE season = ? AND counts = 0",
                row -> results.addOthers(row.getLong(1), row.getLong(2), row.getLong(3)), season);
            database.each(SUMS, row -> results.addSums(row.getInt(1), row.getLong(2), row.getDouble(3),
                row.getLong(4), row.getLong(5), row.getDouble(6), row.getLong(7)), season);
            database.each(ALL_FAILED, row -> results.addAllFailed(row.getInt(1), row.getLong(2)), season);
            return new Counting(results, CHOSEN, false).all(AS_DECIDED);
        });
    }

    /** The results, without sums of versions, of the schedule's decisions below a number. */
    public Results resultsBefore(int decision) {
        return database.inSnapshot(() -> new Counting(new Results(key), LISTED, false)
            .all("AND g.decision < ?2" + AS_DECIDED, decision));
    }

    /** Counts games that count into results, but those that repeat earlier ones. */
    private final class Counting {
        private final Results results;
        private final Lineups lineups = lineups();
        private final ClusterCounts clusters;
        private final boolean isSummed;

        /**
         * @param seeds    query for those that several pairings may have
         * @param isSummed whether each version's games are counted, too
         */
        Counting(Results results, String seeds, boolean isSummed) {
            this.results = results;
            this.isSummed = isSummed;
            clusters = new ClusterCounts(lineups.versions(), key.players() == 1 ? Set.of()
                : Set.copyOf(database.list(seeds, row -> row.getLong(1), season)), isSummed);
        }

        Results all(String which, Object... values) {
            each(which, id -> { }, values);
            return results;
        }

        /** @param before is told of each game before it is counted */
        void each(String which, LongConsumer before, Object... values) {
            boolean alone = key.players() == 1;
            // A lineup and the ranks are one number, which is fetched at once.
            database.each("SELECT g.seed, g.lineup << 32 | CAST(replace(ranks, ' ', '') AS INTEGER), transcript, g.id, "
                + (alone ? "s.score FROM game g JOIN seat s ON s.game = g.id" : "0 FROM game g NOT INDEXED")
                + " WHERE g.season = ?1 AND counts = 1 " + which, row -> {
                    before.accept(row.getLong(4));
                    long game = row.getLong(2);
                    int lineup = (int) (game >>> Integer.SIZE);
                    if (lineups.isRepeat(results, lineup, row.getLong(3))) {
                        return;
                    }
                    if (alone) {
                        int version = lineups.versions().get(lineup)[0];
                        results.addAlone(row.getLong(1), version, row.getDouble(5));
                        results.addAloneGames(1);
                        if (isSummed) {
                            results.addSums(version, 1, 0, 0, 0, 0, 0);
                        }
                    } else {
                        clusters.add(row.getLong(1), game);
                    }
                }, Stream.concat(Stream.of(season), Stream.of(values)).toArray());
            clusters.give(results);
        }
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

    private Lineups lineups() {
        List<Integer> random = database.list("SELECT id FROM version WHERE random = 1", row -> row.getInt(1));
        Map<Integer, int[]> lineups = new HashMap<>();
        Map<Integer, Long> numbers = new HashMap<>();
        database.each("SELECT id, versions FROM lineup", row -> {
            int[] versions = numbers(row.getString(2));
            lineups.put(row.getInt(1), versions);
            if (Arrays.stream(versions).noneMatch(random::contains)) {
                numbers.put(row.getInt(1), Results.lineup(versions));
            }
        });
        return new Lineups(lineups, numbers);
    }

    static int[] numbers(String text) {
        return text.isEmpty() ? new int[0] : Arrays.stream(text.split(" ")).mapToInt(Integer::parseInt).toArray();
    }

    /** Tells a schedule of the decisions of its season and of their games that are over, also whether these repeat. */
    public void tell(Schedule schedule) {
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
                        schedule.repeated().add(number, lineups.transcript((int) over, transcript), lineup);
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

    /**
     * The results of the schedule.
     *
     * @param from below this number no decision's results are asked for alone
     */
    public KnownResults known(int from) {
        KnownResults known = new KnownResults(key, resultsBefore(from));
        database.inSnapshot(() -> {
            Lineups lineups = lineups();
            database.each("SELECT g.decision, g.seed, g.lineup, g.ranks, g.transcript, " + (key.players() == 1
                ? "s.score FROM game g JOIN seat s ON s.game = g.id" : "0 FROM game g NOT INDEXED")
                + " WHERE g.season = ? AND g.decision >= ? AND g.counts = 1", row -> known.add(row.getInt(1),
                    row.getLong(2), lineups.versions().get(row.getInt(3)), row.getDouble(6),
                    lineups.transcript(row.getInt(3), row.getLong(5)), numbers(row.getString(4))), season, from);
            return known;
        });
        return known;
    }

    /**
     * Tells of the games of the schedule of a version, the latest first.
     *
     * @param taker takes the decision and whether it failed; returns whether an earlier one is wanted
     */
    public void failures(int version, BiPredicate<Integer, Boolean> taker) {
        database.with(() -> {
            try (ResultSet row = database.query("SELECT g.decision, s.fault IS NOT NULL FROM seat s JOIN game g "
                + "ON g.id = s.game WHERE s.season = ? AND s.version = ? AND g.counts > 0 AND g.decision IS NOT NULL "
                + "ORDER BY s.game DESC", season, version)) {
                boolean more = true;
                while (more && row.next()) {
                    more = taker.test(row.getInt(1), row.getBoolean(2));
                }
                return null;
            }
        });
    }

    /** The number after that of the last decision. */
    public int nextDecision() {
        return (int) database.number("SELECT coalesce(max(number), -1) + 1 FROM decision WHERE season = ?", season);
    }

    /** Returns how the ratings of these versions went. */
    public RatingPath path(List<LeagueTable.Entry> entries, LeagueTable.Reference reference) {
        RatingPath.Collector path = new RatingPath.Collector(entries, reference);
        return database.inSnapshot(() -> {
            long first = database.number("SELECT coalesce(min(id), 0) FROM game WHERE season = ?", season);
            long last = database.number("SELECT coalesce(max(id), 0) FROM game WHERE season = ?", season);
            long points = RatingPath.points(entries.size());
            long step = Math.max(1, (last - first + points) / points);
            long[] end = {first + step};
            Results results = new Results(key);
            Counting games = new Counting(results, CHOSEN, true);
            games.each("ORDER BY g.id", id -> {
                if (id >= end[0]) {
                    games.clusters.give(results);
                    path.take(results);
                    end[0] += (id - end[0]) / step * step + step;
                }
            });
            if (last > 0) {
                path.take(results);
            }
            return path.path();
        });
    }

    /** All games, in the order in which they were stored. */
    public void games(Consumer<StoredGame> reader) {
        read(reader, GAME + "WHERE g.season = ? ORDER BY g.id, s.seat", season);
    }

    /** True if any game was played on a machine whose name begins so. */
    public boolean isPlayedOn(String machine) {
        return database.number("SELECT count(*) FROM machine WHERE substr(name, 1, length(?1)) = ?1", machine) > 0;
    }

    /** The last games, the latest first. */
    public List<StoredGame> last(int most) {
        return list("g.id IN (SELECT id FROM game WHERE season = ? ORDER BY id DESC LIMIT ?)", season, most);
    }

    /** All games of a version, the latest first. */
    public void gamesOf(int version, Consumer<StoredGame> reader) {
        read(reader, GAME + "WHERE g.id IN (SELECT game FROM seat WHERE season = ? AND version = ?) "
            + "ORDER BY g.id DESC, s.seat", season, version);
    }

    /** All games that have a replay, the latest first. */
    public List<StoredGame> withReplay(int most) {
        return list("g.id IN (SELECT id FROM game WHERE replay IS NOT NULL AND season = ? ORDER BY id DESC LIMIT ?)",
            season, most);
    }

    /** The files of all kept replays, of any season. */
    public Set<String> allReplays() {
        return new HashSet<>(database.list("SELECT replay FROM game WHERE replay IS NOT NULL", row ->
            row.getString(1)));
    }

    /** A game by its number, or {@code null}. */
    public StoredGame game(long id) {
        return list("g.id = ?", id).stream().findFirst().orElse(null);
    }

    /** A game by its name, of any season, or {@code null}. */
    public StoredGame game(byte[] name) {
        return list("g.name = ?", (Object) name).stream().findFirst().orElse(null);
    }

    private List<StoredGame> list(String which, Object... values) {
        List<StoredGame> games = new ArrayList<>();
        read(games::add, GAME + "WHERE " + which + " ORDER BY g.id DESC, s.seat", values);
        return games;
    }

    private void read(Consumer<StoredGame> reader, String sql, Object... values) {
        List<StoredSeat> seats = new ArrayList<>();
        database.each(sql, row -> {
            seats.add(new StoredSeat(row.getInt(12), row.getInt(13), row.getDouble(14), row.getString(15),
                row.getInt(16), row.getLong(17), row.getLong(18), row.getLong(19),
                StoredSeat.values(row.getString(20))));
            if (seats.size() == numbers(row.getString(22)).length) {
                reader.accept(new StoredGame(row.getLong(1), row.getBytes(2), row.getInt(3), row.getLong(4),
                    row.getInt(5), row.getInt(6) > 0, row.getInt(7), row.getString(8), row.getLong(9),
                    row.getString(10), row.getString(11), row.getLong(21), seats));
                seats.clear();
            }
        }, values);
    }
}
