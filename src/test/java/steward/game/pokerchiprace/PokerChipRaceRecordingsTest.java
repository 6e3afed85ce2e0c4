package steward.game.pokerchiprace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.physics.Bodies;
import steward.physics.TurnLog;
import steward.physics.TurnSink;
import steward.scene.Scene;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Games of the server: from their seeds and commands, all that they show of the rules: chips before and after every
 * turn with owners, radii and places, areas and scores, and when and where chips were born, hit a wall, ate and were
 * eaten. The angles by which the site turns its pictures are no part of the rules.
 */
class PokerChipRaceRecordingsTest {

    private static final Map<String, String> FIELDS = Map.of("player_initial_radius", "radius",
        "chips_count_per_player", "perPlayer", "symmetric", "symmetric", "max_neutral_count", "neutral");
    /** Words of a chip's line before its points, and of a point. */
    private static final int CHIP_WORDS = 7;
    private static final int POINT_WORDS = 6;
    private static final int ROTATION = 4;

    private PokerChipRace game;
    private TextCodec lines;
    private Comparison comparison;
    private Points points;

    @Test
    void everyGameOfTheServerIsReproduced(TestReporter report) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        int turns = 0;
        List<Path> files = GroundTruth.RECORDINGS.files("poker-chip-race", ".json.gz");
        for (Path file : files) {
            compare(file);
            values += comparison.values();
            turns += game.turn();
            differences.addAll(comparison.differences());
        }
        GroundTruth.tell(report, "poker-chip-race, recordings: " + files.size() + " games, " + turns + " turns, "
            + values + " values compared, " + differences.size() + " different");

