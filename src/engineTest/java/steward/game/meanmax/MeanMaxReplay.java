package steward.game.meanmax;

import steward.game.VectorMatch;
import steward.game.VectorReplay;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;

/** A match of the published Mean Max referee, played again. */
public final class MeanMaxReplay extends VectorReplay<MeanMax> {

    public MeanMaxReplay(VectorMatch match) {
        super(match, setup(match));
    }

    /** The shipped scene, in the league of the match. */
    private static MeanMaxType.MeanMaxSetup setup(VectorMatch match) {
        String text = SceneFiles.load("mean-max").text();
        if (match.header().has("version")) {
            text = text.replace("\"winningScore\":", "\"version\": " + match.header().get("version")
                + ", \"winningScore\":");
        }
        return new MeanMaxType().open(SceneReader.read(text, match.name()));
    }

    @Override
    protected MeanMax create() {
        return ((MeanMaxType.MeanMaxSetup) setup).create(match.seed());
    }

    @Override
    protected Object score(MeanMax game, int player) {
        return game.score(player);
    }

    @Override
    protected MeanMax in(MeanMax game, JsonNode state) {
        MeanMaxWorld world = MeanMaxWorlds.empty(game.settings(), match.seed(), state.get("units").size());
        for (JsonNode unit : state.get("units")) {
            boolean tanker = unit.get("type").asInt() == UnitKind.TANKER.ordinal();
            int body = MeanMaxWorlds.addUnit(world, unit.get("id").asInt(),
                UnitKind.of(unit.get("type").asInt()), unit.get("player").asInt(), unit.get("radius").asDouble(),
                unit.get("mass").asDouble(),
                tanker ? unit.get("water").asInt() : 0, tanker ? unit.get("size").asInt() : 0);
            world.bodies().setPosition(body, unit.get("x").asDouble(), unit.get("y").asDouble());
            world.bodies().setVelocity(body, unit.get("vx").asDouble(), unit.get("vy").asDouble());
        }
        for (JsonNode wreck : state.get("wrecks")) {
            world.addWreck(wreck.get("id").asInt(), wreck.get("x").asDouble(), wreck.get("y").asDouble(),
                wreck.get("radius").asDouble(), wreck.get("water").asInt(),
                wreck.path("player").asInt(-1));
        }
        for (JsonNode effect : state.get("effects")) {
            world.insert(effect.get("id").asInt(), skill(effect.get("type").asInt()), effect.get("x").asDouble(),
                effect.get("y").asDouble(), effect.get("duration").asInt(), effect.get("looter").asInt());
        }
        MeanMaxWorlds.takeIdsUpTo(world, state.get("nextId").asInt());
        int[] scores = new int[game.players()];
        int[] rages = new int[game.players()];
        for (int player = 0; player < game.players(); player++) {
            scores[player] = state.get("scores").get(player).asInt();
            rages[player] = state.get("rages").get(player).asInt();
            while (world.queue().left(player) > state.get("tankersLeft").get(player).asInt()) {
                world.queue().take(player);
            }
        }
        MeanMax begun = MeanMaxWorlds.game(game, world, scores, rages);
        for (int player = 0; player < game.players(); player++) {
            if (state.get("dead").get(player).asBoolean()) {
                begun.eliminate(player, "out before");
            }
        }
        return begun;
    }

    static Skill skill(int type) {
        for (Skill skill : Skill.values()) {
            if (skill.type() == type) {
                return skill;
            }
        }
        throw new IllegalArgumentException("effect of type " + type);
    }

    @Override
    protected void compareStart(MeanMax game) {
        int size = 0;
        TankerQueue queue = game.world().queue().copy();
        for (JsonNode next : match.header().get("nextTankers")) {
            comparison.same("next tanker " + size, next.get(0).asInt(), queue.size(0));
            comparison.same("next tanker " + size++, next.get(1).asDouble(), queue.angle(0));
            queue.take(0);
        }
    }

    @Override
    protected boolean isFact(JsonNode of, TurnLog log, int fact) {
        return of.has("sunk");
    }

    @Override
    protected int compareFact(String what, JsonNode of, TurnLog log, int fact) {
        comparison.same(what + "sinks", Sinking.SUNK, log.factKind(fact));
        int[] two = {log.factA(fact), log.factB(fact)};
        comparison.same(what + "sunk", of.get("sunk").asInt(), two[0]);
        comparison.same(what + "a, b", of.get("a").asInt() + of.get("b").asInt(), two[0] + two[1]);
        comparison.same(what + "t", of.get("t").asDouble(), log.factTime(fact));
        boolean wreck = fact + 1 < log.facts() && log.factKind(fact + 1) == Sinking.WRECK;
        comparison.same(what + "wreck", of.get("wreck").asInt(), wreck ? log.factB(fact + 1) : -1);
        return wreck ? 2 : 1;
    }

    @Override
    protected void compareImpact(String what, JsonNode of, Impact impact) {
        comparison.fields(what, of, "t", impact.time(), "a", impact.a(), "b", impact.b());
        comparison.same(what + "vx of a", of.get("av").get(0).asDouble(), impact.vaxAfter());
        comparison.same(what + "vy of a", of.get("av").get(1).asDouble(), impact.vayAfter());
        if (!impact.isWall()) {
            comparison.same(what + "vx of b", of.get("bv").get(0).asDouble(), impact.vbxAfter());
            comparison.same(what + "vy of b", of.get("bv").get(1).asDouble(), impact.vbyAfter());
        }
    }

    @Override
    protected void compareState(String when, JsonNode state, MeanMax game) {
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
            comparison.fields(what, unit, "id", bodies.id(k), "type", bodies.kind[k],
                "player", bodies.columns[MeanMaxWorld.OWNER][k], "x", bodies.x[k], "y", bodies.y[k],
                "vx", bodies.vx[k], "vy", bodies.vy[k], "mass", bodies.mass[k], "radius", bodies.radius[k]);
            if (world.isTanker(k)) {
                comparison.same(what + "water", unit.get("water").asDouble(), bodies.columns[MeanMaxWorld.WATER][k]);
                comparison.same(what + "size", unit.get("size").asDouble(), bodies.columns[MeanMaxWorld.SIZE][k]);
            }
        }
        comparison.same(when + " wrecks", state.get("wrecks").size(), world.wrecks().size());
        for (int k = 0; k < Math.min(state.get("wrecks").size(), world.wrecks().size()); k++) {
            JsonNode of = state.get("wrecks").get(k);
            Wreck wreck = world.wrecks().get(k);
            comparison.fields(when + " wreck " + k + " ", of, "id", wreck.id(), "x", wreck.x(), "y", wreck.y(),
                "radius", wreck.radius(), "water", wreck.water());
            comparison.same(when + " wreck " + k + " player", of.path("player").asInt(-1), wreck.player());
        }
        comparison.same(when + " effects", state.get("effects").size(), world.effects().size());
        for (int k = 0; k < Math.min(state.get("effects").size(), world.effects().size()); k++) {
            JsonNode of = state.get("effects").get(k);
            SkillEffect effect = world.effects().get(k);
            comparison.fields(when + " effect " + k + " ", of, "id", effect.id(), "type", effect.skill().type(),
                "x", effect.x(), "y", effect.y(), "duration", effect.duration(), "looter", effect.looter());
        }
    }
}
