package steward.game.meanmax;

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
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.Comparison;
import steward.game.GroundTruth;
import steward.game.TextCodec;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnSink;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Games of the server: from their seeds and commands, all that they show: scores, rages, impacts with their times and
 * the units as they came into them, all units before rounding and friction, wrecks and effects that came and went, and
 * what bots echo of their input.
 */
class MeanMaxRecordingsTest {

    private static final int SCORES = 1;
    private static final int RAGES = 4;
    private static final int MESSAGES = 9;

    @Test
    void everyGameOfTheServerIsReproduced(TestReporter report) throws IOException {
        List<String> differences = new ArrayList<>();
        long values = 0;
        int turns = 0;
        List<Path> files = GroundTruth.RECORDINGS.files("mean-max", ".json.gz");
        for (Path file : files) {
            Recording recording = new Recording(file);
            Comparison found = recording.compare();
            values += found.values();
            turns += recording.game.turn();
            differences.addAll(found.differences());
        }
        GroundTruth.tell(report, "mean-max, recordings: " + files.size() + " games, " + turns + " turns, " + values
            + " values compared, " + differences.size() + " different");

        assertTrue(values > 0, "the folder holds games");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    /** The lines of a turn, written as the server shows them, while the turn is played. */
    private static final class Shown implements TurnSink {

        private final List<String> lines = new ArrayList<>();
        private Bodies bodies;

        private void at(double when) {
            lines.add(String.format(Locale.ROOT, "#%.5f", when));
        }

        private static long rounded(double value) {
            return (long) Motion.roundHalfAway(value);
        }

        private void unit(int index, double x, double y, double vx, double vy, String more) {
            boolean tanker = bodies.kind[index] == UnitKind.TANKER.ordinal();
            lines.add(bodies.id(index) + (tanker ? "@" + (int) bodies.columns[MeanMaxWorld.WATER][index] : "") + " "
                + rounded(x) + " " + rounded(y) + " " + rounded(vx) + " " + rounded(vy) + more);
        }

        @Override
        public void impact(double when, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                           double impulse, double energy, double massA, double massB, double vaxBefore,
                           double vayBefore, double vaxAfter, double vayAfter, double vbxBefore, double vbyBefore,
                           double vbxAfter, double vbyAfter) {
            at(when);
            unit(bodies.indexOf(a), ax, ay, vaxBefore, vayBefore, "");
            if (b >= 0) {
                unit(bodies.indexOf(b), bx, by, vbxBefore, vbyBefore, "");
            }
        }

        @Override
        public void fact(double when, int kind, int a, int b, double x, double y, double p, double q) {
            if (kind == Sinking.SUNK) {
                at(when);
                int index = bodies.indexOf(a);
                unit(index, x, y, bodies.vx[index], bodies.vy[index], " d");
            } else {
                lines.add(b + "@" + (int) p + " " + rounded(x) + " " + rounded(y) + " 0 0 4 " + q);
            }
        }
    }

    /** One game, played again. */
    private static final class Recording {

        private final JsonNode json;
        private final Comparison comparison;
        private final MeanMax game;
        private final TextCodec lines;
        private final Set<Integer> known = new TreeSet<>();
        private List<SkillEffect> effects;
        private int scoreBefore;
        private Shown shown;

        Recording(Path file) throws IOException {
            try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
                json = JsonMapper.shared().readTree(in).get("success");
            }
            comparison = new Comparison(file.getFileName().toString());
            Scene scene = SceneReader.read(SceneFiles.load("mean-max"), null).withObserver((parts, advance) ->
                (bodies, sink) -> {
                    effects = List.copyOf(playing().world().effects());
                    shown = new Shown();
                    shown.bodies = bodies;
                    advance.turn(bodies, new Both(sink, shown));
                    shown.at(1);
                    for (int k = 0; k < bodies.size(); k++) {
                        shown.unit(k, bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k], "");
                    }
                });
            MeanMaxType.MeanMaxSetup setup = new MeanMaxType().open(scene);
            String input = json.get("refereeInput").asString().strip();
            game = setup.create(Long.parseLong(input.substring("seed=".length())));
            lines = setup.textCodec(game).orElseThrow();
        }

