package steward.game.pokerchiprace;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import steward.game.TextCodec;
import steward.game.VectorMatch;
import steward.game.VectorReplay;
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;

/** A match of the published Poker Chip Race referee, played again. */
public final class PokerReplay extends VectorReplay<PokerChipRace> {

    private static final String[] SIDES = {"LEFT", "TOP", "RIGHT", "BOTTOM"};

    public PokerReplay(VectorMatch match) {
        super(match, setup(match));
    }

    /** The shipped scene with another number of players and more fields of its block {@code chips}. */
    static Scene scene(int players, String fields) {
        String text = SceneFiles.load("poker-chip-race").text().replace("\"players\": 2", "\"players\": " + players)
            .replace("\"chips\": { ", "\"chips\": { " + fields);
        return SceneReader.read(text, "poker-chip-race.json");
    }

    static PokerChipRaceType.PokerChipRaceSetup setup(int players, String fields) {
        return new PokerChipRaceType().open(scene(players, fields));
    }

    /** Returns the scene: the properties that were given to the referee are its fields. */
    private static PokerChipRaceType.PokerChipRaceSetup setup(VectorMatch match) {
        JsonNode given = match.header().get("properties");
        StringBuilder fields = new StringBuilder();
        String[][] names = {{"max_neutral_count", "neutral"}, {"chips_count_per_player", "perPlayer"},
            {"player_initial_radius", "radius"}, {"symmetric", "symmetric"}};
        for (String[] name : names) {
            if (given.has(name[0])) {
                fields.append('"').append(name[1]).append("\": ").append(given.get(name[0]).asString()).append(", ");
            }
        }
        return setup(match.header().get("players").asInt(), fields.toString());
    }

    @Override
    protected PokerChipRace create() {
        return ((PokerChipRaceType.PokerChipRaceSetup) setup).create(match.seed());
    }

    @Override
    protected Object score(PokerChipRace game, int player) {
        return game.score(player);
    }

    @Override
    protected PokerChipRace in(PokerChipRace game, JsonNode state) {
        ChipTable table = ChipTables.empty(game.players(), state.get("chips").size() + 200);
        for (JsonNode chip : state.get("chips")) {
            table.takeIdsUpTo(chip.get("id").asInt());
            table.add(chip.get("player").asInt(), chip.get("radius").asDouble(), chip.get("x").asDouble(),
                chip.get("y").asDouble(), chip.get("vx").asDouble(), chip.get("vy").asDouble());
            for (JsonNode other : chip.get("bounce")) {
                int low = Math.min(chip.get("id").asInt(), other.asInt());
                int high = Math.max(chip.get("id").asInt(), other.asInt());
                if (!table.bodies().passing().contains(low, high)) {
                    table.bodies().passing().add(low, high);
                }
            }
        }
        table.takeIdsUpTo(state.get("nextId").asInt());
        double[] lost = new double[game.players()];
        for (int player = 0; player < lost.length; player++) {
            lost[player] = state.get("owners").get(player).get("lostTime").asDouble();
        }
        return ChipTables.game((PokerChipRaceType.PokerChipRaceSetup) setup, table, lost);
    }

    /** The commands of a turn that was not played end the game in it. */
    @Override
    protected void compareEnd(PokerChipRace game) {
        JsonNode last = match.end().get("lastCommands");
        int played = game.turn();
        if (last != null) {
            comparison.same("end, is over before the last commands", false, game.isOver());
            answer("the last turn", last, null, false, game);
            if (!game.isOver()) {
                game.play();
            }
        }
        compareEnd(game, played);
    }

    @Override
    protected void compareTurn(String when, JsonNode turn, PokerChipRace game) {
        int born = game.bodies().nextId();
        super.compareTurn(when, turn, game);
        comparison.same(when + " pushes", turn.get("pushes").size(), game.bodies().nextId() - born);
        for (int k = 0; k < turn.get("pushes").size(); k++) {
            int chip = game.bodies().indexOf(born + k);
            if (chip >= 0 && game.bodies().columns[ChipTable.PARENT][chip] >= 0) {
                comparison.same(when + " push " + k, turn.get("pushes").get(k).asInt(),
                    (int) game.bodies().columns[ChipTable.PARENT][chip]);
            }
        }
    }

    @Override
    protected void compareAsked(String what, int player, TextCodec lines, PokerChipRace game) {
        comparison.same(what + "lines", Math.max(1, game.table().owned(player)), lines.answerLines(player));
    }

    /** Eaten ones, and the bounces of chips that are eaten already. */
    @Override
    protected boolean isFact(JsonNode of, TurnLog log, int fact) {
        return of.get("kind").asString().equals("eat") || areGhosts(of);
    }

    private static boolean areGhosts(JsonNode of) {
        return of.get("kind").asString().equals("bounce") && of.get("ra").asDouble() < 0;
    }

    @Override
    protected int compareFact(String what, JsonNode of, TurnLog log, int fact) {
        boolean ghosts = areGhosts(of);
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
        return 1;
    }

    @Override
    protected void compareImpact(String what, JsonNode of, Impact impact) {
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
        comparison.fields(what + "a: ", of.get("afterA"), "vx", impact.vaxAfter(), "vy", impact.vayAfter(),
            "x", impact.ax(), "y", impact.ay());
        comparison.fields(what + "b: ", of.get("afterB"), "vx", impact.vbxAfter(), "vy", impact.vbyAfter(),
            "x", impact.bx(), "y", impact.by());
    }

    /** When a player has lost is counted in turns from the start, so that it is compared where they are played. */
    @Override
    protected void compareState(String when, JsonNode state, PokerChipRace game) {
        Bodies bodies = game.bodies();
        comparison.same(when + " next id", state.get("nextId").asInt(), bodies.nextId());
        comparison.same(when + " chips", state.get("chips").size(), bodies.size());
        for (int k = 0; k < Math.min(state.get("chips").size(), bodies.size()); k++) {
            JsonNode chip = state.get("chips").get(k);
            String what = when + " chip " + k + " ";
            comparison.fields(what, chip, "id", bodies.id(k), "player", bodies.columns[ChipTable.OWNER][k],
                "x", bodies.x[k], "y", bodies.y[k], "vx", bodies.vx[k], "vy", bodies.vy[k],
                "radius", bodies.radius[k], "parent", bodies.columns[ChipTable.PARENT][k]);
            comparison.same(what + "remembers", new TreeSet<>(numbers(chip.get("bounce"))),
                remembered(bodies, bodies.id(k)));
        }
        for (int player = 0; player < game.players(); player++) {
            JsonNode owner = state.get("owners").get(player);
            List<Integer> left = numbers(owner.get("chips"));
            left.removeAll(numbers(owner.get("eaten")));
            List<Integer> own = new ArrayList<>();
            for (int k = 0; k < game.table().owned(player); k++) {
                own.add(game.table().ownId(player, k));
            }
            comparison.same(when + " chips of player " + player, left, own);
            double lost = owner.get("lostTime").asDouble();
            if (!when.endsWith(" alone")) {
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
