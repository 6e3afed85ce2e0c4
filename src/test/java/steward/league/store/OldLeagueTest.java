package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.league.view.LeagueOpening;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.rating.Results;

/**
 * A folder that Steward 0.2.0 has written: {@code league init night --scene duel --seed 5}, {@code add night
 * builtin:racer builtin:regular} and {@code run night --games 4}, of which regular won all.
 */
class OldLeagueTest {

    @TempDir
    private Path path;
    private LeagueFolder folder;

    @BeforeEach
    void unpack() throws IOException {
        NativeLibrary.prepare(path);            // before the first connection, which this test makes by itself
        try (InputStream file = OldLeagueTest.class.getResourceAsStream("league-0.2.0.zip");
             ZipInputStream zip = new ZipInputStream(file)) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                Path to = path.resolve(entry.getName());
                Files.createDirectories(to.getParent());
                Files.copy(zip, to);
            }
        }
        folder = new LeagueFolder(path.resolve("night"));
    }

    private static int form(Path database) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database)) {
            return connection.createStatement().executeQuery(SchemaVersion.FORM).getInt(1);
        }
    }

    @Test
    void itIsBroughtUpToDateWithAllItsGamesAndGoesOn() throws SQLException {
        assertEquals(4, form(folder.database()));
        String refusal = assertThrows(InputException.class, () -> GameStore.read(folder)).getMessage();
        assertTrue(refusal.endsWith("found a database of an older form, expected one that 'steward league run' has "
            + "made or 'steward league verify' has brought up to date"), refusal);

        try (GameStore store = GameStore.write(folder)) {
            assertEquals(4, form(store.before().orElseThrow()), "the copy is as it was");
            assertEquals(List.of(), store.badRows(1));
            assertEquals(List.of("racer", "regular"),
                store.versions().stream().map(GameStore.Version::display).toList());
            Season season = store.lastSeason().orElseThrow();
            Results results = new GameQueries(store, store.season(season).orElseThrow(), season).results();
            assertEquals(2, results.games(), "two games are the others again, on another seed");
            assertEquals(4, results.of(1).games());
            assertEquals(results.games(), results.points(2, 1), 1e-12);
            LeagueSettings settings = folder.read();
            assertEquals(season.key(), Season.of(LeagueOpening.setup(folder, settings), settings).key());
        }
        assertEquals(SchemaVersion.NEWEST, form(folder.database()));
        try (GameStore store = GameStore.write(folder)) {
            assertTrue(store.before().isEmpty());
            assertEquals(4, store.games());
        }
    }
}
