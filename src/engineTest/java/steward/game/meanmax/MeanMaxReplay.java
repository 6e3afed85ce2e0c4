package steward.game.meanmax;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.game.Comparison;
import steward.game.TextCodec;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.databind.JsonNode;

/** Plays a match of the published referee again by the rules and the site's lines, and compares everything. */
final class MeanMaxReplay {

    private final MeanMaxMatch match;
    private final MeanMaxType.MeanMaxSetup setup;
    private final Comparison comparison;

    MeanMaxReplay(MeanMaxMatch match) {
        this.match = match;
        setup = match.setup();
        comparison = new Comparison(match.name());
    }

    /** From the start to the end. */
    Comparison compareWhole() {
        MeanMax game = match.begin();
        compareHeader(game);
        compareState("turn 0", match.start(), game);
        for (JsonNode turn : match.turns()) {
            String when = "turn " + turn.get("turn").asInt();
            if (game.isOver()) {
                comparison.same(when, "a turn", "over: " + game.ending());
                return comparison;
            }
            compareTurn(when, turn, game);
        }
        if (!match.end().get("truncated").asBoolean()) {
            comparison.same("end, turns", match.end().get("turnsPlayed").asInt(), game.turn());
            comparison.same("end, is over", true, game.isOver());
            for (int player = 0; player < game.players(); player++) {
                comparison.same("end, score of " + player, match.end().get("scores").get(player).asString(),
                    player + " " + game.score(player));
            }
        }
        return comparison;
    }

    /** Each turn from the recorded state before it. */
    Comparison compareTurnByTurn() {
        JsonNode before = match.start();
        MeanMax fresh = setup.create(match.seed());
        for (JsonNode turn : match.turns()) {
            MeanMax game = match.in(fresh, before);
            for (int player = 0; player < game.players(); player++) {
                if (before.get("dead").get(player).asBoolean()) {
                    game.eliminate(player, "out before");
                }
            }
            compareTurn("turn " + turn.get("turn").asInt() + " alone", turn, game);
            before = turn.get("state");
        }
        return comparison;
    }

    private void compareHeader(MeanMax game) {
        int size = 0;
        TankerQueue queue = game.world().queue().copy();
        for (JsonNode next : match.header().get("nextTankers")) {
            comparison.same("next tanker " + size, next.get(0).asInt(), queue.size(0));
            comparison.same("next tanker " + size++, next.get(1).asDouble(), queue.angle(0));
            queue.take(0);
        }
    }

    private void compareTurn(String when, JsonNode turn, MeanMax game) {
        TextCodec lines = setup.textCodec(game).orElseThrow();
        compareInputs(when, turn, lines);
        for (int player = 0; player < game.players(); player++) {
            JsonNode answer = turn.get("commands").get(player);
            if (answer.isNull()) {
                comparison.same(when + " player " + player + " is asked", false, game.isIn(player));
            } else if (!answer.isArray()) {
                game.eliminate(player, "no answer in time");
            } else {
                List<String> said = new ArrayList<>();
                answer.forEach(line -> said.add(line.asString()));
                byte[] bytes = String.join("\n", said).getBytes(StandardCharsets.UTF_8);
                String wrong = lines.readAnswer(player, bytes, bytes.length);
                if (wrong != null) {
                    game.eliminate(player, wrong);
                }
            }
        }
        game.play();
        compareImpacts(when, turn, game.log());
        compareState(when, turn.get("state"), game);
    }

    private void compareInputs(String when, JsonNode turn, TextCodec lines) {
        JsonNode inputs = turn.get("inputs");
        for (int player = 0; inputs != null && player < inputs.size(); player++) {
            if (!inputs.get(player).isNull()) {
                StringBuilder text = new StringBuilder();
                lines.writeTurn(text, player);
                List<String> recorded = new ArrayList<>();
                inputs.get(player).forEach(line -> recorded.add(line.asString()));
                comparison.same(when + " input of player " + player, recorded, text.toString().lines().toList());
            }
        }
    }

    /** Bounces are impacts of the log, sinkings are facts of it, each in their order. */
    private void compareImpacts(String when, JsonNode turn, TurnLog log) {
        int impact = 0;
        int fact = 0;
        for (JsonNode of : turn.get("impacts")) {
            String what = when + " impact " + (impact + fact) + " ";
            comparison.impact();
            if (of.has("sunk")) {
                boolean there = fact < log.facts() && log.factKind(fact) == Sinking.SUNK;
                comparison.same(what + "sinks", true, there);
                if (!there) {
                    return;
                }
                int[] two = {log.factA(fact), log.factB(fact)};
                comparison.same(what + "sunk", of.get("sunk").asInt(), two[0]);
                comparison.same(what + "a, b", of.get("a").asInt() + of.get("b").asInt(), two[0] + two[1]);
                comparison.same(what + "t", of.get("t").asDouble(), log.factTime(fact));
                fact++;
                boolean wreck = fact < log.facts() && log.factKind(fact) == Sinking.WRECK;
                comparison.same(what + "wreck", of.get("wreck").asInt(), wreck ? log.factB(fact) : -1);
                fact += wreck ? 1 : 0;
            } else if (impact < log.impacts()) {
                compare(what, of, log.impact(impact++));
            } else {
                comparison.same(what, of.toString(), "none");
            }
        }
        comparison.same(when + " impacts", log.impacts(), impact);
        comparison.same(when + " facts", log.facts(), fact);
    }

