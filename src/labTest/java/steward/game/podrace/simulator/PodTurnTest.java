package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;
import steward.physics.event.FarPairs;
import steward.physics.event.OfficialAdvance;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/**
 * The fast turn at its edges: the official recordings, doubts, filters, what it refuses, and that it allocates nothing.
 */
@Execution(ExecutionMode.CONCURRENT)
class PodTurnTest {

    private static final double[][] MAP = {{3000, 3000}, {9000, 2000}, {12000, 7000}, {5000, 6500}};
    private static final double TOUCH = 800;

    @Test
    void theOfficialRecordingsComeOutOfTheSimulatorToo() {
        int rounds = 0;
        PodCommands commands = new PodCommands(4);
        for (Recordings.Recording recording : Recordings.all()) {
            PodRaceSimulator race = new PodRaceSimulator(recording.checkpoints());
            for (Recordings.Round round : recording.rounds()) {
                for (int pod = 0; pod < 4; pod++) {
                    Recordings.Command command = round.commands()[pod];
                    commands.set(pod, command.x(), command.y(), command.thrust());
                }
                race.play(commands);
                rounds++;
                for (int pod = 0; pod < 4; pod++) {
                    double[] after = round.after()[pod];
                    assertEquals(List.of(after[0], after[1], after[2], after[3]),
                        List.of(race.x(pod), race.y(pod), race.vx(pod), race.vy(pod)), recording.name());
                }
            }
        }
        assertTrue(rounds > 0, "the folder holds games");
    }

