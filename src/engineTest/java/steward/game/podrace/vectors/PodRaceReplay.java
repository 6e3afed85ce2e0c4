package steward.game.podrace.vectors;

import java.util.ArrayList;
import java.util.List;
import steward.game.VectorMatch;
import steward.game.VectorReplay;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.physics.Impact;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

/**
 * A match of the published referee of the pod race, played again.
 *
 * <p>Players who are out have no rank there but the score 0. The published version has no BOOST: the word is fed as a
 * message in brackets where it stands as one, and is a fault otherwise.
 */
public final class PodRaceReplay extends VectorReplay<PodRace> {

    private static final int SHIELD_MASS = 10;

    public PodRaceReplay(VectorMatch match) {
        super(match, setup(match));
    }

    /** The official scene with this match's numbers and the rules of the contest, lines too. */
    private static PodRaceType.PodRaceSetup setup(VectorMatch match) {
        JsonNode header = match.header();
        String scene = SceneFiles.load("mad-pod-racing").text()
            .replace("\"rules\": \"live\"", "\"rules\": \"contest\", \"commands\": \"site\"")
            .replace("\"players\": 2", "\"players\": " + header.get("players").asInt())
            .replace("\"perPlayer\": 2", "\"perPlayer\": " + header.get("podsPerPlayer").asInt())
            .replace("\"laps\": 3", "\"laps\": " + header.get("laps").asInt())
            .replace("\"turnsWithoutCheckpoint\": 100",
                "\"turnsWithoutCheckpoint\": " + header.get("turnsWithoutCheckpoint").asInt())
            .replace("\"maximumTurns\": 500", "\"maximumTurns\": " + header.get("maximumTurns").asInt());
        return new PodRaceType().open(SceneReader.read(scene, match.name()));
    }

    static double[][] checkpoints(VectorMatch match) {
        JsonNode places = match.header().get("checkpoints");
        double[][] checkpoints = new double[places.size()][];
        for (int k = 0; k < checkpoints.length; k++) {
            checkpoints[k] = new double[] {places.get(k).get(0).asDouble(), places.get(k).get(1).asDouble()};
        }
        return checkpoints;
    }

    @Override
    protected PodRace create() {
        return ((PodRaceType.PodRaceSetup) setup).create(checkpoints(match));
    }

    @Override
    protected PodRace in(PodRace fresh, JsonNode state) {
        PodRace race = create();
        for (JsonNode pod : state.get("pods")) {
            int id = pod.get("id").asInt();
            race.setPod(id, state(pod));
            race.bodies().setMass(id, pod.get("shieldUp").asBoolean() ? SHIELD_MASS : 1);
        }
        for (JsonNode player : state.get("players")) {
            int id = player.get("id").asInt();
            race.setTurnsLeft(id, player.get("turnsLeft").asInt());
            if (!player.get("out").isNull()) {
                race.eliminate(id, "out before");
            }
        }
        return race;
    }

    static PodState state(JsonNode pod) {
        JsonNode heading = pod.get("heading");
        return new PodState(pod.get("x").asDouble(), pod.get("y").asDouble(), pod.get("vx").asDouble(),
            pod.get("vy").asDouble(), heading.isNull() ? Double.NaN : heading.asDouble(),
            pod.get("shieldTimer").asInt(), true, pod.get("passed").asInt());
    }

    @Override
    protected Object score(PodRace race, int player) {
        return race.isIn(player) ? race.players() - race.ranks()[player] : 0;
    }

    /** With one pod the site has other lines today. */
    @Override
    protected JsonNode inputs(JsonNode turn) {
        return match.header().get("podsPerPlayer").asInt() > 1 ? turn.get("inputs") : null;
    }

    @Override
    protected JsonNode commands(JsonNode turn) {
        ArrayNode players = JsonNodeFactory.instance.arrayNode();
        for (JsonNode answer : turn.get("commands")) {
            if (answer.isArray()) {
                ArrayNode lines = players.addArray();
                texts(answer).forEach(line -> lines.add(line.replaceFirst("^(\\S+ \\S+  )BOOST$", "$1(BOOST)")
                    .replaceFirst("^(\\S+ \\S+ )BOOST", "$1(BOOST)")));
            } else {
                players.add(answer);
            }
        }
        return players;
    }

    @Override
    protected void compareImpacts(String when, JsonNode turn, PodRace race) {
        JsonNode recorded = turn.get("impacts");
        comparison.same(when + " impacts", recorded.size(), race.log().impacts());
        for (int k = 0; k < Math.min(recorded.size(), race.log().impacts()); k++) {
            JsonNode of = recorded.get(k);
            Impact impact = race.log().impact(k);
            String what = when + " impact " + k + " ";
            comparison.impact();
            comparison.fields(what, of, "a", impact.a(), "b", impact.b(), "t", impact.time(),
                "impulse", impact.impulse(), "ax", impact.ax(), "ay", impact.ay(), "bx", impact.bx(),
                "by", impact.by(), "hx", (impact.vaxBefore() + impact.vbxBefore()) / 2,
                "hy", (impact.vayBefore() + impact.vbyBefore()) / 2);
        }
        comparePaths(when, turn, race);
    }

    /** The corners by which checkpoints are counted: one per impact, a later one at the same time replaces it. */
    private void comparePaths(String when, JsonNode turn, PodRace race) {
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

    @Override
    protected void compareState(String when, JsonNode state, PodRace race) {
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
}
