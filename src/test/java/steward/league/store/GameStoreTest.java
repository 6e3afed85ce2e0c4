package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.files.InputException;
import steward.league.GameName;
import steward.league.LeagueFolder;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame.StoredSeat;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;
import steward.league.store.GameStore.Version;

/** Games go into a database and come out again. */
@Execution(ExecutionMode.CONCURRENT)
class GameStoreTest {

    static final Season SEASON = Season.of("duel", "key", "limits", "rules", 2, false);

    @TempDir
    private Path path;
    private LeagueFolder folder;

    private GameStore store;
    private int season;
    private GameQueries queries;
    private Version a;
    private Version b;

    @BeforeEach
    void open() {
        folder = new LeagueFolder(path);
        store = GameStore.write(folder);
        season = store.open(SEASON);
        queries = new GameQueries(store, season, SEASON);
        a = store.add("a", "./a", null, false, "1a", 1);
        b = store.add("b", "./b", null, false, "1b", 2);
    }

    @AfterEach
    void close() {
        store.close();
    }

    private int add(StoredGame... games) {
        return MadeUpGames.add(store, season, List.of(games));
    }

    static StoredGame game(Version one, Version other, long seed, int ranks, int attempt, boolean counts) {
        return new StoredGame(0, GameName.of(SEASON, seed, List.of(one.identity(), other.identity()), attempt),
            (int) seed, seed, attempt, counts, 50, null, 1000 + seed, "here", counts ? null : "aa/x.jsonl", 0,
            List.of(new StoredSeat(one.id(), ranks == 1 ? 1 : 0, 3, null, 50, 100, 900, 5000),
                new StoredSeat(other.id(), ranks == -1 ? 1 : 0, 2, ranks == -1 ? "exited" : null, 50, 200, 800, 6000)));
    }

    /** The game as one that is not of the schedule. */
    private static StoredGame free(StoredGame game) {
        return new StoredGame(0, game.name(), -1, game.seed(), game.attempt(), game.counts(), game.turns(),
            game.problem(), game.played(), game.machine(), game.replay(), game.transcript(), game.seats());
    }

    @Test
    void aGameThatIsPlayedTwiceIsStoredOnce() {
        List<StoredGame> games = List.of(game(a, b, 7, -1, 1, false), game(a, b, 7, 1, 2, true),
            game(b, a, 7, 0, 1, true));
        assertEquals(3, MadeUpGames.add(store, season, games));
        assertEquals(0, store.add(season, games));
        assertEquals(3, store.games(season));

        assertEquals(2, queries.game(games.get(1).name()).attempt());
        assertNull(queries.game(GameName.of(SEASON, 8, List.of("1a", "1b"), 1)));
        List<StoredGame> read = new ArrayList<>();
        queries.games(read::add);
        assertEquals(3, read.size());
        assertEquals(games.get(0).seats(), read.get(0).seats());
        assertEquals("aa/x.jsonl", read.get(0).replay());
        assertEquals(1, queries.withReplay(10).size());
        assertEquals(List.of(3L, 2L), queries.last(2).stream().map(StoredGame::id).toList());

        Results results = queries.results();
        assertEquals(2, results.games());
        assertEquals(1, results.playedAgain());
        assertEquals(0.5, results.points(a.id(), b.id()), 1e-12);
        assertEquals(0, results.of(b.id()).faults(), "the game that was played again does not count");
        assertEquals(2, results.of(a.id()).games());
        Results added = new Results(SEASON);
        read.forEach(game -> added.add(game, version -> false));
        assertEquals(results.points(a.id(), b.id()), added.points(a.id(), b.id()), 1e-12);
        assertEquals(results.of(a.id()).meanNanos(), added.of(a.id()).meanNanos(), 1e-9);
        assertEquals("ok", store.integrity());
    }

