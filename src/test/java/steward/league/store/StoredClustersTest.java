package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.IntBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.LeagueFolder;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;
import steward.league.store.GameStore.Version;

/** Clusters of stored games: which games belong together, and which of equal ones counts. */
class StoredClustersTest {

    private static final Season SEASON = GameStoreTest.SEASON;

    @TempDir
    private Path path;

    private static List<Version> bots(GameStore store) {
        return MadeUpGames.bots(store, 3);
    }

    /** Two games of a decision, from both seats; decisions go through the three pairs of bots in turn. */
    private static List<StoredGame> pair(List<Version> bots, int decision, long seed, IntBinaryOperator ranks,
                                         IntBinaryOperator transcript) {
        List<StoredGame> games = new ArrayList<>();
        for (int seat = 0; seat < 2; seat++) {
            Version one = bots.get((decision + seat) % 3);
            Version other = bots.get((decision + 1 - seat) % 3);
            StoredGame game = GameStoreTest.game(one, other, seed, ranks.applyAsInt(one.id(), other.id()), 1, true);
            games.add(new StoredGame(0, game.name(), decision, seed, 1, true, 50, null, 1, "here", null,
                transcript.applyAsInt(one.id(), other.id()), game.seats()));
        }
        return games;
    }

    private static List<LeagueTable.Entry> entries(List<Version> bots) {
        return bots.stream().map(bot -> new LeagueTable.Entry(bot.id(), bot.display(), false, true)).toList();
    }

    /** Workers bring games in any order; which of the equal ones counts does not depend on it. */
    @Test
    void theTableOfEqualGamesDoesNotDependOnTheOrderInWhichTheyWereStored() throws IOException {
        Set<List<Double>> tables = new HashSet<>();
        for (int turn = 0; turn < 6; turn++) {
            try (GameStore store = GameStore.write(new LeagueFolder(Files.createDirectory(path.resolve("" + turn))))) {
                int season = store.open(SEASON);
                List<Version> bots = bots(store);
                List<StoredGame> games = new ArrayList<>();
                for (int decision = 0; decision < 12; decision++) {
                    games.addAll(pair(bots, decision, decision, (one, other) -> one < other ? -1 : 1,
                        (one, other) -> 10 * one + other));
                }
                Collections.shuffle(games, new Random(turn));
                MadeUpGames.add(store, season, games);
                LeagueTable table = LeagueTable.of(new GameQueries(store, season, SEASON).results(), entries(bots));
                assertEquals(6, table.results().games());
                assertEquals(18, table.results().repeats());
                tables.add(table.rows().stream().map(LeagueTable.Row::rating).toList());
            }
        }
        assertEquals(1, tables.size(), tables::toString);
    }

    /** Games by the seeds that somebody chose, read together and one by one, are the same clusters. */
    @Test
    void seedsThatSeveralPairingsShareAreFound() {
        try (GameStore store = GameStore.write(new LeagueFolder(path))) {
            int season = store.open(SEASON);
            List<Version> versions = bots(store);
            SplittableRandom random = new SplittableRandom(1);
            List<StoredGame> games = new ArrayList<>();
            for (int k = 0; k < 200; k++) {
                int one = random.nextInt(3);
                StoredGame game = GameStoreTest.game(versions.get(one), versions.get((one + 1 + random.nextInt(2)) % 3),
                    random.nextInt(40), random.nextInt(3) - 1, k + 1, true);
                games.add(new StoredGame(0, game.name(), -1, game.seed(), game.attempt(), true, game.turns(), null,
                    game.played(), game.machine(), null, 0, game.seats()));
            }
            MadeUpGames.add(store, season, games);
            new MadeUpGames(store, season, SEASON, versions, random).add(300);
            GameQueries queries = new GameQueries(store, season, SEASON);
            Results single = new Results(SEASON);
            queries.games(game -> single.add(game, version -> false));
            List<LeagueTable.Entry> entries = entries(versions);
            LeagueTable table = LeagueTable.of(queries.results(), entries);
            assertEquals(LeagueTable.of(single, entries).rows().stream().map(LeagueTable.Row::bar).toList(),
                table.rows().stream().map(LeagueTable.Row::bar).toList());
            assertTrue(single.clusters() < 40 + 150 + 10, () -> "found " + single.clusters() + " clusters");
            RatingPath path = queries.path(entries, LeagueTable.Reference.NONE);
            assertEquals(table.rows().get(0).bar(), path.points().get(path.points().size() - 1).bars()[
                table.rows().get(0).entry().version() - 1], 1e-9);
        }
    }

    /** Three pairings on one list of ten seeds: a seed is one cluster, however the games are read. */
    @Test
    void pairingsThatPlayAListShareItsSeeds() {
        try (GameStore store = GameStore.write(new LeagueFolder(path))) {
            int season = store.open(SEASON);
            List<Version> bots = bots(store);
            List<StoredGame> games = new ArrayList<>();
            for (int decision = 0; decision < 30; decision++) {
                long seed = 1000 + 7 * (decision / 3);
                games.addAll(pair(bots, decision, seed, (one, other) -> seed % 2 == 0 ? -1 : 1, (one, other) -> 0));
            }
            MadeUpGames.add(store, season, games);
            GameQueries queries = new GameQueries(store, season, SEASON);
            assertEquals(10, queries.results().clusters());
            assertEquals(10, queries.resultsBefore(30).clusters());
            assertEquals(60, queries.results().games());
        }
    }
}
