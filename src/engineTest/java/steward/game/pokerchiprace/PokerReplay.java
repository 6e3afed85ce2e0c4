package steward.game.pokerchiprace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import steward.game.Comparison;
import steward.game.TextCodec;
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.databind.JsonNode;

/** Plays a match of the published referee again by the rules and the site's lines, and compares everything. */
final class PokerReplay {

    private static final String[] SIDES = {"LEFT", "TOP", "RIGHT", "BOTTOM"};

    private final PokerMatch match;
    private final PokerChipRaceType.PokerChipRaceSetup setup;
    private final Comparison comparison;

    PokerReplay(PokerMatch match) {
        this.match = match;
        setup = match.setup();
        comparison = new Comparison(match.name());
    }

    /** From the start to the end. */
    Comparison compareWhole() {
        PokerChipRace game = match.begin();
        compareState("turn 0", match.start(), game, 0);
        for (JsonNode turn : match.turns()) {
            String when = "turn " + turn.get("turn").asInt();
            if (game.isOver()) {
                comparison.same(when, "a turn", "over: " + game.ending());
                return comparison;
            }
            compareTurn(when, turn, game, 0);
        }
        if (!match.end().get("truncated").asBoolean()) {
            compareEnd(game);
        }
        return comparison;
    }

    /** The commands of a turn that was not played end the game in it. */
    private void compareEnd(PokerChipRace game) {
        JsonNode last = match.end().get("lastCommands");
        int played = game.turn();
        if (last != null) {
            comparison.same("end, is over before the last commands", false, game.isOver());
            answer("the last turn", last, null, game, 0);
            if (!game.isOver()) {
                game.play();
            }
        }
        comparison.same("end, turns", match.end().get("turnsPlayed").asInt(), played);
        comparison.same("end, is over", true, game.isOver());
        for (int player = 0; player < game.players(); player++) {
            comparison.same("end, score of " + player, match.end().get("scores").get(player).asString(),
                player + " " + game.score(player));
        }
    }

    /** Each turn from the recorded state before it. */
    Comparison compareTurnByTurn() {
        JsonNode before = match.start();
        PokerChipRace fresh = setup.create(match.seed());
        for (JsonNode turn : match.turns()) {
            int number = turn.get("turn").asInt();
            compareTurn("turn " + number + " alone", turn, PokerMatch.in(fresh, before), number - 1);
            before = turn.get("state");
        }
        return comparison;
    }

    /** @param offset turns played before the game began */
    private void compareTurn(String when, JsonNode turn, PokerChipRace game, int offset) {
        answer(when, turn.get("commands"), turn.get("inputs"), game, offset);
        int born = game.bodies().nextId();
        game.play();
        compareImpacts(when, turn, game.log());
        compareState(when, turn.get("state"), game, offset);
        comparison.same(when + " pushes", turn.get("pushes").size(), game.bodies().nextId() - born);
        for (int k = 0; k < turn.get("pushes").size(); k++) {
            int chip = game.bodies().indexOf(born + k);
            if (chip >= 0 && game.bodies().columns[ChipTable.PARENT][chip] >= 0) {
                comparison.same(when + " push " + k, turn.get("pushes").get(k).asInt(),
                    (int) game.bodies().columns[ChipTable.PARENT][chip]);
            }
        }
    }