        private MeanMax playing() {
            return game;
        }

        Comparison compare() {
            for (JsonNode frame : json.get("frames")) {
                int player = frame.get("agentId").asInt();
                if (player < 0) {
                    compareStart(frame.get("view").asString().split("\n"));
                    continue;
                }
                if (frame.has("stderr")) {
                    compareInput(player, frame.get("stderr").asString());
                }
                byte[] answer = frame.get("stdout").asString().strip().getBytes(StandardCharsets.UTF_8);
                comparison.same("turn " + (game.turn() + 1) + " answer of " + player, "good",
                    String.valueOf(lines.readAnswer(player, answer, answer.length)).replace("null", "good"));
                if (player == game.players() - 1) {
                    compareTurn(frame.get("view").asString().split("\n", -1));
                }
            }
            comparison.same("is over", true, game.isOver());
            for (int player = 0; player < game.players(); player++) {
                comparison.same("score of " + player, (int) json.get("scores").get(player).asDouble(),
                    game.score(player));
                int inOrder = json.get("ranks").get(player).asInt();
                comparison.same("rank of " + inOrder, player, game.ranks()[inOrder]);
            }
            return comparison;
        }

        private void compareStart(String[] view) {
            List<String> recorded = new ArrayList<>();
            List<String> found = new ArrayList<>();
            for (String line : view) {
                if (line.split(" ").length >= 7) {
                    recorded.add(line);
                }
            }
            Bodies bodies = game.bodies();
            for (int k = 0; k < bodies.size(); k++) {
                known.add(bodies.id(k));
                boolean tanker = game.world().isTanker(k);
                found.add(bodies.id(k) + (tanker ? "@1" : "") + " " + (int) bodies.x[k] + " " + (int) bodies.y[k] + " "
                    + (int) bodies.vx[k] + " " + (int) bodies.vy[k] + " " + bodies.kind[k] + " "
                    + (int) bodies.radius[k]
                    + (tanker ? "" : " " + game.playerOf(bodies.id(k))));
            }
            comparison.same("start", recorded, found);
        }

        /** Bots that echo their input print a whole mass without its fraction. */
        private void compareInput(int player, String echoed) {
            StringBuilder text = new StringBuilder();
            lines.writeTurn(text, player);
            List<String> found = text.toString().lines().map(line -> line.replaceFirst("(\\d)\\.0 ", "$1 ")).toList();
            List<String> recorded = echoed.lines().toList();
            boolean echoes = recorded.size() >= found.size() && recorded.get(0).equals(found.get(0));
            if (echoes) {
                comparison.same("turn " + (game.turn() + 1) + " input of " + player, recorded.subList(0, found.size()),
                    found);
            }
        }

        private void compareTurn(String[] view) {
            List<Integer> effectsBefore = game.world().effects().stream().map(SkillEffect::id).toList();
            List<Wreck> wrecksBefore = List.copyOf(game.world().wrecks());
            Map<Integer, Integer> water = new TreeMap<>();
            scoreBefore = game.score(0) + game.score(1) + game.score(2);
            wrecksBefore.forEach(wreck -> water.put(wreck.id(), wreck.water()));
            game.play();
            String when = "turn " + game.turn() + " ";
            for (int player = 0; player < game.players(); player++) {
                comparison.same(when + "score " + player, view[SCORES + player], "" + game.score(player));
                comparison.same(when + "rage " + player, view[RAGES + player], "" + game.rage(player));
            }
            List<String> recorded = new ArrayList<>();
            for (int k = SCORES + 2 * 3 + MESSAGES; k < view.length; k++) {
                if (!view[k].isEmpty()) {
                    recorded.add(view[k]);
                }
            }
            comparison.same(when + "units", recorded, found(effectsBefore, wrecksBefore, water));
        }

