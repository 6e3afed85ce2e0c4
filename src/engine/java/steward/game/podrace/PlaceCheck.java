package steward.game.podrace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.scene.Accuracy;
import steward.scene.Field;
import steward.scene.Scene;
import steward.scene.json.Block;
import steward.scene.json.SceneException;

/** Looks at pods, walls, bumpers and checkpoints of a race against each other; errors are located in the file. */
public final class PlaceCheck {

    /** Rounding of two start places brings them nearer by at most sqrt(2). */
    private static final double ROUNDING = 1.5;
    private static final int MOST_WARNINGS = 10;

    private final Scene scene;
    private final PodRaceSettings settings;

    private PlaceCheck(Scene scene, PodRaceSettings settings) {
        this.scene = scene;
        this.settings = settings;
    }

    /**
     * @return a warning for each checkpoint that is out of reach, at most {@value #MOST_WARNINGS} and one that counts
     *     the others
     * @throws SceneException if pods overlap each other, a wall or a bumper at a start that can be drawn, or start
     *                        outside the field
     */
    public static List<String> of(Scene scene, PodRaceSettings settings) {
        PlaceCheck check = new PlaceCheck(scene, settings);
        Field field = scene.field().orElse(null);
        List<Obstacle> obstacles = new ArrayList<>();
        if (field != null) {
            obstacles.addAll(Obstacle.of(field, !scene.root().block("field").isArray("walls")));
        }
        List<Obstacle> atStart = new ArrayList<>(obstacles);
        if (field != null) {
            atStart.add(Obstacle.edge(field));
        }
        check.starts(atStart);
        return check.checkpoints(obstacles, scene.accuracy().way() == Accuracy.Way.EVENT ? field : null);
    }

    private void starts(List<Obstacle> obstacles) {
        double most = (StartPlaces.START_SPACING + ROUNDING) / 2;
        if (settings.pods() > 1 && settings.radius() > most) {
            Block pods = scene.root().block("pods");
            throw pods.error("radius", pods.shown("radius"), "at most " + number(StartPlaces.START_SPACING / 2)
                + ": pods start " + number(StartPlaces.START_SPACING) + " u apart");
        }
        StartOverlap overlap = StartOverlap.find(settings, obstacles);
        if (overlap != null) {
            throw at(overlap.map(), overlap.first(), problem(overlap), overlap.obstacle() == null
                ? "two places at every draw: pods start across them" : room());
        }
    }

    private String problem(StartOverlap overlap) {
        String across = overlap.first() == 0 ? "" : " (shifted: races may start here)";
        String draw = settings.jitter() == 0 ? "" : ", with jitter that puts it at " + place(overlap.drawn()[0])
            + " and the next one at " + place(overlap.drawn()[1]);
        if (overlap.obstacle() == null) {
            return "a checkpoint in one place with the next one" + (settings.jitter() == 0 ? "" : " at some jitter")
                + across;
        }
        String depth = String.format(Locale.ROOT, "%.1f", overlap.depth());
        boolean edge = overlap.obstacle().wall() == null && !overlap.obstacle().name().startsWith("field.");
        return "pod " + overlap.pod() + " at its start " + depth + " u " + (edge ? "outside " : "deep in ")
            + overlap.obstacle().name() + draw + across;
    }

    private String room() {
        double farthest = Math.abs(StartPlaces.side(settings.pods() - 1, settings.pods()));
        return "room for " + settings.pods() + " pods of radius " + number(settings.radius()) + " in a line across "
            + "this checkpoint, up to " + number(farthest) + " u from it";
    }

    private List<String> checkpoints(List<Obstacle> obstacles, Field field) {
        CheckpointReach reach = new CheckpointReach(settings, obstacles, field);
        List<String> warnings = new ArrayList<>();
        int more = 0;
        for (int map = 0; map < settings.maps().size(); map++) {
            double[][] checkpoints = settings.maps().get(map);
            int[] shutOut = reach.shutOut(checkpoints);
            for (int k = 0; k < checkpoints.length; k++) {
                String barrier = reach.barrier(checkpoints[k][0], checkpoints[k][1]);
                boolean warned = barrier != null || shutOut[k] >= 0;
                if (warned && warnings.size() < MOST_WARNINGS) {
                    warnings.add((barrier != null ? covered(map, k, barrier) : shutIn(map, k, shutOut[k]))
                        .getMessage());
                } else if (warned) {
                    more++;
                }
            }
        }
        if (more > 0) {
            warnings.add(scene.root().source() + ": found " + more + " more checkpoints that no pod can reach");
        }
        return warnings;
    }

    private SceneException covered(int map, int checkpoint, String barrier) {
        return at(map, checkpoint, "a checkpoint that no pod can reach" + (settings.jitter() == 0 ? ""
            : " at some jitter") + ": what counts is behind or under " + barrier, "a place nearer than "
            + number(settings.checkpointRadius()) + " u to where pods can be");
    }

    private SceneException shutIn(int map, int checkpoint, int first) {
        return at(map, checkpoint, "a checkpoint that no pod can reach from a start at checkpoint " + first
            + (first == 0 ? "" : " (shifted: races may start there)") + ": walls and bumpers shut it in or the start",
            "a gap at least " + number(2 * settings.radius()) + " u wide, for pods of radius "
            + number(settings.radius()));
    }

    /** An error at a checkpoint of the file, or at the word for the official maps. */
    private SceneException at(int map, int checkpoint, String found, String expected) {
        Block race = scene.root().block("race");
        if (race.isArray("maps")) {
            return race.blocks("maps").get(map).blocks("checkpoints").get(checkpoint).error(found, expected);
        }
        return race.error("maps", "in official map " + map + ", checkpoint " + checkpoint + ": " + found, expected);
    }

    private static String place(double[] place) {
        return "(" + number(place[0]) + ", " + number(place[1]) + ")";
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }
}