    /** One player after another: who is asked later sees that the chips of one at fault are neutral. */
    private void answer(String when, JsonNode commands, JsonNode inputs, PokerChipRace game, int offset) {
        TextCodec lines = setup.textCodec(game).orElseThrow();
        boolean over = false;
        for (int player = 0; player < game.players(); player++) {
            JsonNode answer = commands.get(player);
            if (inputs != null && !inputs.get(player).isNull()) {
                compareInput(when, inputs.get(player), player, game, offset);
            }
            if (answer.isNull()) {
                comparison.same(when + " player " + player + " is asked", false,
                    game.isIn(player) && !over);
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
            int in = 0;
            for (int other = 0; other < game.players(); other++) {
                in += game.isIn(other) ? 1 : 0;
            }
            over = in < 2;
        }
    }

    private void compareInput(String when, JsonNode input, int player, PokerChipRace game, int offset) {
        TextCodec lines = setup.textCodec(game).orElseThrow();
        StringBuilder text = new StringBuilder();
        if (game.turn() + offset == 0) {
            lines.writeSetup(text, player);
        }
        lines.writeTurn(text, player);
        List<String> recorded = new ArrayList<>();
        input.forEach(line -> recorded.add(line.asString()));
        comparison.same(when + " input of player " + player, recorded, text.toString().lines().toList());
        comparison.same(when + " lines of player " + player, Math.max(1, game.table().owned(player)),
            lines.answerLines(player));
    }

    /** Bounces are impacts of the log, the others are facts of it, each in their order. */
    private void compareImpacts(String when, JsonNode turn, TurnLog log) {
        int impact = 0;
        int fact = 0;
        for (JsonNode of : turn.get("impacts")) {
            String what = when + " impact " + (impact + fact) + " ";
            comparison.impact();
            boolean eaten = of.get("kind").asString().equals("eat");
            boolean ghosts = of.get("kind").asString().equals("bounce") && of.get("ra").asDouble() < 0;
            if (eaten || ghosts) {
                if (fact >= log.facts()) {
                    comparison.same(what, of.toString(), "none");
                    return;
                }
                compareFact(what, of, log, fact++, ghosts);
            } else if (impact < log.impacts()) {
                compare(what, of, log.impact(impact++));
            } else {
                comparison.same(what, of.toString(), "none");
            }
        }
        comparison.same(when + " impacts", log.impacts(), impact);
        comparison.same(when + " facts", log.facts(), fact);
    }

    private void compareFact(String what, JsonNode of, TurnLog log, int fact, boolean ghosts) {
        int a = of.get("a").asInt();
        int b = of.get("b").asInt();
        boolean first = of.get("ra").asDouble() > of.get("rb").asDouble() || ghosts;
        JsonNode eaten = of.get(ghosts || !first ? "afterA" : "afterB");
        double radius = ghosts ? -1 : of.get(first ? "rb" : "ra").asDouble();
        int kind = ghosts ? ChipEating.BOUNCE_OF_EATEN : radius < 0 ? ChipEating.EATEN_AGAIN : ChipEating.EATEN;
        comparison.same(what + "kind", kind, log.factKind(fact));
        comparison.same(what + "t", of.get("t").asDouble(), log.factTime(fact));
        comparison.same(what + "a", ghosts ? a : first ? b : a, log.factA(fact));
        comparison.same(what + "b", ghosts ? b : first ? a : b, log.factB(fact));
        comparison.same(what + "x", eaten.get("x").asDouble(), log.factX(fact));
        comparison.same(what + "y", eaten.get("y").asDouble(), log.factY(fact));
    }

    private void compare(String what, JsonNode of, Impact impact) {
        comparison.same(what + "t", of.get("t").asDouble(), impact.time());
        comparison.same(what + "a", of.get("a").asInt(), impact.a());
        if (impact.isWall()) {
            comparison.same(what + "side", of.get("kind").asString() + of.path("side").asString(""),
                "wall" + SIDES[~impact.b()]);
            return;
        }
        if (!of.has("afterB")) {
            comparison.same(what + "kind", of.get("kind").asString(), "bounce");
            return;
        }
        comparison.same(what + "b", of.path("b").asInt(-1), impact.b());
        comparison.same(what + "vx of a", of.get("afterA").get("vx").asDouble(), impact.vaxAfter());
        comparison.same(what + "vy of a", of.get("afterA").get("vy").asDouble(), impact.vayAfter());
        comparison.same(what + "vx of b", of.get("afterB").get("vx").asDouble(), impact.vbxAfter());
        comparison.same(what + "vy of b", of.get("afterB").get("vy").asDouble(), impact.vbyAfter());
        comparison.same(what + "x of a", of.get("afterA").get("x").asDouble(), impact.ax());
        comparison.same(what + "y of a", of.get("afterA").get("y").asDouble(), impact.ay());
        comparison.same(what + "x of b", of.get("afterB").get("x").asDouble(), impact.bx());
        comparison.same(what + "y of b", of.get("afterB").get("y").asDouble(), impact.by());
    }

    private void compareState(String when, JsonNode state, PokerChipRace game, int offset) {
        Bodies bodies = game.bodies();
        comparison.same(when + " next id", state.get("nextId").asInt(), bodies.nextId());
        comparison.same(when + " chips", state.get("chips").size(), bodies.size());
        for (int k = 0; k < Math.min(state.get("chips").size(), bodies.size()); k++) {
            JsonNode chip = state.get("chips").get(k);
            String what = when + " chip " + k + " ";
            comparison.same(what + "id", chip.get("id").asInt(), bodies.id(k));
            comparison.same(what + "player", chip.get("player").asDouble(), bodies.columns[ChipTable.OWNER][k]);
            comparison.same(what + "x", chip.get("x").asDouble(), bodies.x[k]);
            comparison.same(what + "y", chip.get("y").asDouble(), bodies.y[k]);
            comparison.same(what + "vx", chip.get("vx").asDouble(), bodies.vx[k]);
            comparison.same(what + "vy", chip.get("vy").asDouble(), bodies.vy[k]);
            comparison.same(what + "radius", chip.get("radius").asDouble(), bodies.radius[k]);
            comparison.same(what + "parent", chip.get("parent").asDouble(), bodies.columns[ChipTable.PARENT][k]);
            TreeSet<Integer> bounced = new TreeSet<>();
            chip.get("bounce").forEach(other -> bounced.add(other.asInt()));
            comparison.same(what + "remembers", bounced, remembered(bodies, bodies.id(k)));
        }
        for (int player = 0; player < game.players(); player++) {
            JsonNode owner = state.get("owners").get(player);
            List<Integer> left = new ArrayList<>();
            owner.get("chips").forEach(id -> left.add(id.asInt()));
            owner.get("eaten").forEach(id -> left.remove((Integer) id.asInt()));
            List<Integer> own = new ArrayList<>();
            for (int k = 0; k < game.table().owned(player); k++) {
                own.add(game.table().ownId(player, k));
            }
            comparison.same(when + " chips of player " + player, left, own);
            double lost = owner.get("lostTime").asDouble();
            if (offset == 0) {
                comparison.same(when + " player " + player + " has lost", lost, game.lost(player));
            } else {
                comparison.same(when + " player " + player + " is in", lost < 0, game.isIn(player));
            }
        }
    }

    private static TreeSet<Integer> remembered(Bodies bodies, int id) {
        TreeSet<Integer> found = new TreeSet<>();
        for (int k = 0; k < bodies.passing().size(); k++) {
            if (bodies.passing().first(k) == id) {
                found.add(bodies.passing().second(k));
            } else if (bodies.passing().second(k) == id) {
                found.add(bodies.passing().first(k));
            }
        }
        return found;
    }
}
