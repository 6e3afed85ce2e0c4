package steward.game.fantasticbits;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import steward.game.Comparison;
import steward.game.TextCodec;
import steward.game.fantasticbits.protocol.FantasticBitsType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.databind.JsonNode;

/** Plays a match of the published referee again by the rules and the site's lines, and compares everything. */
final class FantasticBitsReplay {

    private static final List<String> SIDES = List.of("LEFT", "TOP", "RIGHT", "BOTTOM");

    private final FantasticBitsMatch match;
    private final FantasticBitsType.FantasticBitsSetup setup;
    private final Comparison comparison;

    FantasticBitsReplay(FantasticBitsMatch match) {
        this.match = match;
        setup = match.setup();
        comparison = new Comparison(match.name());
    }

    /** From the start to the end. */
    Comparison compareWhole() {
        FantasticBits game = match.begin();
        comparison.same("score to win", match.header().get("scoreToWin").asInt(), game.winningScore());
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
        FantasticBits fresh = setup.create(match.seed());
        for (JsonNode turn : match.turns()) {
            compareTurn("turn " + turn.get("turn").asInt() + " alone", turn, FantasticBitsMatch.in(fresh, before));
            before = turn.get("state");
        }
        return comparison;
    }

    private void compareTurn(String when, JsonNode turn, FantasticBits game) {
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
                if (turn.get("turn").asInt() == 1) {
                    lines.writeSetup(text, player);
                }
                lines.writeTurn(text, player);
                List<String> recorded = new ArrayList<>();
                inputs.get(player).forEach(line -> recorded.add(line.asString()));
                comparison.same(when + " input of player " + player, recorded, text.toString().lines().toList());
            }
        }
    }

    /** Bounces are impacts of the log; captures, goals and open goals are facts of it, each in their order. */
    private void compareImpacts(String when, JsonNode turn, TurnLog log) {
        int impact = 0;
        int fact = 0;
        for (JsonNode of : turn.get("impacts")) {
            String what = when + " impact " + (impact + fact) + " ";
            comparison.impact();
            String kind = of.get("kind").asString();
            boolean open = kind.equals("wall") && fact < log.facts() && log.factKind(fact) == Captures.OPEN_GOAL
                && log.factA(fact) == of.get("a").asInt() && of.get("force").asDouble() == 0;
            if (open || kind.equals("capture") || kind.equals("goal")) {
                if (fact == log.facts()) {
                    comparison.same(what, of.toString(), "none");
                    return;
                }
                int expected = open ? Captures.OPEN_GOAL : kind.equals("goal") ? Captures.GOAL : Captures.CAPTURE;
                comparison.same(what + "kind", expected, log.factKind(fact));
                comparison.same(what + "t", of.get("t").asDouble(), log.factTime(fact));
                comparison.same(what + "a", of.get("a").asInt(), log.factA(fact));
                comparison.same(what + "b", open ? SIDES.indexOf(of.get("side").asString())
                    : of.get(kind.equals("goal") ? "player" : "b").asInt(), log.factB(fact));
                fact++;
            } else if (impact < log.impacts()) {
                compare(what, of, log.impact(impact++));
            } else {
                comparison.same(what, of.toString(), "none");
                return;
            }
        }
        comparison.same(when + " impacts", log.impacts(), impact);
        comparison.same(when + " facts", log.facts(), fact);
    }

    private void compare(String what, JsonNode of, Impact impact) {
        comparison.same(what + "t", of.get("t").asDouble(), impact.time());
        comparison.same(what + "a", of.get("a").asInt(), impact.a());
        boolean wall = of.get("kind").asString().equals("wall");
        comparison.same(what + "is wall", wall, impact.isWall());
        if (wall) {
            comparison.same(what + "side", of.get("side").asString(), SIDES.get(impact.wall()));
            double force = impact.normalX() + impact.normalY() < 0 ? 0.0 - impact.impulse() : impact.impulse();
            comparison.same(what + "force", of.get("force").asDouble() + 0.0, force + 0.0);
        } else {
            comparison.same(what + "b", of.get("b").asInt(), impact.b());
            if (of.has("force")) {
                comparison.same(what + "force", of.get("force").asDouble(), impact.impulse());
            }
        }
    }

    private void compareState(String when, JsonNode state, FantasticBits game) {
        Pitch pitch = game.pitch();
        Bodies bodies = pitch.bodies();
        for (int player = 0; player < game.players(); player++) {
            String what = when + " player " + player + " ";
            comparison.same(what + "score", state.get("scores").get(player).asInt(), game.score(player));
            comparison.same(what + "magic", state.get("magic").get(player).asInt(), game.magic(player));
            comparison.same(what + "is out", state.get("dead").get(player).asBoolean(), !game.isIn(player));
        }
        comparison.same(when + " snaffles", state.get("snaffles").size(), pitch.snaffles());
        for (JsonNode wizard : state.get("wizards")) {
            int id = wizard.get("id").asInt();
            String what = when + " wizard " + id + " ";
            compareMotion(what, wizard, bodies);
            comparison.same(what + "player", wizard.get("player").asInt(), Pitch.playerOf(id));
            comparison.same(what + "snaffle", wizard.get("snaffle").asInt(), pitch.held(id));
            comparison.same(what + "wait", wizard.get("captureWait").asDouble(), bodies.columns[Pitch.WAIT][id]);
            for (Spell spell : Spell.values()) {
                comparison.same(what + spell.text(), List.of(wizard.get(spell.text()).get(0).asInt(),
                    wizard.get(spell.text()).get(1).asInt()), List.of(pitch.spells().turns(id, spell),
                        pitch.spells().target(id, spell)));
            }
            JsonNode cast = wizard.get("cast");
            comparison.same(what + "cast", cast.isNull() ? "none" : cast.get(0).asString() + cast.get(1).asInt(),
                pitch.spells().cast(id) == null ? "none"
                    : pitch.spells().cast(id).text() + pitch.spells().castAt(id));
        }
        for (JsonNode snaffle : state.get("snaffles")) {
            int id = snaffle.get("id").asInt();
            String what = when + " snaffle " + id + " ";
            compareMotion(what, snaffle, bodies);
            comparison.same(what + "alive", snaffle.get("alive").asBoolean(),
                pitch.kind(id) != EntityKind.LOST_SNAFFLE);
            comparison.same(what + "captured", snaffle.get("captured").asBoolean(), isHeld(pitch, id));
            TreeSet<Integer> recorded = new TreeSet<>();
            snaffle.get("ignores").forEach(other -> recorded.add(other.asInt()));
            TreeSet<Integer> found = new TreeSet<>();
            for (int other = Pitch.WIZARDS; other < Pitch.WIZARDS + pitch.snaffles(); other++) {
                if (Pitch.ignores(bodies, id, other)) {
                    found.add(other);
                }
            }
            comparison.same(what + "ignores", recorded, found);
        }
        for (JsonNode bludger : state.get("bludgers")) {
            int id = bludger.get("id").asInt();
            compareMotion(when + " bludger " + id + " ", bludger, bodies);
            comparison.same(when + " bludger " + id + " last victim", bludger.get("lastVictim").asDouble(),
                bodies.columns[Pitch.LAST_VICTIM][id]);
        }
    }

    private static boolean isHeld(Pitch pitch, int snaffle) {
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            if (pitch.held(wizard) == snaffle) {
                return true;
            }
        }
        return false;
    }

    private void compareMotion(String what, JsonNode entity, Bodies bodies) {
        int id = entity.get("id").asInt();
        comparison.same(what + "x", entity.get("x").asDouble(), bodies.x[id]);
        comparison.same(what + "y", entity.get("y").asDouble(), bodies.y[id]);
        comparison.same(what + "vx", entity.get("vx").asDouble(), bodies.vx[id]);
        comparison.same(what + "vy", entity.get("vy").asDouble(), bodies.vy[id]);
    }
}