    /** A test stores a game while a league plays it: the league's decision has it then, and does not wait for it. */
    @Test
    void aGameThatWasStoredMeanwhileBecomesOneOfTheDecision() {
        StoredGame game = game(a, b, 7, -1, 1, true);
        assertEquals(1, store.add(season, List.of(free(game))));
        assertEquals(-1, queries.game(game.name()).decision());
        assertEquals(0, add(game));
        assertEquals(7, queries.game(game.name()).decision());
        assertEquals(0, store.add(season, List.of(free(game))), "and stays it");
        assertEquals(7, queries.game(game.name()).decision());
        assertEquals(List.of(), store.badRows(10));
    }

    private static void execute(GameStore store, String sql) {
        store.database().execute(sql);
    }

    /** A transaction may fail halfway: then games that come later must not lean on rows that are gone. */
    @Test
    void gamesAfterATransactionThatFailedAreWhole() {
        List<StoredGame> games = List.of(game(a, b, 7, -1, 1, false), game(a, b, 7, 1, 2, true));
        execute(store, "CREATE TEMP TRIGGER full BEFORE INSERT ON game WHEN NEW.attempt = 2 BEGIN SELECT "
            + "RAISE(ABORT, 'no room for the second'); END");
        assertThrows(InputException.class, () -> MadeUpGames.add(store, season, games));
        execute(store, "DROP TRIGGER full");
        assertEquals(0, store.games(season));
        assertEquals(2, MadeUpGames.add(store, season, games));
        assertEquals(0, store.database().number("SELECT count(*) FROM game WHERE lineup NOT IN (SELECT id FROM "
            + "lineup) OR machine NOT IN (SELECT id FROM machine)"));
    }

    @Test
    void versionsSeasonsAndNamesAreKept() {
        int second = store.open(Season.of("duel", "key", "longer", "rules", 2, false));
        assertEquals("longer", store.lastSeason().orElseThrow().limits());
        assertEquals(season, store.open(SEASON));
        assertEquals(SEASON, store.lastSeason().orElseThrow());
        assertTrue(season != second);

        Version two = store.add("a", "./a", null, true, "bb", 2);
        assertEquals("a", a.display());
        assertEquals("a#2", two.display());
        store.same(two, "cc", 3);
        assertEquals(two, store.version("cc").orElseThrow());
        assertEquals(two, store.present("a").orElseThrow());
        store.rename("a", "yours");
        assertEquals("yours#2", store.version("bb").orElseThrow().display());
        try (GameStore again = GameStore.read(folder)) {
            assertEquals(List.of("yours false", "b false", "yours#2 true"), again.versions().stream()
                .map(version -> version.display() + " " + version.random()).toList());
        }
    }

    @Test
    void theTableAndThePathOfManyGamesAgree() {
        List<Version> versions = List.of(MadeUpGames.bot(store, 1), MadeUpGames.bot(store, 2),
            MadeUpGames.bot(store, 3));
        new MadeUpGames(store, season, SEASON, versions, new SplittableRandom(1)).add(3000);
        List<LeagueTable.Entry> entries = versions.stream().map(version ->
            new LeagueTable.Entry(version.id(), version.display(), false, true)).toList();
        LeagueTable table = LeagueTable.of(queries.results(), entries);
        assertEquals(List.of("bot-1", "bot-2", "bot-3"), table.rows().stream().map(row -> row.entry().name())
            .toList());
        RatingPath ratings = queries.path(entries, LeagueTable.Reference.NONE);
        RatingPath.Point last = ratings.points().get(ratings.points().size() - 1);
        assertEquals(RatingPath.MOST, ratings.points().size());
        assertEquals(RatingPath.MOST, RatingPath.points(100));
        assertEquals(4, RatingPath.points(500), "a fit takes more than a hundred times as long");
        assertEquals(3000, last.games());
        assertEquals(table.rows().get(0).rating(), last.ratings()[0], 1e-9);
        Path copy = path.resolve("copy.db");
        store.backup(copy);
        assertTrue(Files.exists(copy));
    }

