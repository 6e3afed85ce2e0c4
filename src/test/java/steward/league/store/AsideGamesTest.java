package steward.league.store;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.league.GameName;
import steward.league.LeagueFolder;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.store.AsideGames.Range;
import steward.league.store.GameStore.Version;

/** Games that do not count for a time: 1 to 3 are won by a, drawn, and lost by b, which failed; in 4 both failed. */
class AsideGamesTest {

    @TempDir
    private Path folder;
    private GameStore store;
    private int season;
    private Version a;
    private Version b;
    private AsideGames aside;

    @BeforeEach
    void fourGames() {
        store = GameStore.write(new LeagueFolder(folder));
        season = store.open(GameStoreTest.SEASON);
        a = store.add("a", "./a", null, false, "1a", 1);
        b = store.add("b", "./b", null, false, "1b", 2);
        aside = new AsideGames(store);
        MadeUpGames.add(store, season, List.of(game(7, 1, 0, null, null, "here"),
            game(8, 1, 0, null, null, "worker x: m"), game(9, 1, 1, null, "exited", "worker x: m"),
            game(10, 1, 0, "exited", "exited", "worker x: m")));
    }

    private StoredGame game(long seed, int attempt, int rank, String one, String other, String machine) {
        return new StoredGame(0, GameName.of(GameStoreTest.SEASON, seed, List.of("1a", "1b"), attempt), (int) seed,
            seed, attempt, true, 1, null, seed, machine, null, 0, List.of(
            new StoredSeat(a.id(), 0, 1, one, 1, 1, 1, 1), new StoredSeat(b.id(), rank, 0, other, 1, 1, 1, 1)));
    }

    /** By number: 1 if it counts, F if all failed, or the problem. */
    private List<String> games() {
        assertEquals(List.of(), store.badRows(5));
        List<String> games = new ArrayList<>();
        new GameQueries(store, season, GameStoreTest.SEASON).games(game -> games.add(game.problem() != null
            ? game.problem() : game.allFailed() ? "F" : game.counts() ? "1" : "0"));
        return games;
    }

    /** Decisions whose game of a against b is missing, with the number of attempts at it. */
    private List<String> missing() {
        GameQueries queries = new GameQueries(store, season, GameStoreTest.SEASON);
        Map<Integer, Integer> attempts = new HashMap<>();
        queries.games(game -> attempts.put(game.decision(), game.attempt()));
        Schedule schedule = MadeUpGames.schedule(queries, List.of(a.id(), b.id()));
        schedule.play(List.of(a.id(), b.id()), versions -> Pairing.roundRobin(versions, 2));
        return schedule.waiting(Long.MAX_VALUE).stream().filter(task -> task.lineup()[0] == a.id())
            .map(task -> task.decision() + " after " + attempts.getOrDefault(task.decision(), 0)).toList();
    }

    private long counting() {
        return new GameQueries(store, season, GameStoreTest.SEASON).results().games();
    }

    @Test
    void gamesOfAWorkerAreSuspendedAndCountAgainOrNever() {
        assertEquals(3, aside.suspend("worker x: ", "suspended: why"));
        assertEquals(List.of("1", "suspended: why", "suspended: why", "suspended: why"), games());
        assertEquals(1, counting());
        assertEquals(3, aside.restore("worker x: "));
        assertEquals(List.of("1", "1", "1", "F"), games());
        assertEquals(3, counting());
        aside.suspend("worker x: ", "suspended: why");
        GameQueries queries = new GameQueries(store, season, GameStoreTest.SEASON);
        assertEquals(3, aside.setAside(queries, season, "worker x: ", "set aside: why").size());
        assertEquals(List.of("8 after 1", "9 after 1", "10 after 1"), missing());
        assertEquals(0, aside.restore("worker x: "));
        assertEquals(1, counting());
        GameLine.Reader reader = new GameLine.Reader(store, GameStoreTest.SEASON);
        queries.games(game -> assertArrayEquals(game.name(), reader.read("a line", GameLine.game(game,
            GameStoreTest.SEASON), List.of(GameLine.seat(game.seats().get(0), a), GameLine.seat(game.seats().get(1),
            b))).name(), "another league may have it, too"));
    }

    /** Which games are left out is never up to how they ended. */
    @Test
    void allGamesOfARangeAreForgivenWhateverTheyCameTo() {
        assertEquals(3, aside.forgive("b", new Range(2, 9)));
        String why = "forgiven: games 2 to 9 of b";
        assertEquals(List.of("1", why, why, why), games());
        assertEquals(3, new GameQueries(store, season, GameStoreTest.SEASON).results().forgiven());
        assertEquals(0, aside.forgive("b", new Range(2, 9)), "once");
        assertEquals(List.of(), missing());
        assertEquals(1, aside.takeBack("a", new Range(4, 4)), "it is a game of both");
        assertEquals(2, aside.takeBack("b", new Range(1, 99)));
        assertEquals(List.of("1", "1", "1", "F"), games());
        assertEquals(0, aside.forgive("c", new Range(1, 99)));
    }

    @Test
    void failedGamesArePlayedAgainAndThatIsTakenBack() {
        assertEquals(2, aside.playAgain("b", new Range(1, 4)));
        assertEquals(List.of("9 after 1", "10 after 1"), missing());
        StoredGame further = game(9, 2, 0, null, null, "here");
        store.add(season, List.of(further));
        assertEquals(List.of("10 after 1"), missing());
        assertEquals(3, counting());
        assertEquals(2, aside.takeBack("b", new Range(1, 4)));
        assertEquals(List.of("1", "1", "1", "F", "forgiven: game 3, an earlier attempt, counts again"), games());
        assertEquals(2, aside.playAgain("b", new Range(1, 4)));
        assertEquals(List.of("9 after 2", "10 after 1"), missing(), "a third attempt is played");
    }
}
