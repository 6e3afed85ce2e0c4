package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestSize;
import steward.physics.event.Scenes;

/**
 * The simulator against the plain kernel (the event loop of every scene, all pairs each time) and against the textbook
 * (no shared code but sine and cosine): every number of every state, and every impact, bit for bit. Turns are random;
 * their number is 100,000, or what {@code -Psteward.turns=10000000} says, the seed is printed, and
 * {@code -Psteward.seed} sets another: {@code gradle test --tests '*PodRaceSimulatorTest' -Psteward.turns=10000000}.
 */
@Execution(ExecutionMode.CONCURRENT)
class PodRaceSimulatorTest {

    private static final long TURNS = Long.getLong("steward.turns", 60_000);
    private static final long SEED = Long.getLong("steward.seed", 5);

    private final PodRaceType.PodRaceSetup setup = Recordings.official();
    private final RandomTurns random = new RandomTurns(SEED);

    @Test
    @Tag("sized")
    void everyBitIsThatOfThePlainKernelAndOfTheTextbook(TestReporter report) {
        compareTurns(TestSize.isWhole() ? TURNS : Long.getLong("steward.turns", TURNS / 6), report);
    }

    private void compareTurns(long wanted, TestReporter report) {
        report.publishEntry("seed " + SEED + ", " + wanted + " turns");
        double[][] map = null;
        PodRaceSimulator fast = null;
        long impacts = 0;
        long passes = 0;
        int most = 0;
        int limited = 0;
        long turns = 0;
        for (long game = 0; turns < wanted; game++) {
            if (game % 100 == 0) {
                map = random.map();
                fast = new PodRaceSimulator(map);
            }
            PodRace plain = Races.plain(setup, map);
            PodRace shipped = setup.create(map);
            TextbookPodRace textbook = new TextbookPodRace(map, 4);
            fast.setRecorded(game % 2 == 0);
            random.state();
            random.put(fast);
            fast.setTurnsLeft(0, setup.settings().turnsWithoutCheckpoint());
            fast.setTurnsLeft(1, setup.settings().turnsWithoutCheckpoint());
            random.put(plain);
            random.put(shipped);
            random.put(textbook);
            int length = random.turns();
            for (int turn = 0; turn < length && !plain.isOver(); turn++, turns++) {
                random.commands(fast);
                Races.give(plain, random.commands);
                Races.give(shipped, random.commands);
                passes -= passed(fast);
                fast.play(random.commands);
                plain.play();
                shipped.play();
                passes += passed(fast);
                long number = game;
                Supplier<String> where = () -> "game " + number + ", from " + random.text();
                limited += plain.log().limited() ? 1 : 0;
                if (!plain.log().limited()) {         // far out, where places are coarse: the textbook would never end
                    random.play(textbook);
                    compare(textbook, plain, where);
                }
                compare(fast, plain, where);
                assertEquals(plain.hash(), shipped.hash(), where);
                Scenes.assertSameLog(plain.log(), shipped.log(), where);
                if (game % 2 == 0) {
                    Scenes.assertSameLog(plain.log(), fast.log(), where);
                }
                impacts += plain.log().impacts();
                most = Math.max(most, plain.log().impacts());
                if (plain.log().limited()) {
                    break;
                }
            }
        }
        report.publishEntry(impacts + " impacts, at most " + most + " in a turn, " + passes + " checkpoints passed, "
            + limited + " turns at the limit of impacts");
        assertTrue(impacts > wanted / 10 && passes > wanted / 200, "too little happened");
    }

    private static long passed(PodRaceSimulator race) {
        return race.passed(0) + race.passed(1) + race.passed(2) + race.passed(3);
    }

    private static void compare(TextbookPodRace textbook, PodRace plain, Supplier<String> where) {
        for (int k = 0; k < 4; k++) {
            assertEquals(plain.pod(k), Races.state(textbook, k), () -> "textbook, " + where.get());
        }
    }

    private static void compare(PodRaceSimulator fast, PodRace plain, Supplier<String> where) {
        for (int k = 0; k < 4; k++) {
            PodState expected = plain.pod(k);
            // Half of the time the recipe of a heading stays as it is, so that chains grow.
            double angle = fast.shieldTimer(k) % 2 == 0 || fast.x(k) % 2 == 0 ? fast.heading(k) : expected.heading();
            assertEquals(expected, Races.state(fast, k, angle), () -> "simulator, " + where.get());
            if (!plain.isOver()) {                     // behind the finish the simulator counts on
                assertEquals(plain.nextCheckpoint(k), fast.nextCheckpoint(k), where);
            }
            assertEquals(plain.toNext(k), fast.toNext(k), where);
        }
        for (int player = 0; player < 2; player++) {
            assertEquals(plain.turnsLeft(player), fast.turnsLeft(player), where);
        }
    }
}
