package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.match.Refusal.refusedFor;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.Allocated;
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

    private final PodRaceSimulator fast = new PodRaceSimulator(MAP);
    private final TextbookPodRace textbook = new TextbookPodRace(MAP, 4);
    private final PodCommands commands = new PodCommands(4);

    @Test
    void theOfficialRecordingsComeOutOfTheSimulatorToo() {
        int rounds = 0;
        for (Recordings.Recording recording : Recordings.all()) {
            PodRaceSimulator race = new PodRaceSimulator(recording.checkpoints());
            for (Recordings.Round round : recording.rounds()) {
                race.play(Recordings.commands(round.commands()));
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
                        put(pod, x, 30000, vx, vy, heading);
                        commands.set(pod, x + 1000 * direction[0], 30000 + 1000 * direction[1], thrust);
                    }
                    cases += playAndCompare();
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
        SplitMix64 random = new SplitMix64(13);
        for (int trial = 0; trial < 20_000; trial++) {
            put(0, 3000, 5000 + random.nextInt(-300, 300), 400, 0, Double.NaN);
            put(1, 4200, 5000 + random.nextInt(-300, 300), -400, 0, Double.NaN);
            for (int pod = 2; pod < 4; pod++) {
                double heading = Math.PI / 6 * random.nextInt(0, 11) - Math.PI / 10;
                put(pod, 12000, 5000 * (pod - 2) + random.nextInt(0, 99), random.nextInt(-400, 400),
                    random.nextInt(-400, 400), heading);
                commands.set(pod, 12000 + 9000 * Math.cos(heading + 1), 9000 * Math.sin(heading + 1) + 5000 * (pod - 2),
                    2 * random.nextInt(1, 99) + 1);
            }
            playAndCompare();
        }
    }

    private void put(int k, double x, double y, double vx, double vy, double heading) {
        PodState state = new PodState(x, y, vx, vy, heading, 0, true, 0);
        Races.put(fast, k, state);
        Races.put(textbook, k, state);
    }

    private int playAndCompare() {
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
        SplitMix64 random = new SplitMix64(9);
        for (int exponent = 1; exponent <= 16; exponent++) {
            for (int trial = 0; trial < 100; trial++) {
                for (int pod = 0; pod < 4; pod++) {
                    double heading = (random.nextDouble() - 0.5) * 20;
                    double turn = (pod < 2 ? Math.PI / 10 : Math.PI) * (pod % 2 == 0 ? 1 : -1)
                        * (1 + random.nextInt(-1, 1) * Math.pow(10, -exponent));
                    put(pod, 20000 * pod, 0, 300, -200, heading);
                    commands.set(pod, 20000 * pod + 5e6 * Math.cos(heading + turn),
                        5e6 * Math.sin(heading + turn), 150);
                }
                playAndCompare();
            }
        }
    }

    /** 400 turns to one side without ever asking for an angle, then the angle: 10 chains of 40 turns and more. */
    @Test
    void longChainsOfTurnsKeepEveryBit() {
        for (int pod = 0; pod < 4; pod++) {
            put(pod, 20000 * pod, 0, 0, 0, pod == 3 ? 511 : 0.1 * pod);
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
        RandomTurns random = new RandomTurns(4);
        PodRaceSimulator race = new PodRaceSimulator(MAP);
        for (boolean recorded : new boolean[] {false, true}) {
            race.setRecorded(recorded);
            Allocated.assertNone(20, "1,000 turns, recorded: " + recorded, () -> {
                long allocated = 0;
                for (int turn = 0; turn < 100; turn++) {
                    placeBrawl(fast, turn);
                    random.commands(new double[4], new double[4], new double[4]);
                    allocated += Allocated.by(() -> {
                        race.copyFrom(fast);
                        for (int k = 0; k < 10; k++) {
                            race.play(random.commands);
                        }
                    });
                }
                return allocated;
            });
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
        refusedFor("a race of 2 pods", () -> fast.copyFrom(new PodRaceSimulator(MAP, 2, 1, 3)));
        refusedFor("with 2 checkpoints", () -> fast.copyFrom(new PodRaceSimulator(new double[][] {{0, 0}, {1, 2}})));
        refusedFor("commands for 2 pods, expected 4", () -> fast.play(new PodCommands(2)));
        refusedFor("commands for 2 pods, expected 4", () -> new PodCommands(4).copyFrom(new PodCommands(2)));
    }

    @Test
    void racesThatCannotBeAreRefused() {
        refusedFor("4 players with 3 pods", () -> new PodRaceSimulator(MAP, 4, 3, 3));
        refusedFor("65536 players with 65536 pods", () -> new PodRaceSimulator(MAP, 1 << 16, 1 << 16, 3));
        refusedFor("0 players", () -> new PodRaceSimulator(MAP, 0, 1, 3));
        refusedFor("0 laps", () -> new PodRaceSimulator(MAP, 2, 2, 0));
        refusedFor("1 checkpoints", () -> new PodRaceSimulator(new double[][] {{1, 2}}));
        refusedFor("checkpoint 1: [NaN, 3.0]", () -> new PodRaceSimulator(new double[][] {{1, 2}, {Double.NaN, 3}}));
        refusedFor("checkpoint 0: [1.0]", () -> new PodRaceSimulator(new double[][] {{1}, {2, 3}}));
        refusedFor("in the same place", () -> new PodRaceSimulator(new double[][] {{1, 2}, {1, 2}}));
    }

    @Test
    void statesAndCommandsThatCannotBeAreRefused() {
        double x = fast.x(0);
        refusedFor("place NaN", () -> fast.setPod(0, Double.NaN, 0, 0, 0, 0, 0, true, 0));
        refusedFor("speed 0.0 1.0E61", () -> fast.setPod(0, 0, 0, 0, 1e61, 0, 0, true, 0));
        refusedFor("heading Infinity", () -> fast.setPod(0, 0, 0, 0, 0, Double.POSITIVE_INFINITY, 0, true, 0));
        refusedFor("shield timer 5", () -> fast.setPod(0, 0, 0, 0, 0, 0, 5, true, 0));
        refusedFor("passed 2147483647", () -> fast.setPod(0, 0, 0, 0, 0, 0, 0, true, Integer.MAX_VALUE));
        assertThrows(IndexOutOfBoundsException.class, () -> fast.setPod(4, 0, 0, 0, 0, 0, 0, true, 0));
        assertThrows(IndexOutOfBoundsException.class, () -> fast.setTurnsLeft(-1, 7));
        assertEquals(x, fast.x(0), "nothing of a refused state is kept");
        assertEquals(3, fast.nextCheckpoint(3) + 2, "nor written elsewhere");

        refusedFor("pod 1: thrust 651", () -> commands.set(1, 0, 0, 651));
        refusedFor("pod 1: thrust -4", () -> commands.set(1, 0, 0, -4));
        refusedFor("target 0.0 Infinity", () -> commands.set(1, 0, Double.POSITIVE_INFINITY, 1));
        refusedFor("0 pods", () -> new PodCommands(0));
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
