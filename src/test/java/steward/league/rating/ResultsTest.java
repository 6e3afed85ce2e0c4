package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.league.Season;

/** Results of games, in whatever order they come. */
class ResultsTest {

    private static Season season(int players, boolean lowerIsBetter) {
        return Season.of("crowd", "key", "limits", "rules", players, lowerIsBetter);
    }

    @Test
    void resultsAddUpHoweverTheyCome() {
        Results one = new Results(season(3, false));
        one.addClusters(List.of(new int[] {7, 8, 9}), List.of(new int[] {0, 1, 1}), 3);
        assertEquals(3 * 2.0 / 3, one.games(7, 8), 1e-12);
        assertEquals(3 * 2.0 / 3, one.points(7, 8), 1e-12);
        assertEquals(0, one.points(8, 7), 1e-12);
        assertEquals(1, one.points(9, 8), 1e-12);
        assertEquals(2, one.draws(9, 8), 1e-12);

        Results alone = new Results(season(1, false));
        alone.addAlone(5, 1, 10);
        alone.addAlone(5, 2, 20);
        alone.addAlone(5, 3, 20);
        alone.addAlone(6, 1, 99);
        assertEquals(0, alone.points(1, 2), 1e-12);
        assertEquals(1, alone.points(3, 1), 1e-12);
        assertEquals(0.5, alone.points(2, 3), 1e-12);
        assertEquals(1, alone.games(1, 2), 1e-12);
        assertEquals(1, alone.clusters(), "map 6 has been played by one bot");
    }

    /** Equal ranks are half a point for each and a draw; in a game of three each pair weighs 2/3. */
    @Test
    void equalRanksAreADraw() {
        Results two = new Results(Season.of("duel", "key", "limits", "rules", 2, false));
        two.addGame(1, new int[] {4, 7}, 0, 0);
        two.addGame(1, new int[] {7, 4}, 1, 0);
        assertEquals(1, two.draws(4, 7));
        assertEquals(1.5, two.points(4, 7));
        assertEquals(0.5, two.points(7, 4));
        assertEquals(1, two.wins(4, 7));
        assertEquals(0, two.wins(7, 4));

        Results three = new Results(Season.of("crowd", "key", "limits", "rules", 3, false));
        three.addGame(1, new int[] {1, 2, 3}, 1, 0, 1);
        assertEquals(2 / 3.0, three.draws(1, 3), 1e-12);
        assertEquals(1 / 3.0, three.points(3, 1), 1e-12);
        assertEquals(0, three.points(1, 2));
        assertEquals(2 / 3.0, three.points(2, 3), 1e-12);
    }

    /** Bots with equal ratings share a rank, and the next has that of its place. */
    @Test
    void equalRatingsShareARank() {
        Results results = new Results(Season.of("duel", "key", "limits", "rules", 2, false));
        for (int bot = 2; bot <= 3; bot++) {
            results.addSums(bot, 1, 0, 0, 0, 0, 0);
            results.addGame(bot, new int[] {1, bot}, 0, 1);
        }
        results.addGame(9, new int[] {2, 3}, 0, 0);
        LeagueTable table = LeagueTable.of(results, IntStream.rangeClosed(1, 3)
            .mapToObj(bot -> new LeagueTable.Entry(bot, "bot" + bot, false, true)).toList());
        assertEquals(List.of(1, 2, 2), table.rows().stream().map(LeagueTable.Row::rank).toList());
    }

    @Test
    void whereAScoreIsATimeTheLowerOneWins() {
        Results race = new Results(season(1, true));
        double notFinished = 1000;
        race.addAlone(5, 1, notFinished);
        race.addAlone(5, 2, 210.25);
        race.addAlone(5, 3, 210.25);
        race.addAlone(6, 1, notFinished);
        race.addAlone(6, 2, notFinished);
        assertEquals(1.5, race.points(2, 1), 1e-12);
        assertEquals(1, race.wins(2, 1), 1e-12);
        assertEquals(1, race.draws(1, 2), 1e-12);
        assertEquals(0.5, race.points(3, 2), 1e-12);
        assertEquals(0, race.points(1, 3), 1e-12);
        Ratings ratings = Ratings.of(race, List.of(1, 2, 3));
        assertTrue(ratings.difference(2, 1).elo() > 50, ratings.difference(2, 1)::toString);
    }

    /** One game, as it would be told. */
    private record Game(long seed, int[] lineup, int... ranks) {
    }

    @Test
    void theRatingsAreTheSameToTheBitInWhateverOrderGamesCome() {
        for (int variant = 0; variant < 4; variant++) {
            int players = 2 + variant / 2;
            int seeds = variant % 2 == 0 ? 60 : 13;
            Random random = new Random(variant);
            List<Game> games = new ArrayList<>();
            for (int seed = 0; seed < 60; seed++) {
                List<Integer> bots = new ArrayList<>(List.of(3, 5, 8, 9));
                Collections.shuffle(bots, random);
                for (int by = 0; by < players; by++) {
                    int[] lineup = new int[players];
                    int[] ranks = new int[players];
                    for (int seat = 0; seat < players; seat++) {
                        lineup[seat] = bots.get((seat + by) % players);
                        ranks[seat] = random.nextInt(2);
                    }
                    games.add(new Game(seed % seeds, lineup, ranks));
                }
            }
            Ratings first = null;
            for (int turn = 0; turn < 5; turn++) {
                Results results = new Results(season(players, false));
                games.forEach(game -> results.addGame(game.seed(), game.lineup(), game.ranks()));
                assertEquals(seeds, results.clusters(), 1);
                Ratings ratings = Ratings.of(results, List.of(3, 5, 8, 9));
                first = first == null ? ratings : first;
                for (int version : new int[] {3, 5, 8, 9}) {
                    assertEquals(first.rating(version), ratings.rating(version));
                }
                Collections.shuffle(games, random);
            }
        }
    }
}