    /** Only games of the schedule that have come to their end are passed over when a league is resumed. */
    @Test
    void aLeagueIsResumedAfterTheGamesThatItHas() {
        Version c = store.add("c", "./c", null, false, "1c", 3);
        add(game(a, b, 0, 1, 1, true), game(b, a, 0, 1, 1, false),
            game(b, c, 2, 1, 1, true), game(c, b, 2, 1, 1, true), game(c, a, 1, 1, 1, false),
            game(c, a, 1, 1, 2, true));
        int other = store.open(Season.of("duel", "key", "longer", "rules", 2, false));
        MadeUpGames.add(store, other, List.of(game(a, c, 5, 1, 1, true)));
        List<Integer> bots = List.of(a.id(), b.id(), c.id());
        Schedule schedule = MadeUpGames.schedule(queries, bots);
        schedule.play(bots, versions -> Pairing.roundRobin(versions, 2));
        List<String> games = new ArrayList<>();
        store.add(season, List.of(schedule.decide(Long.MAX_VALUE, 6)), List.of());
        for (int k = 0; k < 6; k++) {
            Schedule.Task task = schedule.next(Long.MAX_VALUE, any -> true);
            games.add(task.decision() + " " + Arrays.toString(task.lineup()));
        }
        assertEquals(List.of("0 [2, 1]", "1 [1, 3]", "3 [1, 2]", "3 [2, 1]", "4 [1, 3]", "4 [3, 1]"), games);
        assertEquals(5, queries.nextDecision(), "the two new decisions are stored");
        assertEquals(List.of(), store.badRows(1));
    }

    @Test
    void theWriterStoresEverythingItWasGiven() throws InterruptedException {
        GameWriter writer = new GameWriter(store, season, 5000);
        writer.start();
        for (int seed = 0; seed < 5000; seed++) {
            assertTrue(writer.add(List.of(free(game(a, b, seed, 1, 1, true)))));
        }
        writer.close();
        assertEquals(5000, writer.stored());
        assertEquals(5000, store.games(season));
        assertTrue(writer.transactions() < 5000, "games that wait go together");
    }

    /** On seed 7 both fail in the first turn, on seed 8 a wins. */
    @Test
    void gamesInWhichAllFailedAreRatedByNothing() {
        StoredGame failed = new StoredGame(0, GameName.of(SEASON, 7, List.of("1a", "1b"), 1), 7, 7, 1, true, 1,
            null, 1007, "here", null, 0, List.of(new StoredSeat(a.id(), 0, 0, "exited", 1, 100, 100, 100),
            new StoredSeat(b.id(), 0, 0, "exited", 1, 100, 100, 100)));
        add(failed, game(a, b, 8, -1, 1, true));
        assertEquals(List.of(), store.badRows(1));
        assertTrue(queries.game(failed.name()).allFailed());
        Results results = queries.results();
        assertEquals(1, results.games());
        assertEquals(1, results.of(1).games());
        assertEquals(1, results.of(1).allFailed());
        assertEquals(1, results.points(1, 2), 1e-12);
    }

    @Test
    void transcriptsAndOwnValuesComeOutAsTheyWentIn() {
        SortedMap<String, Double> own = new TreeMap<>(Map.of("laps", 3.0, "water", -0.125));
        add(game(a, b, 7, 1, 1, true),
            known(game(a, b, 9, 1, 1, true), -5, own));
        assertEquals(0, queries.game(1).transcript());
        assertEquals(Map.of(), queries.game(1).seats().get(0).values());
        StoredGame read = queries.game(2);
        assertEquals(-5, read.transcript());
        assertEquals(own, read.seats().get(0).values());
        assertEquals("laps=3.0 water=-0.125", read.seats().get(0).valuesText());
        assertEquals(Map.of(), read.seats().get(1).values());

        StoredGame again = new GameLine.Reader(store, SEASON).read("a line", GameLine.game(read, SEASON),
            List.of(GameLine.seat(read.seats().get(0), a), GameLine.seat(read.seats().get(1), b)));
        assertEquals(-5, again.transcript());
        assertEquals(read.seats(), again.seats());

        StoredGame third = game(a, b, 8, 1, 3, false);
        assertEquals(3, new GameLine.Reader(store, SEASON).read("a line", GameLine.game(third, SEASON),
            List.of(GameLine.seat(third.seats().get(0), a), GameLine.seat(third.seats().get(1), b))).attempt());
    }

