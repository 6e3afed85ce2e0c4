package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.GroundTruth;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.game.podrace.RulesEdition;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;

/**
 * The header for bots in C++ against the engine of matches and the simulator, bit for bit, by g++ and clang++. The
 * number of turns of each kind is 4,000, in campaigns 20,000, or that of {@code -Psteward.turns}: {@code gradle test
 * --tests '*CppHeaderTest' -Psteward.turns=1000000}; {@code -Psteward.seed} draws others.
 */
@Tag("process")
class CppHeaderTest {

    private static final long SEED = Long.getLong("steward.seed", 38);
    private static final int PODS = 4;
    private static final int LEFT = 100;
    private static final int MAP_GAMES = 50;
    /** Maps of the edges, whose checkpoints lie on each other, at the end of a range, on an axis. */
    private static final double[][] EDGE_MAP = {{3000, 3000}, {0, 0}, {32768, 700}, {0, 0}, {8000, 0}};
    private static final double[] DEGREES = {18, -18, 18.5, -90, 1e9, 0, -0.0, 9, -9, 17.999, Math.nextDown(18.0),
        1e-60};

    private final RandomTurns random = new RandomTurns(SEED);
    private final SplitMix64 choice = new SplitMix64(SEED);
    private final long wanted = Long.getLong("steward.turns", isCampaign() ? 20_000 : 1_500);
    private CppHeader header;

    @BeforeEach
    void start(TestReporter report) {
        header = new CppHeader(report, isCampaign());
    }

    boolean isCampaign() {
        return false;
    }

    @AfterEach
    void end() {
        header.close();
    }

    private static PodState[] pods(PodRace race) {
        return IntStream.range(0, PODS).mapToObj(race::pod).toArray(PodState[]::new);
    }

    private static boolean fits(PodState[] pods) {
        return Arrays.stream(pods).allMatch(pod -> CppHeader.fits(pod.x(), pod.y(), pod.vx(), pod.vy())
            && (pod.heading() == 0 || !(Math.abs(pod.heading()) < 0x1p-300)));
    }

    private void play(PodRace race, PodCommands commands, int checkpoints) {
        Races.give(race, commands);
        race.play();
        boolean all = race.isIn(0) && race.isIn(1);
        header.turn(commands, pods(race), checkpoints, new int[] {race.isIn(0) ? race.turnsLeft(0)
            : CppHeader.NOT_COMPARED, race.isIn(1) ? race.turnsLeft(1) : CppHeader.NOT_COMPARED},
            all ? race.turn() : -1, race.hash());
    }

    /** Turns of every sort by both editions of the rules, and the hashes of replays. */
    @Test
    void everyBitIsThatOfTheEngine() throws IOException, InterruptedException {
        double[][] map = null;
        PodRaceType.PodRaceSetup setup = null;
        long turns = 0;
        for (long game = 0; turns < wanted; game++) {
            if (game % MAP_GAMES == 0) {
                map = random.map();
                setup = game % (2 * MAP_GAMES) == 0 ? Recordings.official() : Recordings.contest();
                header.map(map, game % (2 * MAP_GAMES) == 0 ? RulesEdition.LIVE : RulesEdition.CONTEST);
            }
            PodRace race = setup.create(map);
            random.state();
            random.put(race);
            if (!fits(pods(race))) {
                continue;
            }
            header.state(pods(race), LEFT, LEFT);
            for (int turn = random.turns(); turn > 0 && !race.isOver() && fits(pods(race)); turn--, turns++) {
                PodState[] now = pods(race);
                random.commands(Arrays.stream(now).mapToDouble(PodState::x).toArray(),
                    Arrays.stream(now).mapToDouble(PodState::y).toArray(),
                    Arrays.stream(now).mapToDouble(PodState::heading).toArray());
                play(race, random.commands, map.length);
            }
        }
        header.assertNothingDiffers();
    }

    /** Numbers at which something changes its way. */
    @Test
    void everyBitAtTheEdgesIsThatOfTheEngine() throws IOException, InterruptedException {
        EdgeTurns edges = new EdgeTurns(SEED, PODS);
        header.map(EDGE_MAP, RulesEdition.LIVE);
        long turns = 0;
        while (turns < wanted) {
            PodRace race = Recordings.official().create(EDGE_MAP);
            edges.state();
            for (int pod = 0; pod < PODS; pod++) {
                race.setPod(pod, new PodState(edges.x[pod], edges.y[pod], edges.vx[pod], edges.vy[pod],
                    edges.heading[pod], edges.timer[pod], true, 0));
            }
            if (!fits(pods(race))) {
                continue;
            }
            header.state(pods(race), LEFT, LEFT);
            for (int turn = edges.turns(); turn > 0 && !race.isOver() && fits(pods(race)); turn--, turns++) {
                edges.draw(race);
                if (!CppHeader.fits(edges.commands)) {
                    break;
                }
                play(race, edges.commands, EDGE_MAP.length);
            }
        }
        header.assertNothingDiffers();
    }

