package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
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
    void aLeagueOfSixGames() throws IOException {
        rows = new BrokenRows(folder, SEED);
        league = folder.resolve("night");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        UPDATE seat SET season = '1 99' WHERE game = 2 AND seat = 0 | column season: found '1 99', expected a whole
        UPDATE seat SET score = 'abc' WHERE game = 2 | column score: found 'abc', expected a finite number
        UPDATE seat SET score = 9e999 WHERE game = 2 | column score: found 9.0e+999, expected a finite
        DELETE FROM version WHERE id = 2 | table identity, row hash = '0000
        DELETE FROM seat WHERE game = 3 AND seat = 0 | table game, row id = 3, column lineup: found
        DELETE FROM game WHERE id = 4 | AND game = 4 AND seat = 0, column game: found 4
        UPDATE game SET ranks = '0 x' WHERE id = 5 | table game, row id = 5, column ranks: found '0 x'
        UPDATE game SET lineup = 99 WHERE id = 5 | column lineup: found 99, expected a row of the
        UPDATE lineup SET versions = '1 y' WHERE id = 1 | column versions: found '1 y', expected numbers of
        UPDATE season SET players = 0 | table season, row id = 1, column players: found 0
        UPDATE season SET limits = 'none' | table season, row id = 1, column key: found '
        UPDATE version SET bot = x'00' WHERE id = 1 | table version, row id = 1, column bot: found X'00'
        UPDATE game SET seed = 0.5 WHERE id = 6 | table game, row id = 6, column seed: found 0.5
        """)
    @Tag("slow")
    void aBadRowIsRefusedByItsName(String change, String message) throws IOException {
        Cli table = rows.table(change);
        table.assertRefused("league.db: table ");
        assertTrue(table.err().contains(message), table.err());
        Cli listed = Cli.run("league", "verify", league.toString());
        assertEquals(1, listed.status());
        assertTrue(listed.out().contains(message) && listed.out().contains("cannot be used; --drop sets "),
            listed.out());
    }

    /** Of six games one has lost a seat: the table counts five. */
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
        assertEquals("Every row can be used: 5 games\n", Cli.run("league", "verify", league.toString()).done().out());
        assertEquals(5, Cli.run("league", "table", league.toString(), "--json").done().json().get("games").intValue());
        Files.copy(copy, league.resolve("league.db"), StandardCopyOption.REPLACE_EXISTING);
        assertEquals(1, Cli.run("league", "verify", league.toString()).status());
        JsonNode aside = Cli.run("league", "verify", league.toString(), "--drop", "--json").done().json()
            .get("setAside");
        assertEquals(1, aside.get("games").intValue());
        assertEquals(league.resolve("league.db.before-drop-2").toString(), aside.get("copy").stringValue());
    }

    /** A version that is lost takes its games with it. */
    @Test
    void gamesOfAVersionThatIsNotThereAreSetAside() throws IOException {
        rows.table("DELETE FROM version WHERE id = 1");
        Cli.run("league", "verify", league.toString(), "--drop").done();
        Cli.run("league", "table", league.toString()).done();
        assertEquals("Every row can be used: ", Cli.run("league", "verify", league.toString()).done().out()
            .substring(0, 23));
    }

    @Test
    @Tag("slow")
    void rowsThatAreDamagedAtRandomAreRefusedOrCount() throws IOException {
        damage(20);
    }

    @Test
    @Tag("campaign")
    void manyRowsThatAreDamagedAtRandomAreRefusedOrCount() throws IOException {
        damage(150);
    }

    private void damage(int times) throws IOException {
        int refused = 0;
        for (int number = 0; number < times; number++) {
            refused += rows.check(number) ? 1 : 0;
        }
        assertTrue(refused > times / 3, refused + " refused, seed " + SEED);
    }
}
