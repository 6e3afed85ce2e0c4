package steward.game.meanmax;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One match of the published referee, recorded turn by turn at full precision.
 *
 * @param name   of its file
 * @param header what was played
 * @param start  the state before the first turn
 * @param turns  one by one
 * @param end    how it ended
 */
record MeanMaxMatch(String name, JsonNode header, JsonNode start, List<JsonNode> turns, JsonNode end) {

    static MeanMaxMatch read(Path file) {
        List<JsonNode> lines = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            in.lines().forEach(line -> lines.add(JsonMapper.shared().readTree(line)));
        } catch (IOException problem) {
            throw new UncheckedIOException(file.toString(), problem);
        }
        return new MeanMaxMatch(file.getFileName().toString(), lines.get(0), lines.get(1).get("state"),
            lines.subList(2, lines.size() - 1), lines.get(lines.size() - 1));
    }

    /** The shipped scene, in the league of the match. */
    MeanMaxType.MeanMaxSetup setup() {
        String text = SceneFiles.load("mean-max").text();
        if (header.has("version")) {
            text = text.replace("\"winningScore\":", "\"version\": " + header.get("version") + ", \"winningScore\":");
        }
        return new MeanMaxType().open(SceneReader.read(text, name));
    }

    long seed() {
        return Long.parseLong(header.get("seed").asString());
    }

    boolean isInjected() {
        return header.get("injected").asBoolean();
    }

    /** A game in the state before the first turn; where it was not set by hand, as the seed gives it. */
    MeanMax begin() {
        MeanMax game = setup().create(seed());
        return isInjected() ? in(game, start) : game;
    }

    /** A game that goes on from a recorded state. */
    MeanMax in(MeanMax game, JsonNode state) {
        MeanMaxWorld world = MeanMaxWorld.empty(game.settings(), seed(), game.players(), state.get("units").size());
        for (JsonNode unit : state.get("units")) {
            boolean tanker = unit.get("type").asInt() == UnitKind.TANKER.ordinal();
            int body = world.addUnit(unit.get("id").asInt(), UnitKind.of(unit.get("type").asInt()),
                unit.get("player").asInt(), unit.get("radius").asDouble(), unit.get("mass").asDouble(),
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
            world.addEffect(effect.get("id").asInt(), skill(effect.get("type").asInt()), effect.get("x").asDouble(),
                effect.get("y").asDouble(), effect.get("duration").asInt(), effect.get("looter").asInt());
        }
        world.takeIdsUpTo(state.get("nextId").asInt());
        int[] scores = new int[game.players()];
        int[] rages = new int[game.players()];
        for (int player = 0; player < game.players(); player++) {
            scores[player] = state.get("scores").get(player).asInt();
            rages[player] = state.get("rages").get(player).asInt();
            while (world.queue().left(player) > state.get("tankersLeft").get(player).asInt()) {
                world.queue().take(player);
            }
        }
        return game.in(world, scores, rages);
    }

    static Skill skill(int type) {
        for (Skill skill : Skill.values()) {
            if (skill.type() == type) {
                return skill;
            }
        }
        throw new IllegalArgumentException("effect of type " + type);
    }
}
