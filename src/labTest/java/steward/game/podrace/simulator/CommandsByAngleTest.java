package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.match.Refusal.refusedFor;

import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.podrace.Headings;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.match.Allocated;
import steward.numerics.SplitMix64;
import steward.numerics.StrictAngles;

/**
 * Turns by an angle: the greatest against the race itself, which is given a target aside, all others against the
 * textbook, bit for bit; on random states of every sort.
 */
@Execution(ExecutionMode.CONCURRENT)
class CommandsByAngleTest {

    private static final double[][] MAP = {{3000, 3000}, {9000, 2000}, {12000, 7000}, {5000, 6500}};
    private static final double[] DEGREES = {18, -18, 18.5, -90, 1e9, Double.NEGATIVE_INFINITY, 0, -0.0, 9, -9, 17.999,
        Math.nextDown(18.0), -Math.nextDown(18.0), 1e-300, Double.MIN_VALUE, 8 * Double.MIN_VALUE,
        -60 * Double.MIN_VALUE};
    private static final int FULL = 6;

    private final SplitMix64 random = new SplitMix64(17);
    private final RandomTurns turns = new RandomTurns(18);
    private final PodRaceSimulator fast = new PodRaceSimulator(MAP);

    /** Some pods by angle, some by target. */
    @Test
    @Tag("slow")
    void everyAngleIsThatOfTheTextbook() {
        for (int game = 0; game < 4000; game++) {
            TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
            drawState();
            turns.put(fast);
            turns.put(textbook);
            for (int turn = 0; turn < 8; turn++) {
                turns.commands(fast);
                for (int pod = 0; pod < 4; pod++) {
                    int thrust = turns.commands.thrust(pod);
                    if (random.nextInt(3) > 0) {
                        double degrees = random.nextInt(4) == 0 ? random.nextDouble() * 40 - 20
                            : DEGREES[random.nextInt(DEGREES.length)];
                        turns.commands.turn(pod, degrees, thrust);
                    }
                }
                fast.play(turns.commands);
                turns.play(textbook);
                for (int pod = 0; pod < 4; pod++) {
                    // A heading that is not read stays deferred, so that chains grow.
                    double angle = (game + turn) % 3 == 0 ? fast.heading(pod) : textbook.pod(pod).heading;
                    int number = game;
                    int count = turn;
                    Supplier<String> where = () -> "game " + number + " turn " + count + " from " + turns.text();
                    assertEquals(Races.state(textbook, pod), Races.state(fast, pod, angle), where);
                }
            }
        }
    }

    /** Also when nobody asks for a heading in 60 turns. */
    @Test
    @Tag("slow")
    void theGreatestTurnIsThatOfTheRaceWithATargetAside() {
        for (int game = 0; game < 1000; game++) {
            drawState();
            PodRace race = Recordings.official().create(MAP);
            for (int pod = 0; pod < 4; pod++) {
                if (!(Math.abs(turns.heading[pod]) < 1e12)) {   // where no target is aside any more, or unset
                    turns.heading[pod] = -0.0;
                }
            }
            turns.put(fast);
            turns.put(race);
            PodRaceSimulator asked = new PodRaceSimulator(MAP);
            for (int turn = 0; turn < 60 && !race.isOver(); turn++) {
                turns.commands(fast);
                asked.copyFrom(fast);                  // so that asking for the target leaves the headings deferred
                for (int pod = 0; pod < 4; pod++) {
                    double degrees = DEGREES[random.nextInt(FULL)];
                    int thrust = turns.commands.thrust(pod);
                    turns.commands.turn(pod, degrees, thrust);
                    race.command(pod, asked.targetX(pod, degrees), asked.targetY(pod, degrees), thrust);
                }
                fast.play(turns.commands);
                race.play();
                for (int pod = 0; pod < 4; pod++) {
                    double angle = turn % 50 == 49 ? fast.heading(pod) : race.heading(pod);
                    int number = game;
                    int count = turn;
                    assertEquals(race.pod(pod), Races.state(fast, pod, angle), () -> "game " + number + " turn " + count
                        + " from " + turns.text());
                }
            }
        }
    }