    /** Games end at 1000 and more, so that the second version, which began at 2000, is the present one for a while. */
    @Test
    void aVersionWhoseProgramIsPutBackIsThePresentOneAgain() {
        add(game(a, b, 5, 1, 1, true));
        assertEquals(a.id(), store.present("a").orElseThrow().id());
        Version second = store.add("a", "./a", null, false, "2a", 2000);
        assertEquals(second.id(), store.present("a").orElseThrow().id());
        add(game(second, b, 1100, 1, 1, true));
        add(game(a, b, 1200, 1, 1, true));
        assertEquals(a.id(), store.present("a").orElseThrow().id());
        assertEquals(2200, store.version("1a").orElseThrow().played());
    }

    /** The game with its transcript and the values of the first seat. */
    private static StoredGame known(StoredGame game, long transcript, SortedMap<String, Double> own) {
        StoredSeat seat = game.seats().get(0);
        return new StoredGame(0, game.name(), game.decision(), game.seed(), game.attempt(), game.counts(), game.turns(),
            game.problem(), game.played(), game.machine(), game.replay(), transcript,
            List.of(new StoredSeat(seat.version(), seat.rank(), seat.score(), seat.fault(), seat.answers(),
                seat.meanNanos(), seat.worstNanos(), seat.firstNanos(), own), game.seats().get(1)));
    }

    /** Bots a and b play the same two games on three seeds; on a fourth b wins. */
    @Test
    void equalGamesCountOnceUnlessABotDrawsByLot() {
        for (int seed = 0; seed < 4; seed++) {
            add(
                known(game(a, b, seed, seed < 3 ? -1 : 1, 1, true), seed < 3 ? 77 : 78, new TreeMap<>()),
                known(game(b, a, seed, 1, 1, true), 99, new TreeMap<>()));
        }
        Results results = queries.results();
        assertEquals(3, results.games());
        assertEquals(5, results.repeats());
        assertEquals(8, results.of(a.id()).games(), "sums are those of all games");
        assertEquals(3, results.games(a.id(), b.id()));
        assertEquals(5, queries.resultsBefore(Integer.MAX_VALUE).repeats());
        assertEquals(results.points(a.id(), b.id()), queries.known(0).before(Integer.MAX_VALUE).points(a.id(),
            b.id()));
        Results added = new Results(SEASON);
        queries.games(game -> added.add(game, version -> false));
        assertEquals(5, added.repeats());
        assertEquals(results.points(a.id(), b.id()), added.points(a.id(), b.id()));

        store.markRandom(b);
        assertEquals(0, queries.results().repeats());
        assertEquals(8, queries.results().games());
        Results part = new Results(SEASON);
        queries.games(game -> part.add(game, LeagueTable.Entry.random(store.versions().stream().map(version ->
            new LeagueTable.Entry(version.id(), version.bot(), version.random(), true)).toList())));
        assertEquals(0, part.repeats());
        assertEquals(8, part.games());
    }

    /** A limit of pages is what a full disk is to SQLite: the same error, and the same promise. */
    @Test
    void aFullDiskStopsItAndTearsNothing() throws SQLException, InterruptedException {
        add(game(a, b, 0, 1, 1, true));
        long pages = store.database().number("PRAGMA page_count");
        store.database().execute("PRAGMA max_page_count = " + (pages + 3));
        GameWriter writer = new GameWriter(store, season, 5000);
        writer.start();
        boolean more = true;
        for (int seed = 1; seed < 5000 && more; seed++) {
            more = writer.add(List.of(free(game(a, b, seed, 1, 1, true))));
        }
        writer.close();
        assertEquals(folder.database() + ": the disk is full; what was stored before is whole",
            writer.problem().getMessage());
        assertEquals("ok", store.integrity());
        assertEquals(1 + writer.stored(), store.games(season));
    }
}