    /**
     * A pod at rest that thrusts in a direction whose exact speed or place is a whole number or a half: 3-4-5 triangles
     * and the axes, thrusts by which 0.85 v and x + v fall on the very boundary. There the last bits of sine and cosine
     * decide: the direction without angles, the same but for these bits, ends elsewhere in some of the cases. Two pods
     * head elsewhere before, by less than 18 degrees, so that they are steered by vectors; two have no heading.
     */
    @Test
    void boundariesOfRoundingAreTheGames() {
        double[][] directions = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {3, 4}, {-4, 3}, {5, -12},
            {-8, -15}, {7, 24}, {20, 21}};
        PodRaceSimulator fast = new PodRaceSimulator(MAP);
        TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
        PodCommands commands = new PodCommands(4);
        int cases = 0;
        int decidedByLastBits = 0;
        for (double[] direction : directions) {
            double length = Math.sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
            for (int thrust = 0; thrust <= 200; thrust++) {
                for (double half = 0; half <= 0.5; half += 0.5) {
                    for (int pod = 0; pod < 4; pod++) {
                        double x = 20000 * pod + half;
                        double vx = pod == 0 ? 0 : Math.rint(100 * direction[0] / length) * pod;
                        double vy = pod == 0 ? 0 : Math.rint(100 * direction[1] / length) * pod;
                        double heading = pod < 2 ? Math.atan2(direction[1], direction[0]) + 0.2 : Double.NaN;
                        put(fast, textbook, pod, x, 30000, vx, vy, heading);
                        commands.set(pod, x + 1000 * direction[0], 30000 + 1000 * direction[1], thrust);
                    }
                    cases += playAndCompare(fast, textbook, commands);
                    double vx = direction[0] / length * thrust;
                    decidedByLastBits += Math.floor(half + vx + 0.5) != fast.x(0)
                        || (int) (vx * (1 - 0.15)) != fast.vx(0) ? 1 : 0;
                }
            }
        }
        assertEquals(10 * 201 * 2, cases);
        assertTrue(decidedByLastBits > 20, decidedByLastBits + " cases on a boundary");
    }

    /**
     * In a turn with an impact the game flies everybody in two legs, and the sum of two rounded legs falls to the other
     * side of a half now and then: also for a pod far away from the impact.
     */
    @Test
    void whoIsNotTouchedIsFlownInLegsToo() {
        PodRaceSimulator fast = new PodRaceSimulator(MAP);
        TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
        PodCommands commands = new PodCommands(4);
        SplitMix64 random = new SplitMix64(13);
        for (int trial = 0; trial < 20_000; trial++) {
            put(fast, textbook, 0, 3000, 5000 + random.nextInt(-300, 300), 400, 0, Double.NaN);
            put(fast, textbook, 1, 4200, 5000 + random.nextInt(-300, 300), -400, 0, Double.NaN);
            for (int pod = 2; pod < 4; pod++) {
                double heading = Math.PI / 6 * random.nextInt(0, 11) - Math.PI / 10;
                put(fast, textbook, pod, 12000, 5000 * (pod - 2) + random.nextInt(0, 99), random.nextInt(-400, 400),
                    random.nextInt(-400, 400), heading);
                commands.set(pod, 12000 + 9000 * Math.cos(heading + 1), 9000 * Math.sin(heading + 1) + 5000 * (pod - 2),
                    2 * random.nextInt(1, 99) + 1);
            }
            playAndCompare(fast, textbook, commands);
        }
    }

    private static void put(PodRaceSimulator fast, TextbookPodRace textbook, int k, double x, double y, double vx,
                            double vy, double heading) {
        PodState state = new PodState(x, y, vx, vy, heading, 0, true, 0);
        Races.put(fast, k, state);
        Races.put(textbook, k, state);
    }

    private static int playAndCompare(PodRaceSimulator fast, TextbookPodRace textbook, PodCommands commands) {
        fast.play(commands);
        textbook.play(commands.targetX, commands.targetY, commands.thrust);
        for (int k = 0; k < 4; k++) {
            PodState expected = Races.state(textbook, k);
            assertEquals(List.of(expected.x(), expected.y(), expected.vx(), expected.vy(), expected.heading()),
                List.of(fast.x(k), fast.y(k), fast.vx(k), fast.vy(k), fast.heading(k)));
        }
        return 1;
    }

    /** At 18 degrees and at 180, one part in 10^k to either side. */
    @Test
    void boundariesOfTurningAreTheGames() {
        PodRaceSimulator fast = new PodRaceSimulator(MAP);
        TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
        PodCommands commands = new PodCommands(4);
        SplitMix64 random = new SplitMix64(9);
        for (int exponent = 1; exponent <= 16; exponent++) {
            for (int trial = 0; trial < 100; trial++) {
                for (int pod = 0; pod < 4; pod++) {
                    double heading = (random.nextDouble() - 0.5) * 20;
                    double turn = (pod < 2 ? Math.PI / 10 : Math.PI) * (pod % 2 == 0 ? 1 : -1)
                        * (1 + random.nextInt(-1, 1) * Math.pow(10, -exponent));
                    put(fast, textbook, pod, 20000 * pod, 0, 300, -200, heading);
                    commands.set(pod, 20000 * pod + 5e6 * Math.cos(heading + turn),
                        5e6 * Math.sin(heading + turn), 150);
                }
                playAndCompare(fast, textbook, commands);
            }
        }
    }

    /** 400 turns to one side without ever asking for an angle, then the angle: 10 chains of 40 turns and more. */
    @Test
    void longChainsOfTurnsKeepEveryBit() {
        PodRaceSimulator fast = new PodRaceSimulator(MAP);
        TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
        PodCommands commands = new PodCommands(4);
        for (int pod = 0; pod < 4; pod++) {
            put(fast, textbook, pod, 20000 * pod, 0, 0, 0, pod == 3 ? 511 : 0.1 * pod);
        }
        for (int turn = 0; turn < 400; turn++) {
            for (int pod = 0; pod < 4; pod++) {
                double side = pod == 1 ? -2 : 2;
                double angle = textbook.pod(pod).heading + side;
                commands.set(pod, fast.x(pod) + 1e4 * Math.cos(angle), fast.y(pod) + 1e4 * Math.sin(angle), 100);
            }
            fast.play(commands);
            textbook.play(commands.targetX, commands.targetY, commands.thrust);
        }
        for (int pod = 0; pod < 4; pod++) {
            assertEquals(textbook.pod(pod).heading, fast.heading(pod));
            assertEquals(textbook.pod(pod).x, fast.x(pod));
            assertTrue(Math.abs(fast.heading(pod)) > 100, "it went round");
        }
    }

    /** Whoever the filter sets aside has no impact by the official expressions; and it sets most aside. */
    @Test
    void theFilterNeverHidesAnImpact() {
        SplitMix64 random = new SplitMix64(21);
        int hidden = 0;
        int asideOfFar = 0;
        for (int k = 0; k < 300_000; k++) {
            double scale = Math.scalb(1.0, random.nextInt(-3, 30));
            double wx = (random.nextDouble() - 0.5) * 4000;
            double wy = (random.nextDouble() - 0.5) * 4000;
            double dx = (random.nextDouble() - 0.5) * 1600 * scale;
            double dy = (random.nextDouble() - 0.5) * 1600 * scale;
            if (k % 2 == 0) {                          // grazing, or touching at the end of the turn
                double length = Math.sqrt(wx * wx + wy * wy);
                double beside = (k % 4 == 0 ? TOUCH : TOUCH * random.nextDouble()) * (1 + random.nextInt(-4, 4) * 1e-7);
                double ahead = length * (1 + random.nextInt(-2, 2) * 1e-6) + Math.sqrt(Math.max(0, TOUCH * TOUCH
                    - beside * beside));
                dx = -wx / length * ahead - wy / length * beside;
                dy = -wy / length * ahead + wx / length * beside;
            }
            boolean aside = !FarPairs.mayMeet(dx, dy, wx, wy, 1, TOUCH * TOUCH);
            hidden += aside && meets(dx, dy, wx, wy) ? 1 : 0;
            asideOfFar += aside ? 1 : 0;
        }
        assertEquals(0, hidden);
        assertTrue(asideOfFar > 100_000);
    }

    static boolean meets(double dx, double dy, double wx, double wy) {
        if (Math.sqrt(dx * dx + dy * dy) <= TOUCH) {
            return true;
        }
        double a = wx * wx + wy * wy;
        double b = dx * wx + dy * wy;
        double c = dx * dx + dy * dy - TOUCH * TOUCH;
        double discriminant = b * b - a * c;
        double root = Math.min((-b + Math.sqrt(discriminant)) / a, (-b - Math.sqrt(discriminant)) / a);
        return discriminant > 0 && a != 0 && root > 0 && root <= 1;
    }

    @Test
    void aTurnAllocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        RandomTurns random = new RandomTurns(4);
        PodRaceSimulator start = new PodRaceSimulator(MAP);
        PodRaceSimulator race = new PodRaceSimulator(MAP);
        for (boolean recorded : new boolean[] {false, true}) {
            race.setRecorded(recorded);
            long allocated = Long.MAX_VALUE;
            for (int count = 0; count < 20 && allocated > 0; count++) {
                allocated = 0;
                for (int turn = 0; turn < 100; turn++) {
                    placeBrawl(start, turn);
                    random.commands(new double[4], new double[4], new double[4]);
                    long before = threads.getCurrentThreadAllocatedBytes();
                    race.copyFrom(start);
                    for (int k = 0; k < 10; k++) {
                        race.play(random.commands);
                    }
                    allocated += threads.getCurrentThreadAllocatedBytes() - before;
                }
            }
            assertEquals(0, allocated, "bytes in 1,000 turns, recorded: " + recorded);
        }
    }

    private static void placeBrawl(PodRaceSimulator race, int turn) {
        for (int pod = 0; pod < 4; pod++) {
            race.setPod(pod, 4000 + 700 * pod, 4000 + 10 * turn * (pod % 2), 300 - 200 * pod, turn, 0.3 * turn, 0,
                true, 0);
        }
    }

    @Test
    void theSameMapAndPodsAreAskedFor() {
        PodRaceSimulator race = new PodRaceSimulator(MAP);
        assertRefused("a race of 2 pods", () -> race.copyFrom(new PodRaceSimulator(MAP, 2, 1, 3)));
        assertRefused("with 2 checkpoints", () -> race.copyFrom(new PodRaceSimulator(new double[][] {{0, 0}, {1, 2}})));
        assertRefused("commands for 2 pods, expected 4", () -> race.play(new PodCommands(2)));
        assertRefused("commands for 2 pods, expected 4", () -> new PodCommands(4).copyFrom(new PodCommands(2)));
    }

    @Test
    void racesThatCannotBeAreRefused() {
        assertRefused("4 players with 3 pods", () -> new PodRaceSimulator(MAP, 4, 3, 3));
        assertRefused("65536 players with 65536 pods", () -> new PodRaceSimulator(MAP, 1 << 16, 1 << 16, 3));
        assertRefused("0 players", () -> new PodRaceSimulator(MAP, 0, 1, 3));
        assertRefused("0 laps", () -> new PodRaceSimulator(MAP, 2, 2, 0));
        assertRefused("1 checkpoints", () -> new PodRaceSimulator(new double[][] {{1, 2}}));
        assertRefused("checkpoint 1: [NaN, 3.0]", () -> new PodRaceSimulator(new double[][] {{1, 2}, {Double.NaN, 3}}));
        assertRefused("checkpoint 0: [1.0]", () -> new PodRaceSimulator(new double[][] {{1}, {2, 3}}));
        assertRefused("in the same place", () -> new PodRaceSimulator(new double[][] {{1, 2}, {1, 2}}));
    }

    @Test
    void statesAndCommandsThatCannotBeAreRefused() {
        PodRaceSimulator race = new PodRaceSimulator(MAP);
        double x = race.x(0);
        assertRefused("place NaN", () -> race.setPod(0, Double.NaN, 0, 0, 0, 0, 0, true, 0));
        assertRefused("speed 0.0 1.0E61", () -> race.setPod(0, 0, 0, 0, 1e61, 0, 0, true, 0));
        assertRefused("heading Infinity", () -> race.setPod(0, 0, 0, 0, 0, Double.POSITIVE_INFINITY, 0, true, 0));
        assertRefused("shield timer 5", () -> race.setPod(0, 0, 0, 0, 0, 0, 5, true, 0));
        assertRefused("passed 2147483647", () -> race.setPod(0, 0, 0, 0, 0, 0, 0, true, Integer.MAX_VALUE));
        assertThrows(IndexOutOfBoundsException.class, () -> race.setPod(4, 0, 0, 0, 0, 0, 0, true, 0));
        assertThrows(IndexOutOfBoundsException.class, () -> race.setTurnsLeft(-1, 7));
        assertEquals(x, race.x(0), "nothing of a refused state is kept");
        assertEquals(3, race.nextCheckpoint(3) + 2, "nor written elsewhere");

        PodCommands commands = new PodCommands(4);
        assertRefused("pod 1: thrust 651", () -> commands.set(1, 0, 0, 651));
        assertRefused("pod 1: thrust -4", () -> commands.set(1, 0, 0, -4));
        assertRefused("target 0.0 Infinity", () -> commands.set(1, 0, Double.POSITIVE_INFINITY, 1));
        assertRefused("0 pods", () -> new PodCommands(0));
    }

    private static void assertRefused(String said, Executable call) {
        String message = assertThrows(IllegalArgumentException.class, call).getMessage();
        assertTrue(message.contains(said), message);
    }

    /** Who measures a scene sees, and can replace, the fast loop too. */
    @Test
    void theObserverOfTheOfficialSceneIsAsked() {
        PodRaceType.PodRaceSetup official = Races.setup("mad-pod-racing");
        PodRaceType.PodRaceSetup still = new PodRaceType().open(
            SceneReader.read(SceneFiles.load("mad-pod-racing").text(), "watched")
                .withObserver((parts, advance) -> (bodies, sink) -> { }));
        PodRace race = still.create(MAP);
        race.setPod(0, new PodState(0, 0, 100, 0, 0, 0, true, 0));
        race.play();

        assertEquals(0, race.pod(0).x(), "nobody flew");
        assertTrue(official.create(MAP).advance() instanceof OfficialAdvance);
    }
}
