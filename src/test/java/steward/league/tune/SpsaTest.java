package steward.league.tune;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Parameters in commands, and how they climb. */
class SpsaTest {

    @Test
    void parametersAreRealWholeOrChoices() {
        TunedCommand command = TunedCommand.parse("a=./a --x {x:0.5..2} --n {n:1..9@3} --way {way:left|right|up@up}");
        assertEquals("a=./a --x 1.25 --n 3 --way up", command.with(command.start()));
        assertEquals("a=./a --x 0.5 --n 1 --way left", command.with(0, 0, 0));
        assertEquals("a=./a --x 2 --n 9 --way up", command.with(1, 1, 1));
        assertEquals("x 2, n 9, way up", command.text(1, 1, 1));
        int[] counts = new int[10];
        for (int k = 0; k < 900; k++) {
            counts[Integer.parseInt(command.parameters().get(1).value((k + 0.5) / 900))]++;
        }
        assertEquals(List.of(0, 100, 100, 100, 100, 100, 100, 100, 100, 100),
            Arrays.stream(counts).boxed().toList());
        for (String wrong : new String[] {"./a", "./a {x}", "./a {x:1}", "./a {x:2..1}", "./a {x:1..2", "./a {x:a|a}",
            "./a {x:1..2} {x:1..2}", "./a {x:1..9@1.5}", "./a {x:1..2@3}", "./a {x:a|b@c}", "./a {1x:1..2}"}) {
            assertThrows(IllegalArgumentException.class, () -> TunedCommand.parse(wrong), wrong);
        }
    }

    @Test
    void itClimbsAHillOfNoisyScores() {
        // Scores of a win or a loss in each of 8 games, with a chance that falls with the distance to (0.7, 0.2).
        TunedCommand command = TunedCommand.parse("./a {x:0.0..1.0@0.2} {y:0.0..1.0@0.9}");
        int found = 0;
        for (long seed = 0; seed < 20; seed++) {
            Spsa search = new Spsa(command, 150, seed);
            SplittableRandom random = new SplittableRandom(seed);
            while (!search.isOver()) {
                double plus = score(search.trial(1), random);
                search.go(plus, score(search.trial(-1), random));
            }
            double[] result = search.result();
            found += Math.hypot(result[0] - 0.7, result[1] - 0.2) < 0.2 ? 1 : 0;
        }
        int times = found;
        assertTrue(found >= 18, () -> times + " of 20");
    }

    private static double score(double[] places, SplittableRandom random) {
        double distance = Math.hypot(places[0] - 0.7, places[1] - 0.2);
        int wins = 0;
        for (int game = 0; game < 8; game++) {
            wins += random.nextDouble() < 0.9 - 0.8 * distance ? 1 : 0;
        }
        return wins / 8.0;
    }

    /**
     * Step k goes along the difference of scores by a gain of ((K/10 + 1)/(K/10 + 1 + k))^0.602 of the first, divided
     * by the trial's move, which falls as (k + 1)^-0.101: with K = 10 the k-th step is (2/(2 + k))^0.602 (k + 1)^0.101
     * of the first, towards the better trial.
     */
    @Test
    void stepsGetSmallerAsSpallRecommends() {
        Spsa search = new Spsa(TunedCommand.parse("./a {x:0.0..1.0@0.5}"), 10, 9);
        double first = 0;
        for (int k = 0; k < 10; k++) {
            double place = search.path().get(k)[0];
            double towards = Math.signum(search.trial(1)[0] - place);
            search.go(0.51, 0.5);
            double step = (search.path().get(k + 1)[0] - place) * towards;
            first = k == 0 ? step : first;
            assertEquals(Math.pow(2.0 / (2 + k), 0.602) * Math.pow(k + 1, 0.101), step / first, 1e-9, "step " + k);
        }
        assertTrue(first > 0);
    }

    @Test
    void theSameScoresMakeTheSamePath() {
        TunedCommand command = TunedCommand.parse("./a {x:0.0..1.0} {n:1..3}");
        Spsa one = new Spsa(command, 10, 4);
        Spsa other = new Spsa(command, 10, 4);
        for (int step = 0; step < 10; step++) {
            assertTrue(!command.with(one.trial(1)).equals(command.with(one.trial(-1))), "trials differ");
            one.go(0.25 + step / 20.0, 0.5);
            other.go(0.25 + step / 20.0, 0.5);
        }
        assertEquals(command.with(one.result()), command.with(other.result()));
        assertTrue(one.isOver() && one.path().size() == 11);
    }
}
