package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.LeagueFolder;
import steward.league.store.GameStore.Version;

/** Reading while another connection writes: the sums of a league that is being played. */
class SnapshotTest {

    private static final int BOTS = 24;

    @TempDir
    private Path folder;

    /** A run stores games of new pairings, and its page reads the table, between whose queries it stores more. */
    @Test
    @Tag("slow")
    void whatIsReadByMoreThanOneQueryIsOfOneMoment() {
        try (GameStore writer = GameStore.write(new LeagueFolder(folder))) {
            int season = writer.open(GameStoreTest.SEASON);
            List<Version> bots = MadeUpGames.bots(writer, BOTS);
            try (GameStore reader = GameStore.read(new LeagueFolder(folder))) {
                CompletableFuture<Void> written = CompletableFuture.runAsync(() -> write(writer, season, bots));
                GameQueries queries = new GameQueries(reader, season, GameStoreTest.SEASON);
                while (!written.isDone()) {
                    queries.results();
                    queries.resultsBefore(Integer.MAX_VALUE);
                    MadeUpGames.schedule(queries, List.of());
                    queries.known(0).before(Integer.MAX_VALUE);
                    assertEquals(List.of(), reader.badRows(1));
                }
                written.join();
                assertEquals(BOTS * (BOTS - 1), queries.results().games());
            }
        }
    }

    private static void write(GameStore writer, int season, List<Version> bots) {
        for (int one = 0; one < BOTS; one++) {
            for (int other = 0; other < BOTS; other++) {
                if (one != other) {
                    MadeUpGames.add(writer, season, List.of(GameStoreTest.game(bots.get(one), bots.get(other),
                        one * BOTS + other, -1, 1, true)));
                }
            }
        }
    }
}