        /**
         * All that is there at the end of a turn, then what has gone in it; what is new says what it is. The water of
         * wrecks is that before the harvest.
         */
        private List<String> found(List<Integer> effectsBefore, List<Wreck> wrecksBefore,
                                   Map<Integer, Integer> wrecks) {
            List<String> found = new ArrayList<>();
            List<String> gone = new ArrayList<>();
            MeanMaxWorld world = game.world();
            boolean ended = false;
            for (String line : shown.lines) {
                int index = line.startsWith("#") ? -1 : game.bodies().indexOf(Integer.parseInt(line.split("[@ ]")[0]));
                boolean isNew = index >= 0 && known.add(game.bodies().id(index));
                String more = isNew ? " 3 " + (int) game.bodies().radius[index] : "";
                if (ended && index < 0) {
                    found.add(line);
                    gone.add(line + " d");
                } else if (ended && world.isTanker(index)) {
                    found.add(game.bodies().id(index) + "@" + (int) game.bodies().columns[MeanMaxWorld.WATER][index]
                        + line.substring(line.indexOf(' ')) + more);
                } else {
                    found.add(line + more);
                }
                ended |= line.equals("#1.00000");
            }
            wrecks.forEach((id, water) -> found.add(id + "@" + water));
            for (int k = 0; k < game.log().facts(); k++) {
                if (game.log().factKind(k) == Sinking.WRECK) {
                    int id = game.log().factB(k);
                    int full = (int) game.log().factP(k);
                    found.add(id + "@" + full);
                    if (world.wrecks().stream().noneMatch(wreck -> wreck.id() == id)) {
                        gone.add(id + "@" + (full - harvestedElsewhere(wrecksBefore, wrecks)) + " d");
                    }
                }
            }
            for (SkillEffect effect : effects) {
                found.add(effectsBefore.contains(effect.id()) ? "" + effect.id() : effect.id() + " "
                    + (int) effect.x() + " " + (int) effect.y() + " " + effect.looter() + " 0 " + effect.skill().type()
                    + " 1000");
            }
            wrecksBefore.stream().filter(wreck -> !world.wrecks().contains(wreck))
                .forEach(wreck -> gone.add(wreck.id() + "@" + wreck.water() + " d"));
            effects.stream().filter(effect -> !world.effects().contains(effect))
                .forEach(effect -> gone.add(effect.id() + " d"));
            found.addAll(gone);
            return found;
        }

        /** What was harvested in this turn and not from a wreck that was there before it, or is still there. */
        private int harvestedElsewhere(List<Wreck> wrecksBefore, Map<Integer, Integer> wrecks) {
            int harvested = -scoreBefore;
            for (int player = 0; player < game.players(); player++) {
                harvested += game.score(player);
            }
            for (Wreck wreck : wrecksBefore) {
                harvested -= wrecks.get(wreck.id()) - wreck.water();
            }
            for (int k = 0; k < game.log().facts(); k++) {
                for (Wreck wreck : game.world().wrecks()) {
                    harvested -= game.log().factKind(k) == Sinking.WRECK && game.log().factB(k) == wreck.id()
                        ? (int) game.log().factP(k) - wreck.water() : 0;
                }
            }
            return harvested;
        }
    }

    /** Tells both. */
    private record Both(TurnSink first, TurnSink second) implements TurnSink {

        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                           double impulse, double energy, double massA, double massB, double vaxBefore,
                           double vayBefore, double vaxAfter, double vayAfter, double vbxBefore, double vbyBefore,
                           double vbxAfter, double vbyAfter) {
            first.impact(time, a, b, ax, ay, bx, by, nx, ny, impulse, energy, massA, massB, vaxBefore, vayBefore,
                vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
            second.impact(time, a, b, ax, ay, bx, by, nx, ny, impulse, energy, massA, massB, vaxBefore, vayBefore,
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
        }
    }
}
