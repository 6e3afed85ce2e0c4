package steward.game.podrace.vectors;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.game.Comparison;
import steward.game.TextCodec;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.physics.Impact;
import tools.jackson.databind.JsonNode;

/**
 * Plays a match of the published referee again by the rules and the site's lines, and compares everything.
 *
 * <p>Players who are out have no rank there but the score 0. The published version has no BOOST: the word is fed as a
 * message in brackets where it stands as one, and is a fault otherwise.
 */
final class VectorReplay {

    private static final int SHIELD_MASS = 10;

    private final VectorMatch match;
    private final Comparison comparison;
    private PodRace race;
    private TextCodec lines;

    VectorReplay(VectorMatch match) {
        this.match = match;
        comparison = new Comparison(match.name());
    }

    Comparison compare() {
        PodRaceType.PodRaceSetup setup = match.setup();
        begin(setup, match.start());
        compareState("turn 0", match.start());
        boolean whole = !match.isTurnByTurn();
        for (JsonNode turn : match.turns()) {
            String when = "turn " + turn.get("turn").asInt();
            if (turn.has("before")) {
                begin(setup, turn.get("before"));
            } else if (race.isOver()) {
                comparison.same(when, "a turn", "over: " + race.ending());
                return comparison;
            }
            compareInputs(when, turn);
            command(turn);
            race.play();
            compareImpacts(when, turn);
            comparePaths(when, turn);
            compareState(when, turn.get("state"));
        }
        if (whole && !match.end().get("truncated").asBoolean()) {
            compareEnd();
        }
        return comparison;
    }

    /** A race in a state; at the very start the one that the rules give. */
    private void begin(PodRaceType.PodRaceSetup setup, JsonNode state) {
        race = setup.create(match.checkpoints());
        lines = setup.textCodec(race).orElseThrow();
        boolean byHand = state != match.start() || match.header().get("injected").asBoolean();
        if (!byHand) {
            return;
        }
        for (JsonNode pod : state.get("pods")) {
            int id = pod.get("id").asInt();
            race.setPod(id, state(pod));
            race.bodies().setMass(id, pod.get("shieldUp").asBoolean() ? SHIELD_MASS : 1);
        }
        for (JsonNode player : state.get("players")) {
            race.setTurnsLeft(player.get("id").asInt(), player.get("turnsLeft").asInt());
        }
    }

    static PodState state(JsonNode pod) {
        JsonNode heading = pod.get("heading");
        return new PodState(pod.get("x").asDouble(), pod.get("y").asDouble(), pod.get("vx").asDouble(),
            pod.get("vy").asDouble(), heading.isNull() ? Double.NaN : heading.asDouble(),
            pod.get("shieldTimer").asInt(), true, pod.get("passed").asInt());
    }

    private void compareInputs(String when, JsonNode turn) {
        JsonNode inputs = turn.get("inputs");
        boolean ofOurs = inputs != null && match.podsPerPlayer() > 1;    // with one pod the site has other lines today
        for (int player = 0; ofOurs && player < inputs.size(); player++) {
            if (inputs.get(player).isNull()) {
                continue;
            }
            StringBuilder text = new StringBuilder();
            if (turn.get("turn").asInt() == 1) {
                lines.writeSetup(text, player);
            }
            lines.writeTurn(text, player);
            List<String> recorded = new ArrayList<>();
            inputs.get(player).forEach(line -> recorded.add(line.asString()));
            comparison.same(when + " input of player " + player, recorded, text.toString().lines().toList());
        }
    }

    private void command(JsonNode turn) {
        for (int player = 0; player < match.players(); player++) {
            JsonNode answer = turn.get("commands").get(player);
            if (answer.isNull()) {
                continue;
            }
            if (!answer.isArray()) {
                race.eliminate(player, "no answer in time");
                continue;
            }
            List<String> said = new ArrayList<>();
            answer.forEach(line -> said.add(line.asString()
                .replaceFirst("^(\\S+ \\S+  )BOOST$", "$1(BOOST)").replaceFirst("^(\\S+ \\S+ )BOOST", "$1(BOOST)")));
            byte[] bytes = String.join("\n", said).getBytes(StandardCharsets.UTF_8);
            String wrong = lines.readAnswer(player, bytes, bytes.length);
            if (wrong != null) {
                race.eliminate(player, wrong);
            }
        }
    }

