package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.rating.LeagueTable;

/** The table of a tournament: points, ties, and what is said beside it. */
class ScoresTest {

    private final List<StoredGame> games = new ArrayList<>();

    private void game(boolean counts, String problem, int[] versions, int... ranks) {
        games.add(new StoredGame(games.size() + 1, new byte[16], games.size(), 7, 1, counts, 10, problem, 0, "m", null,
            0, IntStream.range(0, ranks.length).mapToObj(seat -> new StoredSeat(versions[seat], ranks[seat],
                -ranks[seat], null, 10, 0, 0, 0)).toList()));
    }

    private void won(int winner, int loser) {
        game(true, null, new int[] {winner, loser}, 0, 1);
    }

    private PlayedGames played(int players, int... versions) {
        return new PlayedGames(Season.of("s", "k", "l", "r", players, false), IntStream.of(versions).mapToObj(version ->
            new LeagueTable.Entry(version, "bot" + version, false, true)).toList(), games);
    }

    private static List<String> rows(Scores scores) {
        return scores.rows().stream().map(row -> row.place() + " " + row.name() + " "
            + Scores.points(row.points()) + " " + row.games() + ": " + row.wins() + " " + row.draws() + " "
            + row.losses()).toList();
    }

    /** 1 and 2 have two points each of three games; 2 has beaten 1. */
    @Test
    void whoHasBeatenTheOtherIsBeforeIt() {
        won(1, 3);
        won(1, 4);
        won(2, 1);
        won(2, 3);
        won(4, 2);
        won(3, 4);
        PlayedGames played = played(2, 1, 2, 3, 4);
        assertEquals(List.of("1 bot2 2 3: 2 0 1", "2 bot1 2 3: 2 0 1", "3 bot3 1 3: 1 0 2", "4 bot4 1 3: 1 0 2"),
            rows(Scores.of(played)));
        assertEquals(1, Scores.of(played).notes(played).size());
    }

    @Test
    void whatNothingTellsApartSharesAPlace() {
        won(1, 2);
        won(2, 3);
        won(3, 1);
        game(true, null, new int[] {1, 2}, 0, 0);
        game(true, null, new int[] {3, 2}, 0, 0);
        game(true, null, new int[] {1, 3}, 0, 0);
        assertEquals(List.of("1 bot1 2 4: 1 2 1", "1 bot2 2 4: 1 2 1", "1 bot3 2 4: 1 2 1"),
            rows(Scores.of(played(2, 1, 2, 3))));
    }

    /** An attempt that was repeated is no game, and one without a result is the reason of an uneven count. */
    @Test
    void aRepeatedGameCountsOnceAndUnevenCountsHaveAReason() {
        won(1, 2);
        game(false, null, new int[] {2, 3}, 0, 1);
        won(2, 3);
        game(false, "the referee broke", new int[] {1, 3}, 0, 0);
        PlayedGames played = played(2, 1, 2, 3);
        assertEquals(List.of("1 bot1 1 1: 1 0 0", "2 bot2 1 2: 1 0 1", "3 bot3 0 1: 0 0 1"), rows(Scores.of(played)));
        List<String> notes = Scores.of(played).notes(played);
        assertTrue(notes.contains("1 attempt at a game was repeated, as other programs used the processors; each game "
            + "counts once."), notes.toString());
        assertTrue(notes.contains("bot1 has 1 game, others up to 2: 1 game without a result, such as the referee "
            + "broke."), notes.toString());
    }

    /** Of three players the second has beaten one of two others. */
    @Test
    void amongSeveralPlayersThoseBelowCount() {
        game(true, null, new int[] {1, 2, 3}, 0, 1, 2);
        assertEquals(List.of("1 bot1 1 1: 1 0 0", "2 bot2 0.5 1: 0 0 1", "3 bot3 0 1: 0 0 1"),
            rows(Scores.of(played(3, 1, 2, 3))));
    }

    /** Scores are 0 for 1 and -1 for the others, on the same map: 1 has beaten two others of two. */
    @Test
    void aloneTheResultsOfOneMapAreAGameOfAll() {
        game(true, null, new int[] {1}, 0);
        game(true, null, new int[] {2}, 1);
        game(true, null, new int[] {3}, 1);
        assertEquals(List.of("1 bot1 1 1: 1 0 0", "2 bot2 0.25 1: 0 0 1", "2 bot3 0.25 1: 0 0 1"),
            rows(Scores.of(played(1, 1, 2, 3))));
    }
}