        assertTrue(values > 0, "the folder holds games");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    private void compare(Path file) throws IOException {
        JsonNode json;
        try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
            json = JsonMapper.shared().readTree(in).get("success");
        }
        comparison = new Comparison(file.getFileName().toString());
        begin(json);
        for (JsonNode frame : json.get("frames")) {
            int player = frame.get("agentId").asInt();
            String[] view = frame.get("view").asString().split("\n");
            if (player >= 0) {
                String when = "turn " + (game.turn() + 1) + " answer of " + player;
                byte[] answer = frame.get("stdout").asString().strip().getBytes(StandardCharsets.UTF_8);
                comparison.same(when, "good",
                    String.valueOf(lines.readAnswer(player, answer, answer.length)).replace("null", "good"));
            }
            boolean played = player == game.players() - 1;
            if (played) {
                game.play();
            }
            compareView("after turn " + game.turn() + ", player " + player + " ",
                List.of(view).subList(player < 0 ? 3 : 1, view.length), played);
        }
    }

    private void begin(JsonNode json) {
        StringBuilder fields = new StringBuilder();
        long seed = 0;
        for (String line : json.get("refereeInput").asString().strip().split("\n")) {
            String[] property = line.split("=");
            if (property[0].equals("seed")) {
                seed = Long.parseLong(property[1]);
            } else {
                fields.append('"').append(FIELDS.get(property[0])).append("\": ").append(property[1]).append(", ");
            }
        }
        int players = json.get("frames").get(0).get("view").asString().split("\n")[2].charAt(0) - '0';
        Scene scene = PokerMatch.scene(players, fields.toString()).withObserver((parts, advance) -> (bodies, sink) -> {
            points = new Points(bodies);
            advance.turn(bodies, new Both(sink, points));
        });
        PokerChipRaceType.PokerChipRaceSetup setup = new PokerChipRaceType().open(scene);
        game = setup.create(seed);
        lines = setup.textCodec(game).orElseThrow();
    }

    /** @param played whether the view is that after a turn: it shows what happened in it */
    private void compareView(String when, List<String> view, boolean played) {
        List<String> recorded = new ArrayList<>();
        for (String line : view) {
            recorded.add(line.split(" ").length >= CHIP_WORDS ? withoutRotation(line) : line);
        }
        List<String> found = new ArrayList<>();
        Map<Integer, String> chips = played ? chipsWithPoints() : chips();
        found.add(Integer.toString(chips.size()));
        found.addAll(chips.values());
        StringBuilder areas = new StringBuilder();
        StringBuilder scores = new StringBuilder();
        double all = 0;
        for (int chip = 0; chip < game.bodies().size(); chip++) {
            all += game.bodies().mass[chip];
        }
        for (int player = 0; player < game.players(); player++) {
            areas.append(String.format(Locale.ROOT, "%f ", game.table().areaOf(player)));
            scores.append(scores.isEmpty() ? "" : " ").append(game.score(player));
        }
        found.add(areas + String.format(Locale.ROOT, "%f", all));
        found.add(scores.toString());
        comparison.same(when + "lines", recorded.size(), found.size());
        for (int k = 0; k < Math.min(recorded.size(), found.size()); k++) {
            comparison.same(when + "line " + k, recorded.get(k), found.get(k));
        }
    }

    /** A chip's line: {@code id owner r x y rotation points} and for each point {@code t x y r rotation other}. */
    private static String withoutRotation(String line) {
        String[] words = line.split(" ");
        StringBuilder left = new StringBuilder();
        for (int k = 0; k < words.length; k++) {
            boolean rotation = k == CHIP_WORDS - 2 || k >= CHIP_WORDS && (k - CHIP_WORDS) % POINT_WORDS == ROTATION;
            left.append(rotation ? "" : words[k] + " ");
        }
        return left.toString().strip();
    }

    private static String place(double r, double x, double y) {
        return String.format(Locale.ROOT, "%.2f %.2f %.2f", r, x + 400, y + 257.5);
    }

    private Map<Integer, String> chips() {
        Map<Integer, String> chips = new TreeMap<>();
        Bodies bodies = game.bodies();
        for (int chip = 0; chip < bodies.size(); chip++) {
            chips.put(bodies.id(chip), bodies.id(chip) + " " + game.table().owner(chip) + " "
                + place(bodies.radius[chip], bodies.x[chip], bodies.y[chip]) + " 0");
        }
        return chips;
    }

    /** The chips after a turn and those eaten in it, each with the points of its path. */
    private Map<Integer, String> chipsWithPoints() {
        Map<Integer, String> chips = chips();
        TurnLog log = game.log();
        for (int k = 0; k < log.facts(); k++) {
            chips.put(log.factA(k), log.factA(k) + " " + (int) log.factP(k) + " "
                + place(-1, log.factX(k), log.factY(k)) + " 0");
        }
        points.points.forEach((id, of) -> chips.computeIfPresent(id, (same, line) ->
            line.substring(0, line.lastIndexOf(' ')) + " " + of.size() + " " + String.join(" ", of)));
        return chips;
    }

    /** The points of the paths of a turn, written as the server shows them, while the turn is played. */
    private static final class Points implements TurnSink {

        private final Map<Integer, List<String>> points = new TreeMap<>();
        private final Bodies bodies;
        private int eater = -1;
        private int eaten = -1;

        Points(Bodies bodies) {
            this.bodies = bodies;
            for (int chip = 0; chip < bodies.size(); chip++) {
                int parent = (int) bodies.columns[ChipTable.PARENT][chip];
                if (parent >= 0) {
                    add(bodies.id(chip), 0, bodies.x[chip], bodies.y[chip], bodies.radius[chip], parent);
                }
            }
        }

        private void add(int id, double time, double x, double y, double r, int other) {
            points.computeIfAbsent(id, chip -> new ArrayList<>()).add(
                String.format(Locale.ROOT, "%.2f %.2f %.2f %.2f %d", time, x + 400, y + 257.5, r, other));
        }

        @Override
        public void knot(int id, double time, double x, double y) {
            add(id, time, x, y, bodies.radius[bodies.indexOf(id)], id == eater ? eaten : -1);
            eater = -1;
        }

        /** The knot of the eaten chip came just before, with its radius; that of the eater after the meal is next. */
        @Override
        public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
            points.get(a).remove(points.get(a).size() - 1);
            add(a, time, x, y, -1, -1);
            eater = b;
            eaten = a;
        }
    }

    /** Tells both what the look at a turn needs. */
    private record Both(TurnSink first, TurnSink second) implements TurnSink {

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                           double impulse, double energy, double massA, double massB, double vaxBefore,
                           double vayBefore, double vaxAfter, double vayAfter, double vbxBefore, double vbyBefore,
                           double vbxAfter, double vbyAfter) {
            first.impact(time, a, b, ax, ay, bx, by, nx, ny, impulse, energy, massA, massB, vaxBefore, vayBefore,
                vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
        }

        @Override
        public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
            first.fact(time, kind, a, b, x, y, p, q);
            second.fact(time, kind, a, b, x, y, p, q);
        }

        @Override
        public void knot(int bodyId, double time, double x, double y) {
            first.knot(bodyId, time, x, y);
            second.knot(bodyId, time, x, y);
        }
    }
}