    private void compareImpacts(String when, JsonNode turn) {
        JsonNode recorded = turn.get("impacts");
        comparison.same(when + " impacts", recorded.size(), race.log().impacts());
        for (int k = 0; k < Math.min(recorded.size(), race.log().impacts()); k++) {
            JsonNode of = recorded.get(k);
            Impact impact = race.log().impact(k);
            String what = when + " impact " + k + " ";
            comparison.impact();
            comparison.same(what + "a", of.get("a").asInt(), impact.a());
            comparison.same(what + "b", of.get("b").asInt(), impact.b());
            comparison.same(what + "t", of.get("t").asDouble(), impact.time());
            comparison.same(what + "impulse", of.get("impulse").asDouble(), impact.impulse());
            comparison.same(what + "ax", of.get("ax").asDouble(), impact.ax());
            comparison.same(what + "ay", of.get("ay").asDouble(), impact.ay());
            comparison.same(what + "bx", of.get("bx").asDouble(), impact.bx());
            comparison.same(what + "by", of.get("by").asDouble(), impact.by());
            comparison.same(what + "hx", of.get("hx").asDouble(), (impact.vaxBefore() + impact.vbxBefore()) / 2);
            comparison.same(what + "hy", of.get("hy").asDouble(), (impact.vayBefore() + impact.vbyBefore()) / 2);
        }
    }

    /** The corners by which checkpoints are counted: one per impact, a later one at the same time replaces it. */
    private void comparePaths(String when, JsonNode turn) {
        JsonNode paths = turn.get("paths");
        for (int pod = 0; paths != null && pod < paths.size(); pod++) {
            List<Double> recorded = new ArrayList<>();
            paths.get(pod).forEach(corner -> corner.forEach(number -> recorded.add(number.asDouble())));
            List<Double> found = new ArrayList<>();
            for (int k = 0; k < race.log().knots(); k++) {
                if (race.log().knotBody(k) == pod) {
                    int last = found.size() - 3;
                    if (last >= 0 && found.get(last) == race.log().knotTime(k)) {
                        found.subList(last, last + 3).clear();
                    }
                    found.addAll(List.of(race.log().knotTime(k), race.log().knotX(k), race.log().knotY(k)));
                }
            }
            comparison.same(when + " path of pod " + pod, recorded, found);
        }
    }

    private void compareState(String when, JsonNode state) {
        for (JsonNode recorded : state.get("pods")) {
            int id = recorded.get("id").asInt();
            String what = when + " pod " + id + " ";
            PodState pod = race.pod(id);
            PodState of = state(recorded);
            comparison.same(what + "x", of.x(), pod.x());
            comparison.same(what + "y", of.y(), pod.y());
            comparison.same(what + "vx", of.vx(), pod.vx());
            comparison.same(what + "vy", of.vy(), pod.vy());
            comparison.same(what + "heading", of.heading(), pod.heading());
            comparison.same(what + "shield timer", of.shieldTimer(), pod.shieldTimer());
            comparison.same(what + "shield up", recorded.get("shieldUp").asBoolean(),
                race.bodies().mass[id] == SHIELD_MASS);
            comparison.same(what + "passed", of.passed(), pod.passed());
            comparison.same(what + "next", recorded.get("next").asInt(), race.nextCheckpoint(id));
        }
        int[] ranks = race.ranks();
        for (JsonNode player : state.get("players")) {
            int id = player.get("id").asInt();
            String what = when + " player " + id + " ";
            comparison.same(what + "is out", !player.get("out").isNull(), !race.isIn(id));
            if (race.isIn(id)) {
                comparison.same(what + "turns left", player.get("turnsLeft").asInt(), race.turnsLeft(id));
            }
            if (race.isIn(id) && !when.equals("turn 0")) {
                comparison.same(what + "rank", player.get("rank").asInt(), ranks[id] + 1);
            }
        }
    }

    private void compareEnd() {
        comparison.same("end, turns", match.end().get("turnsPlayed").asInt(), race.turn());
        comparison.same("end, is over", true, race.isOver());
        for (int player = 0; player < match.players(); player++) {
            int score = race.isIn(player) ? match.players() - race.ranks()[player] : 0;
            comparison.same("end, score of " + player, match.end().get("scores").get(player).asString(),
                player + " " + score);
        }
    }
}