    private void compare(String what, JsonNode of, Impact impact) {
        comparison.same(what + "t", of.get("t").asDouble(), impact.time());
        comparison.same(what + "a", of.get("a").asInt(), impact.a());
        comparison.same(what + "b", of.get("b").asInt(), impact.b());
        comparison.same(what + "vx of a", of.get("av").get(0).asDouble(), impact.vaxAfter());
        comparison.same(what + "vy of a", of.get("av").get(1).asDouble(), impact.vayAfter());
        if (!impact.isWall()) {
            comparison.same(what + "vx of b", of.get("bv").get(0).asDouble(), impact.vbxAfter());
            comparison.same(what + "vy of b", of.get("bv").get(1).asDouble(), impact.vbyAfter());
        }
    }

    private void compareState(String when, JsonNode state, MeanMax game) {
        MeanMaxWorld world = game.world();
        Bodies bodies = world.bodies();
        comparison.same(when + " next id", state.get("nextId").asInt(), bodies.nextId());
        for (int player = 0; player < game.players(); player++) {
            String what = when + " player " + player + " ";
            comparison.same(what + "score", state.get("scores").get(player).asInt(), game.score(player));
            comparison.same(what + "rage", state.get("rages").get(player).asInt(), game.rage(player));
            comparison.same(what + "is out", state.get("dead").get(player).asBoolean(), !game.isIn(player));
            comparison.same(what + "tankers left", state.get("tankersLeft").get(player).asInt(),
                world.queue().left(player));
        }
        comparison.same(when + " units", state.get("units").size(), bodies.size());
        for (int k = 0; k < Math.min(state.get("units").size(), bodies.size()); k++) {
            JsonNode unit = state.get("units").get(k);
            String what = when + " unit " + k + " ";
            comparison.same(what + "id", unit.get("id").asInt(), bodies.id(k));
            comparison.same(what + "type", unit.get("type").asInt(), bodies.kind[k]);
            comparison.same(what + "player", unit.get("player").asDouble(), bodies.columns[MeanMaxWorld.OWNER][k]);
            comparison.same(what + "x", unit.get("x").asDouble(), bodies.x[k]);
            comparison.same(what + "y", unit.get("y").asDouble(), bodies.y[k]);
            comparison.same(what + "vx", unit.get("vx").asDouble(), bodies.vx[k]);
            comparison.same(what + "vy", unit.get("vy").asDouble(), bodies.vy[k]);
            comparison.same(what + "mass", unit.get("mass").asDouble(), bodies.mass[k]);
            comparison.same(what + "radius", unit.get("radius").asDouble(), bodies.radius[k]);
            if (world.isTanker(k)) {
                comparison.same(what + "water", unit.get("water").asDouble(), bodies.columns[MeanMaxWorld.WATER][k]);
                comparison.same(what + "size", unit.get("size").asDouble(), bodies.columns[MeanMaxWorld.SIZE][k]);
            }
        }
        comparison.same(when + " wrecks", state.get("wrecks").size(), world.wrecks().size());
        for (int k = 0; k < Math.min(state.get("wrecks").size(), world.wrecks().size()); k++) {
            JsonNode of = state.get("wrecks").get(k);
            Wreck wreck = world.wrecks().get(k);
            comparison.same(when + " wreck " + k, List.of(of.get("id").asInt(), of.get("x").asDouble(),
                of.get("y").asDouble(), of.get("radius").asDouble(), of.get("water").asInt(),
                of.path("player").asInt(-1)), List.of(wreck.id(), wreck.x(), wreck.y(), wreck.radius(), wreck.water(),
                wreck.player()));
        }
        comparison.same(when + " effects", state.get("effects").size(), world.effects().size());
        for (int k = 0; k < Math.min(state.get("effects").size(), world.effects().size()); k++) {
            JsonNode of = state.get("effects").get(k);
            SkillEffect effect = world.effects().get(k);
            comparison.same(when + " effect " + k, List.of(of.get("id").asInt(), of.get("type").asInt(),
                of.get("x").asDouble(), of.get("y").asDouble(), of.get("duration").asInt(), of.get("looter").asInt()),
                List.of(effect.id(), effect.skill().type(), effect.x(), effect.y(), effect.duration(),
                    effect.looter()));
        }
    }
}
