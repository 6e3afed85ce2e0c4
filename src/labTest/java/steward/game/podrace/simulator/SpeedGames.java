package steward.game.podrace.simulator;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.game.podrace.protocol.PodRaceType;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;

/**
 * Games of the official pod race whose commands are known beforehand, and all implementations that can play them. Each
 * is checked to end with the pods where the textbook has them.
 */
final class SpeedGames {

    static final int GAMES = 200;
    static final int TURNS = 80;

    private static final int PODS = 4;
    private static final int LAPS = 3;
    private static final int THRUST = 200;
    private static final long SEED = 1;
    private static final int BESIDE = 500;
    /** Turns after which a pod of a brawl changes its target. */
    private static final int TARGET_TURNS = 20;

    private final PodRaceType.PodRaceSetup setup;
    private final double[][] map;
    private final PodRaceSimulator start;
    private final PodCommands[][] commands = new PodCommands[GAMES][TURNS];
    private final double[][][] targetX = new double[GAMES][TURNS][PODS];
    private final double[][][] targetY = new double[GAMES][TURNS][PODS];
    private final int[][][] thrust = new int[GAMES][TURNS][PODS];
    private final long end;

    /** @param brawl whether pods chase each other */
    SpeedGames(PodRaceType.PodRaceSetup setup, boolean brawl) {
        this.setup = setup;
        map = setup.create(SEED).checkpoints();
        start = new PodRaceSimulator(map);
        SplitMix64 random = new SplitMix64(SEED);
        PodRaceSimulator race = new PodRaceSimulator(map);
        for (int game = 0; game < GAMES; game++) {
            race.copyFrom(start);
            for (int turn = 0; turn < TURNS; turn++) {
                commands[game][turn] = new PodCommands(PODS);
                for (int pod = 0; pod < PODS; pod++) {
                    draw(race, game, turn, pod, brawl, random);
                }
                race.play(commands[game][turn]);
            }
        }
        end = playTextbook();
    }

    private void draw(PodRaceSimulator race, int game, int turn, int pod, boolean brawl, SplitMix64 random) {
        int next = race.nextCheckpoint(pod);
        int enemy = (pod + 1 + turn / TARGET_TURNS % (PODS - 1)) % PODS;
        double x = brawl ? race.x(enemy) : race.checkpointX(next) - 3 * race.vx(pod);
        double y = brawl ? race.y(enemy) : race.checkpointY(next) - 3 * race.vy(pod);
        x += random.nextInt(-BESIDE, BESIDE);
        y += random.nextInt(-BESIDE, BESIDE);
        int power = random.nextInt(3) == 0 ? random.nextInt(0, THRUST) : THRUST;
        targetX[game][turn][pod] = x;
        targetY[game][turn][pod] = y;
        thrust[game][turn][pod] = power;
        commands[game][turn].set(pod, x, y, power);
    }

    double[][] map() {
        return map;
    }

    /** By game and turn. */
    PodCommands[][] commands() {
        return commands;
    }

    /** Ways to play all games, each of which returns how many turns it has played; a plain port first. */
    Map<String, LongSupplier> ways() {
        PodRaceSimulator simulator = new PodRaceSimulator(map);
        Map<String, LongSupplier> ways = new LinkedHashMap<>();
        ways.put("textbook", () -> checked(playTextbook()));
        ways.put("engine of matches", () -> checked(playMatches()));
        ways.put("simulator", () -> checked(playSimulator(simulator)));
        return ways;
    }

    private long checked(long found) {
        if (found != end) {
            throw new IllegalStateException("the pods end elsewhere than the textbook's");
        }
        return (long) GAMES * TURNS;
    }

    private long playTextbook() {
        StateHash hash = new StateHash();
        for (int game = 0; game < GAMES; game++) {
            TextbookPodRace race = new TextbookPodRace(map, PODS);
            for (int pod = 0; pod < PODS; pod++) {
                race.pod(pod).x = start.x(pod);
                race.pod(pod).y = start.y(pod);
            }
            for (int turn = 0; turn < TURNS; turn++) {
                race.play(targetX[game][turn], targetY[game][turn], thrust[game][turn]);
            }
            for (int pod = 0; pod < PODS; pod++) {
                hash.add(race.pod(pod).x).add(race.pod(pod).y);
            }
        }
        return hash.value();
    }

    private long playMatches() {
        StateHash hash = new StateHash();
        for (int game = 0; game < GAMES; game++) {
            PodRace race = setup.create(map);
            PodSeat[] seats = {new PodSeat(race, 0), new PodSeat(race, 1)};
            for (int turn = 0; turn < TURNS; turn++) {
                for (int pod = 0; pod < PODS; pod++) {
                    seats[pod / 2].thrust(pod, targetX[game][turn][pod], targetY[game][turn][pod],
                        thrust[game][turn][pod]);
                }
                race.play();
            }
            for (int pod = 0; pod < PODS; pod++) {
                hash.add(race.bodies().x[pod]).add(race.bodies().y[pod]);
            }
        }
        return hash.value();
    }

    private long playSimulator(PodRaceSimulator race) {
        StateHash hash = new StateHash();
        for (int game = 0; game < GAMES; game++) {
            race.copyFrom(start);
            for (int turn = 0; turn < TURNS; turn++) {
                race.play(commands[game][turn]);
            }
            for (int pod = 0; pod < PODS; pod++) {
                hash.add(race.x(pod)).add(race.y(pod));
            }
        }
        return hash.value();
    }
}
