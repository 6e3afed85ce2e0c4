package steward.league.rating;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import steward.league.Season;

/** The fit against closed forms and against strengths that are known. */
class BradleyTerryTest {

    @Test
    void twoBotsDifferByTheLogarithmOfTheirOdds() {
        // With n games and the share p the likelihood is greatest at 400 log10(p / (1 - p)); the bar of the difference
        // d is 1.96 (400 / ln 10) / sqrt(n p (1 - p)), and that of d / 2, the distance to the mean, half of it. The
        // prior of 750 Elo pulls by less than 1 in 1000 at so many games.
        int games = 10_000;
        BradleyTerry fit = BradleyTerry.fit(new double[][] {{0, 7500}, {2500, 0}},
            new double[][] {{0, games}, {games, 0}});
        double difference = 400 * Math.log10(3);
        assertEquals(difference, fit.rating(0) - fit.rating(1), 0.2);
        assertEquals(0, fit.rating(0) + fit.rating(1), 1e-9);
        assertEquals(1.96 * 173.7178 / Math.sqrt(games * 0.75 * 0.25) / 2, fit.bar(0), 0.01);
        assertEquals(fit.bar(0), fit.bar(1), 1e-9);
    }

    @Test
    void aBotThatHasWonEverythingIsFinite() {
        BradleyTerry fit = BradleyTerry.fit(new double[][] {{0, 500}, {0, 0}}, new double[][] {{0, 500}, {500, 0}});
        assertTrue(fit.rating(0) > 300 && fit.rating(0) < 3000, () -> "rating " + fit.rating(0));
        assertTrue(fit.bar(0) > 100, () -> "bar " + fit.bar(0));
    }

    @Test
    void aBotThatHasJustComeDoesNotWidenTheOthersBars() {
        double[][] games = {{0, 1000, 0, 0}, {1000, 0, 0, 0}, {0, 0, 0, 2}, {0, 0, 2, 0}};
        double[][] points = {{0, 500, 0, 0}, {500, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 1, 0}};
        BradleyTerry fit = BradleyTerry.fit(points, games);
        // As between the two alone, 173.7 * 1.96 / sqrt(1000 / 4) / 2 = 10.8, and the mean shifts by the newcomers'
        // 4 of 2004 games.
        assertTrue(fit.bar(0) < 13, () -> "bar " + fit.bar(0));
        assertTrue(fit.bar(2) > 200, () -> "bar " + fit.bar(2));
    }

    @Test
    void knownStrengthsAreWithinTheirBars() {
        double[] strength = {150, 60, 0, -60, -150};
        SplittableRandom random = new SplittableRandom(4);
        int inside = 0;
        int leagues = 200;
        for (int league = 0; league < leagues; league++) {
            double[][] points = new double[5][5];
            double[][] games = new double[5][5];
            for (int i = 0; i < 5; i++) {
                for (int j = 0; j < i; j++) {
                    for (int game = 0; game < 100; game++) {
                        boolean win = random.nextDouble() < 1 / (1 + Math.pow(10, (strength[j] - strength[i]) / 400));
                        points[i][j] += win ? 1 : 0;
                        points[j][i] += win ? 0 : 1;
                    }
                    games[i][j] = 100;
                    games[j][i] = 100;
                }
            }
            BradleyTerry fit = BradleyTerry.fit(points, games);
            for (int bot = 0; bot < 5; bot++) {
                inside += Math.abs(fit.rating(bot) - strength[bot]) <= fit.bar(bot) ? 1 : 0;
            }
        }
        // 1000 bars of 95%: 950 on average; bots of one league go together, so that the spread is at most
        // sqrt(5 * 1000 * 0.95 * 0.05) = 15, and four times that is allowed.
        int found = inside;
        assertTrue(Math.abs(inside - 950) <= 60, () -> found + " of 1000 within their bars");
    }

    @Test
    void resultsAddUpHoweverTheyCome() {
        Results one = new Results(Season.of("crowd", "key", "limits", "rules", 3, false));
        one.addGames(new int[] {7, 8, 9}, new int[] {0, 1, 1}, 3);
        assertEquals(3 * 2.0 / 3, one.games(7, 8), 1e-12);
        assertEquals(3 * 2.0 / 3, one.points(7, 8), 1e-12);
        assertEquals(0, one.points(8, 7), 1e-12);
        assertEquals(1, one.points(9, 8), 1e-12);
        assertEquals(2, one.draws(9, 8), 1e-12);

        Results alone = new Results(Season.of("solo", "key", "limits", "rules", 1, false));
        alone.addAlone(5, 1, 10);
        alone.addAlone(5, 2, 20);
        alone.addAlone(5, 3, 20);
        alone.addAlone(6, 1, 99);
        assertEquals(0, alone.points(1, 2), 1e-12);
        assertEquals(1, alone.points(3, 1), 1e-12);
        assertEquals(0.5, alone.points(2, 3), 1e-12);
        assertEquals(1, alone.games(1, 2), 1e-12);
    }

    @Test
    void whereAScoreIsATimeTheLowerOneWins() {
        Results race = new Results(Season.of("race", "key", "limits", "rules", 1, true));
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
    }
}