    /** No angle is computed, neither to decide nor for the direction: the base of the heading stays as it was. */
    @Test
    void theGreatestTurnIsNeverInDoubt() {
        Headings headings = new Headings();
        double[] numbers = new double[Headings.NUMBERS];
        for (double angle : new double[] {0, -0.0, 1, Math.PI, -500, Math.nextDown(512.0)}) {
            headings.set(numbers, 0, angle);
            double expected = angle;
            for (int turn = 0; turn < 40; turn++) {
                int side = random.nextInt(-1, 1);
                assertTrue(Headings.turnByQuickly(numbers, 0, 18 * side));
                expected = side == 0 ? expected : expected + side * Math.PI / 10;
                assertEquals(angle, numbers[Headings.BASE_X]);
                assertEquals(expected, Headings.angle(numbers, 0));
            }
        }
    }

    /** So that a bot can answer what it has found. */
    @Test
    void theTargetOfASmallTurnIsInItsDirection() {
        PodRace race = Recordings.official().create(MAP);
        for (int trial = 0; trial < 20_000; trial++) {
            double degrees = (random.nextDouble() - 0.5) * 35.99;
            double before = (random.nextDouble() - 0.5) * 100;
            int px = random.nextInt(-20_000, 20_000);
            int py = random.nextInt(-20_000, 20_000);
            fast.setPod(1, px, py, 0, 0, before, 0, true, 0);
            double toX = fast.targetX(1, degrees);
            double toY = fast.targetY(1, degrees);
            double apart = StrictAngles.atan2(toY - py, toX - px) - before - Math.toRadians(degrees);
            assertEquals(0, Math.IEEEremainder(apart, 2 * Math.PI), 1e-8);
            assertTrue(Math.max(Math.abs(toX), Math.abs(toY)) < 1e9, "nine digits");
        }
    }

    /** As if it were told to go where it is; a shield is raised nevertheless. */
    @Test
    void aPodWithoutAHeadingStaysWithoutOne() {
        PodCommands commands = new PodCommands(4);
        PodRaceSimulator start = new PodRaceSimulator(MAP);
        fast.copyFrom(start);
        double[] degrees = {18, 0, -7, 18};
        for (int pod = 0; pod < 4; pod++) {
            assertEquals(start.x(pod), fast.targetX(pod, degrees[pod]));
            assertEquals(start.y(pod), fast.targetY(pod, degrees[pod]));
            commands.turn(pod, degrees[pod], pod == 3 ? PodCommands.SHIELD : 200);
        }
        fast.play(commands);
        for (int pod = 0; pod < 4; pod++) {
            assertEquals(new PodState(start.x(pod), start.y(pod), 0, 0, Double.NaN, pod == 3 ? 4 : 0, true, 0),
                Races.state(fast, pod, fast.heading(pod)));
        }
    }

    @Test
    void aCommandSaysWhichSortItIs() {
        PodCommands commands = new PodCommands(2);
        commands.turn(0, -400, 77);
        commands.set(1, 5, 6, 7);
        PodCommands copy = new PodCommands(2);
        copy.copyFrom(commands);
        assertEquals(-18, copy.degrees(0));
        assertEquals(77, copy.thrust(0));
        assertEquals(Double.NaN, copy.targetX(0));
        assertEquals(Double.NaN, copy.targetY(0));
        assertEquals(Double.NaN, copy.degrees(1));
        assertEquals(5, copy.targetX(1));
        copy.clear();
        assertEquals(Double.NaN, copy.degrees(0));
    }

    @Test
    void refusesWhatCannotBe() {
        PodCommands commands = new PodCommands(4);
        refusedFor("pod 1: turn by NaN degrees", () -> commands.turn(1, Double.NaN, 200));
        refusedFor("pod 1: thrust 651", () -> commands.turn(1, 18, 651));
        refusedFor("pod 2: thrust -4", () -> commands.turn(2, 18, -4));
        refusedFor("pod 3: turn by NaN degrees", () -> fast.targetX(3, Double.NaN));
        assertThrows(IndexOutOfBoundsException.class, () -> commands.turn(4, 18, 200));
    }

    @Test
    void aTurnAllocatesNothing() {
        PodCommands commands = new PodCommands(4);
        Allocated.assertNone(20, "1,000 turns", () -> {
            drawState();
            turns.put(fast);
            return Allocated.by(() -> {
                for (int turn = 0; turn < 1000; turn++) {
                    for (int pod = 0; pod < 4; pod++) {
                        commands.turn(pod, DEGREES[(turn + pod) % DEGREES.length], 200);
                    }
                    fast.play(commands);
                }
            });
        });
    }

    /** Not far out, where places are coarse: the textbook would never end. */
    private void drawState() {
        do {
            turns.state();
        } while (!(Math.abs(turns.x[0]) + Math.abs(turns.x[1]) + Math.abs(turns.x[2]) + Math.abs(turns.x[3]) < 1e6));
    }
}
