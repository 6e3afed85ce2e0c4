package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.sql.SQLException;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.league.view.LeagueOpening;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.store.GameStore;
import steward.match.TestSize;
import tools.jackson.databind.JsonNode;

/** Rows of a league's database that cannot be used: refused by name, listed, set aside. */
@Execution(ExecutionMode.CONCURRENT)
class VerifyTest {

    private static final long SEED = 12;

    @TempDir
    private Path folder;
    private BrokenRows rows;
    private Path league;

    @BeforeEach
    void aLeagueOf51Games() throws IOException {
        rows = new BrokenRows(folder, SEED);
        league = folder.resolve("night");
    }

    /** Form 4 had no digests, and took any value. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        UPDATE seat SET season = '1 99' WHERE game = 2 AND seat = 0 | column season: found '1 99', expected a whole
        UPDATE seat SET score = 'abc' WHERE game = 2 | column score: found 'abc', expected a finite number
        UPDATE seat SET score = 9e999 WHERE game = 2 | column score: found 9.0e+999, expected a finite
        UPDATE seat SET own = 'x' WHERE game = 2 | column own: found 'x', expected names with numbers
        DELETE FROM version WHERE id = 2 | table identity, row hash = '
        DELETE FROM identity WHERE version = 1 | table version, row id = 1, column id: found 1, expected one that a row
        DELETE FROM seat WHERE game = 3 AND seat = 0 | table game, row id = 3, column lineup: found
        DELETE FROM game WHERE id = 4 | AND game = 4 AND seat = 0, column game: found 4
        UPDATE game SET ranks = '0 x' WHERE id = 5 | table game, row id = 5, column ranks: found '0 x'
        UPDATE game SET lineup = 99 WHERE id = 5 | column lineup: found 99, expected a row of the
        UPDATE lineup SET versions = '1 y' WHERE id = 1 | column versions: found '1 y', expected numbers of
        UPDATE season SET players = 0 WHERE id = 1 | table season, row id = 1, column players: found 0
        UPDATE season SET limits = 'none' WHERE id = 1 | table season, row id = 1, column key: found '
        UPDATE version SET bot = x'00' WHERE id = 1 | table version, row id = 1, column bot: found X'00'
        UPDATE game SET seed = 0.5 WHERE id = 6 | table game, row id = 6, column seed: found 0.5
        """)
    @Tag("slow")
    void aBadRowOfAnEarlierFormIsRefusedByItsName(String change, String message) throws IOException, SQLException {
        Cli listed = rows.brought(change);
        assertEquals(1, listed.status(), listed.out());
        assertTrue(listed.out().contains(message) && listed.out().contains("cannot be used; --drop sets "),
            listed.out());
        Cli table = Cli.run("league", "table", league.toString());
        table.assertRefused("league.db: table ");
        assertTrue(table.err().contains(message), table.err());
    }

    /** Values that could be true: only the digest tells that they are not. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        UPDATE game SET seed = seed + 1 WHERE id = 5 | table game, row id = 5, column digest: found
        UPDATE game SET transcript = 5 WHERE id = 5 | table game, row id = 5, column digest: found
        UPDATE seat SET score = score + 1 WHERE game = 7 AND seat = 1 | table game, row id = 7, column digest: found
        UPDATE seat SET mean_nanos = 1 WHERE game = 7 AND seat = 1 | table game, row id = 7, column digest: found
        UPDATE version SET bot = 'three' WHERE id = 2 | table version, row id = 2, column digest: found
        UPDATE identity SET began = 0 WHERE version = 1 | table version, row id = 1, column digest: found
        DELETE FROM identity WHERE rowid IS NULL OR version = 1 | table version, row id = 1, column id: found 1
        UPDATE machine SET name = 'attic' WHERE id = 1 | table machine, row id = 1, column digest: found
        UPDATE season SET opened = 99 WHERE id = 1 | table season, row id = 1, column digest: found
        UPDATE seat SET own = 'x' WHERE game = 2 AND seat = 0 | column own: found 'x', expected names with numbers
        """)
    @Tag("slow")
    void anUntrueValueIsRefused(String change, String message) throws IOException {
        Cli table = rows.table(change.replace("rowid IS NULL OR ", ""));
        table.assertRefused("league.db: table ");
        assertTrue(table.err().contains(message), table.err());
        assertTrue(Cli.run("league", "verify", league.toString()).out().contains(message));
    }

    /** The numbers are those of version 0.2.0's own table. */
    @Test
    void aLeagueOfVersion020IsBroughtUpToDateOnceAndACopyKept() throws IOException {
        Path earlier = folder.resolve("earlier");
        BrokenRows.of020(earlier);
        byte[] before = Files.readAllBytes(earlier.resolve("league.db"));
        Cli.run("league", "table", earlier.toString()).assertRefused("league.db: found a database of an older form, "
            + "expected one that 'steward league run' has made or 'steward league verify' has brought up to date");
        assertArrayEquals(before, Files.readAllBytes(earlier.resolve("league.db")));
        Path copy = earlier.resolve("league.db.before-form-5-1");
        Cli verified = Cli.run("league", "verify", earlier.toString()).done();
        assertEquals("Every row can be used: 51 games\n", verified.out());
        assertEquals("steward: " + earlier.resolve("league.db") + ": brought up to date; as it was: " + copy + "\n",
            verified.err());
        assertEquals("", Cli.run("league", "verify", earlier.toString()).done().err(), "once");
        try (Stream<Path> copies = Files.list(earlier)) {
            assertEquals(List.of(copy), copies.filter(file -> file.toString().contains("before")).toList());
        }
        JsonNode table = Cli.run("league", "table", earlier.toString(), "--json").done().json();
        assertEquals(10, table.get("games").intValue());
        assertEquals(List.of("second 26 1.0", "one 28 0.667", "mine 12 0.0", "mine#2 18 0.0"), table.get("bots")
            .valueStream().map(bot -> bot.get("name").stringValue() + " " + bot.get("games") + " "
                + Math.round(1000 * bot.get("points").doubleValue()) / 1000.0).toList());
        LeagueFolder goesOn = new LeagueFolder(earlier);
        try (GameStore store = GameStore.read(goesOn)) {
            assertEquals(Season.of(LeagueOpening.setup(goesOn, goesOn.read()), goesOn.read()).key(),
                store.lastSeason().orElseThrow().key(), "its season is that of today's scene");
        }
        Files.copy(copy, earlier.resolve("league.db"), StandardCopyOption.REPLACE_EXISTING);
        Cli.run("league", "verify", earlier.toString()).done();
        assertTrue(Files.exists(earlier.resolve("league.db.before-form-5-2")));
    }

