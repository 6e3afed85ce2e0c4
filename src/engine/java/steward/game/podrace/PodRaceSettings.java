package steward.game.podrace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import steward.numerics.SplitMix64;
import steward.scene.Scene;
import steward.scene.json.Block;

/**
 * Settings of a pod race: the blocks {@code pods} and {@code race} of a scene.
 *
 * @param siteCommands           whether lines of commands are read as the site reads them; otherwise leniently
 * @param players                how many players, 1..16
 * @param podsPerPlayer          1..8
 * @param radius                 of a pod, in u
 * @param mass                   of a pod without a raised shield, in pod masses
 * @param restitution            of a pod, 0..1
 * @param maximumThrust          of an ordinary command, and of a boost that is used up; in u per turn^2
 * @param laps                   1..100
 * @param checkpointRadius       in u
 * @param maps                   one of these is drawn at random: checkpoints {@code [n][x, y]}, n at least 2
 * @param shift                  whether the order of checkpoints starts at a random one
 * @param jitter                 each coordinate is moved by a whole number drawn from -jitter..jitter
 * @param turnsWithoutCheckpoint a player none of whose pods passes a checkpoint for this many turns, and by live rules
 *                               one more, is eliminated
 * @param maximumTurns           the race ends after this many turns
 */
public record PodRaceSettings(RulesEdition rules, boolean siteCommands, int players, int podsPerPlayer, double radius,
                              double mass, double restitution, int maximumThrust, int laps, double checkpointRadius,
                              List<double[][]> maps, boolean shift, int jitter, int turnsWithoutCheckpoint,
                              int maximumTurns) {

    /** The official greatest ordinary thrust, in u per turn^2; a scene may set another. */
    private static final int OFFICIAL_THRUST = 200;
    public static final int BOOST_THRUST = 650;
    /** A raised shield multiplies the mass by this for its turn. */
    public static final int SHIELD_MASS_FACTOR = 10;
    /** The shield's timer on the turn it is raised: no thrust on this and the next three. */
    public static final int SHIELD_TURNS = 4;

    private static final Map<String, RulesEdition> RULES = Arrays.stream(RulesEdition.values())
        .collect(Collectors.toMap(RulesEdition::word, edition -> edition));
    private static final int MAXIMUM_CHECKPOINTS = 64;
    private static final double MAXIMUM_COORDINATE = 1e6;

    public int pods() {
        return players * podsPerPlayer;
    }

    /** Draws in this order: the map; if the scene shifts, the first checkpoint; if it jitters, each x, then y. */
    double[][] drawMap(SplitMix64 random) {
        double[][] map = maps.get(random.nextInt(maps.size()));
        int first = shift ? random.nextInt(map.length) : 0;
        double[][] drawn = new double[map.length][];
        for (int k = 0; k < drawn.length; k++) {
            drawn[k] = map[(first + k) % map.length].clone();
            if (jitter > 0) {
                drawn[k][0] += random.nextInt(-jitter, jitter);
                drawn[k][1] += random.nextInt(-jitter, jitter);
            }
        }
        return drawn;
    }

    /** Reads the blocks {@code pods} and {@code race}. */
    public static PodRaceSettings read(Scene scene) {
        Block pods = scene.root().block("pods");
        int perPlayer = pods.integer("perPlayer", 1, 8);
        double radius = pods.positive("radius");
        double mass = pods.positive("mass");
        double restitution = pods.number("restitution", 0, 1, 1);
        int maximumThrust = pods.integer("maximumThrust", 1, BOOST_THRUST, OFFICIAL_THRUST);
        pods.done();
        Block race = scene.root().block("race");
        RulesEdition rules = race.choice("rules", RULES, RulesEdition.CONTEST);
        boolean siteCommands = race.choice("commands", Map.of("site", true, "lenient", false), false);
        int laps = race.integer("laps", 1, 100);
        double checkpointRadius = race.positive("checkpointRadius");
        List<double[][]> maps = readMaps(race);
        boolean shift = race.flag("shift", false);
        int jitter = race.integer("jitter", 0, 1000, 0);
        int turnsWithoutCheckpoint = race.integer("turnsWithoutCheckpoint", 1, 1_000_000);
        int maximumTurns = race.integer("maximumTurns", 1, 1_000_000);
        race.done();
        return new PodRaceSettings(rules, siteCommands, scene.players(), perPlayer, radius, mass, restitution,
            maximumThrust, laps, checkpointRadius, maps, shift, jitter, turnsWithoutCheckpoint, maximumTurns);
    }

    private static List<double[][]> readMaps(Block race) {
        if (race.isText("maps")) {
            race.choice("maps", Map.of("official", true));
            return OfficialMaps.all();
        }
        List<double[][]> maps = new ArrayList<>();
        for (Block map : race.blocks("maps")) {
            List<Block> points = map.blocks("checkpoints");
            if (points.size() < 2 || points.size() > MAXIMUM_CHECKPOINTS) {
                throw map.error("checkpoints", points.size() + " checkpoints", "2.." + MAXIMUM_CHECKPOINTS);
            }
            double[][] checkpoints = new double[points.size()][];
            for (int k = 0; k < checkpoints.length; k++) {
                Block point = points.get(k);
                checkpoints[k] = new double[] {
                    point.number("x", -MAXIMUM_COORDINATE, MAXIMUM_COORDINATE),
                    point.number("y", -MAXIMUM_COORDINATE, MAXIMUM_COORDINATE)};
                point.done();
            }
            if (checkpoints[0][0] == checkpoints[1][0] && checkpoints[0][1] == checkpoints[1][1]) {
                throw map.error("checkpoints", "the first two in the same place", "two places: pods start across them");
            }
            map.done();
            maps.add(checkpoints);
        }
        if (maps.isEmpty()) {
            throw race.error("maps", "no map", "\"official\" or at least one map");
        }
        return maps;
    }
}
