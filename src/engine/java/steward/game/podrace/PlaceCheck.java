package steward.game.podrace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import steward.scene.Field;
import steward.scene.Scene;
import steward.scene.json.Block;
import steward.scene.json.SceneException;

/** Check that pods, walls, bumpers and checkpoints of a race do not overlap; errors are located in the file. */
public record PlaceCheck(Scene scene, PodRaceSettings settings) {

    /** Rounding of two start places brings them nearer by at most sqrt(2). */
    private static final double ROUNDING = 1.5;
    private static final int MOST_WARNINGS = 10;

    /**
     * @return a warning for each checkpoint that one obstacle keeps from all pods, at most {@value #MOST_WARNINGS} and
     *     one that counts the others
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
        return check.checkpoints(obstacles);
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
        String name = overlap.obstacle().name();
        return "pod " + overlap.pod() + String.format(Locale.ROOT, " at its start %.1f u ", overlap.depth())
            + (name.equals(Obstacle.EDGE) ? "outside " : "deep in ") + name + draw + across;
    }

    private String room() {
        double farthest = Math.abs(StartPlaces.side(settings.pods() - 1, settings.pods()));
        return "room for " + settings.pods() + " pods of radius " + number(settings.radius()) + " in a line across "
            + "this checkpoint, up to " + number(farthest) + " u from it";
    }

    private List<String> checkpoints(List<Obstacle> obstacles) {
        List<String> warnings = new ArrayList<>();
        int more = 0;
        for (int map = 0; map < settings.maps().size(); map++) {
            for (int k = 0; k < settings.maps().get(map).length; k++) {
                double[] place = settings.maps().get(map)[k];
                Obstacle barrier = obstacles.stream().filter(obstacle -> covers(obstacle, place)).findFirst()
                    .orElse(null);
                if (barrier != null && warnings.size() < MOST_WARNINGS) {
                    warnings.add(at(map, k, "a checkpoint that no pod can reach" + (settings.jitter() == 0 ? ""
                        : " at some jitter") + ": what counts is behind or under " + barrier.name(),
                        "a place nearer than " + number(settings.checkpointRadius()) + " u to where pods can be")
                        .getMessage());
                } else if (barrier != null) {
                    more++;
                }
            }
        }
        if (more > 0) {
            warnings.add(scene.root().source() + ": found " + more + " more checkpoints that no pod can reach");
        }
        return warnings;
    }

    /** True if an obstacle has all places that count at a corner, the middle of a side or the centre of the jitter. */
    private boolean covers(Obstacle obstacle, double... place) {
        boolean covered = false;
        for (int k = 0; k < 9; k++) {
            covered |= obstacle.gap().of(place[0] + settings.jitter() * (k % 3 - 1),
                place[1] + settings.jitter() * (k / 3 - 1), settings.radius()) + settings.checkpointRadius() < 0;
        }
        return covered;
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