    /** Pods that leave the circle of a checkpoint, from where the last bit of a root decides, or rest there. */
    @Test
    void everyBitAtACheckpointIsThatOfTheEngine() throws IOException, InterruptedException {
        for (RulesEdition rules : RulesEdition.values()) {
            header.map(EDGE_MAP, rules);
            for (long turn = 0; turn < wanted; turn++) {
                PodRace race = (rules == RulesEdition.LIVE ? Recordings.official() : Recordings.contest())
                    .create(EDGE_MAP);
                for (int pod = 0; pod < PODS; pod++) {
                    double angle = choice.nextDouble() * 2 * Math.PI;
                    double cos = StrictMath.cos(angle);
                    double sin = StrictMath.sin(angle);
                    int speed = 100 * choice.nextInt(3);
                    double[] next = EDGE_MAP[1 + pod];
                    race.setPod(pod, new PodState(next[0] + 600 * cos, next[1] + 600 * sin, speed * cos, speed * sin,
                        angle, 0, true, pod));
                }
                header.state(pods(race), LEFT, LEFT);
                play(race, new PodCommands(PODS), EDGE_MAP.length);
            }
        }
        header.assertNothingDiffers();
    }

    /** Commands by an angle, some pods by target, as the simulator plays them. */
    @Test
    void everyTurnByAnAngleIsThatOfTheSimulator() throws IOException, InterruptedException {
        double[][] map = random.map();
        header.map(map, RulesEdition.CONTEST);
        PodRaceSimulator race = new PodRaceSimulator(map, 2, 2, 3, RulesEdition.CONTEST);
        long turns = 0;
        while (turns < wanted) {
            random.state();
            random.put(race);
            if (!fits(race)) {
                continue;
            }
            race.setTurnsLeft(0, LEFT);
            header.state(race);
            for (int turn = random.turns(); turn > 0 && fits(race); turn--, turns++) {
                random.commands(RandomTurns.numbers(race::x), RandomTurns.numbers(race::y),
                    RandomTurns.numbers(race::heading));
                for (int pod = 0; pod < PODS; pod++) {
                    if (choice.nextInt(3) != 0) {
                        double degrees = choice.nextInt(4) == 0 ? choice.nextDouble() * 40 - 20
                            : DEGREES[choice.nextInt(DEGREES.length)];
                        random.commands.turn(pod, degrees, random.commands.thrust(pod));
                    }
                }
                race.play(random.commands);
                header.turn(random.commands, race, map.length);
            }
        }
        header.assertNothingDiffers();
    }

    private static boolean fits(PodRaceSimulator race) {
        return IntStream.range(0, PODS).allMatch(pod -> CppHeader.fits(race.x(pod), race.y(pod), race.vx(pod),
            race.vy(pod)));
    }

    /** The whole games of 2016. */
    @Test
    void everyTurnOfTheRecordedGamesIsThatOfTheServer() throws IOException, InterruptedException {
        for (Recordings.Recording recording : Recordings.all()) {
            double[][] map = recording.checkpoints();
            header.map(map, RulesEdition.LIVE);
            PodRaceSimulator race = new PodRaceSimulator(map);
            for (Recordings.Round round : recording.rounds()) {
                PodCommands commands = Recordings.commands(round.commands());
                race.play(commands);
                PodState[] after = IntStream.range(0, PODS).mapToObj(pod -> new PodState(round.after()[pod][0],
                    round.after()[pod][1], round.after()[pod][2], round.after()[pod][3], race.heading(pod),
                    race.shieldTimer(pod), race.boostLeft(pod), race.passed(pod))).toArray(PodState[]::new);
                header.turn(commands, after, map.length, new int[] {race.turnsLeft(0), race.turnsLeft(1)}, -1, 0);
            }
        }
        header.assertNothingDiffers();
    }

    /** States and moves of 2025-26 at full precision, lines S and M; timers do not stand there. */
    @Test
    void everyTurnOfTheGamesAtFullPrecisionIsThatOfTheSimulator() throws IOException, InterruptedException {
        int turns = 0;
        for (String name : new String[] {"turns_870230020.txt", "turns_884486784.txt", "turns_885928301.txt",
            "turns_888655750.txt", "turns_selected.txt", "live_edges.txt"}) {
            Path file = GroundTruth.replay(name);
            double[][] map = Races.FAR;
            PodRaceSimulator race = null;
            for (String line : Files.readAllLines(file)) {
                String[] words = line.trim().split(" +");
                if (words[0].equals("CHECKPOINTS") || words[0].equals("P")) {
                    map = Recordings.map(words);
                    race = null;
                } else if (words[0].equals("S")) {
                    race = race(map, words, name.equals("live_edges.txt") ? 1 : 2);
                } else if (words[0].equals("M") && race != null) {
                    header.map(map, RulesEdition.LIVE);
                    header.state(race);
                    PodCommands commands = commands(words);
                    race.play(commands);
                    header.turn(commands, race, map.length);
                    turns++;
                    race = null;
                }
            }
        }
        assertTrue(turns > 50, turns + " turns");
        header.assertNothingDiffers();
    }

    private static PodRaceSimulator race(double[][] map, String[] words, int from) {
        PodRaceSimulator race = new PodRaceSimulator(map);
        for (int pod = 0; pod < PODS; pod++) {
            double[] row = Recordings.rows(words, from)[pod];
            race.setPod(pod, row[0], row[1], row[2], row[3], row[4], row[5] == 1 ? 4 : 0, true,
                (int) (row[6] + map.length - 1) % map.length);
        }
        return race;
    }

    private static PodCommands commands(String[] words) {
        return Recordings.commands(IntStream.range(0, PODS).mapToObj(pod -> Recordings.command(words[1 + 3 * pod],
            words[2 + 3 * pod], words[3 + 3 * pod])).toArray(Recordings.Command[]::new));
    }
}