    /** Of 43 games of the present season one has lost a seat. */
    @Test
    void whatCannotBeUsedIsSetAsideAndACopyKept() throws IOException {
        rows.table("DELETE FROM seat WHERE game = 3 AND seat = 0").assertRefused("table game, row id = 3");
        Cli json = Cli.run("league", "verify", league.toString(), "--json");
        assertEquals(1, json.status());
        assertEquals("game", json.json().get("rows").get(0).get("table").stringValue(), json.out());
        assertTrue(json.json().get("setAside").isNull());
        Cli dropped = Cli.run("league", "verify", league.toString(), "--drop").done();
        Path copy = league.resolve("league.db.before-drop-1");
        assertTrue(dropped.out().endsWith("Set aside: 2 rows, with 1 game; the database as it was: " + copy + "\n"),
            dropped.out());
        assertEquals("Every row can be used: 50 games\n", Cli.run("league", "verify", league.toString()).done().out());
        assertEquals(42, Cli.run("league", "games", league.toString(), "--json").done().json().get("games").intValue());
        Files.copy(copy, league.resolve("league.db"), StandardCopyOption.REPLACE_EXISTING);
        assertEquals(1, Cli.run("league", "verify", league.toString()).status());
        JsonNode aside = Cli.run("league", "verify", league.toString(), "--drop", "--json").done().json()
            .get("setAside");
        assertEquals(1, aside.get("games").intValue());
        assertEquals(league.resolve("league.db.before-drop-2").toString(), aside.get("copy").stringValue());
    }

    /** A decision is made again from its games; a version that is lost takes its games with it. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        DELETE FROM decision WHERE season = 1 AND number = (SELECT min(number) FROM decision WHERE season = 1) \
        | expected a row of the table decision of this season | 51 games
        DELETE FROM version WHERE id = 1 | league.db: table | games
        """)
    void whatIsLeftIsWhole(String change, String refusal, String games) throws IOException {
        rows.table(change).assertRefused(refusal);
        assertEquals(1, Cli.run("league", "verify", league.toString()).status());
        Cli.run("league", "verify", league.toString(), "--drop").done();
        Cli.run("league", "table", league.toString()).done();
        String whole = Cli.run("league", "verify", league.toString()).done().out();
        assertTrue(whole.startsWith("Every row can be used: ") && whole.endsWith(games + "\n"), whole);
    }

    @Test
    @Tag("slow")
    @Tag("sized")
    void everyChangeOfARowIsSeen() throws IOException {
        damage(TestSize.of(rows.columns(), 2000));
    }

    private void damage(int times) throws IOException {
        Map<BrokenRows.Outcome, Integer> outcomes = new EnumMap<>(BrokenRows.Outcome.class);
        for (int number = 0; number < times; number++) {
            outcomes.merge(rows.check(number), 1, Integer::sum);
        }
        assertTrue(outcomes.get(BrokenRows.Outcome.SEEN) > times / 3, outcomes + ", seed " + SEED);
    }
}
