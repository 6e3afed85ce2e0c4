package steward.game.pokerchiprace;

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
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.scene.Scene;
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
record PokerMatch(String name, JsonNode header, JsonNode start, List<JsonNode> turns, JsonNode end) {

    static PokerMatch read(Path file) {
        List<JsonNode> lines = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            in.lines().forEach(line -> lines.add(JsonMapper.shared().readTree(line)));
        } catch (IOException problem) {
            throw new UncheckedIOException(file.toString(), problem);
        }
        return new PokerMatch(file.getFileName().toString(), lines.get(0), lines.get(1).get("state"),
            lines.subList(2, lines.size() - 1), lines.get(lines.size() - 1));
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
    PokerChipRaceType.PokerChipRaceSetup setup() {
        JsonNode given = header.get("properties");
        StringBuilder fields = new StringBuilder();
        String[][] names = {{"max_neutral_count", "neutral"}, {"chips_count_per_player", "perPlayer"},
            {"player_initial_radius", "radius"}, {"symmetric", "symmetric"}};
        for (String[] name : names) {
            if (given.has(name[0])) {
                fields.append('"').append(name[1]).append("\": ").append(given.get(name[0]).asString()).append(", ");
            }
        }
        return setup(header.get("players").asInt(), fields.toString());
    }

    long seed() {
        return Long.parseLong(header.get("seed").asString());
    }

    /** A game in the state before the first turn; where it was not set by hand, as the seed gives it. */
    PokerChipRace begin() {
        PokerChipRace game = setup().create(seed());
        return header.get("injected").asBoolean() ? in(game, start) : game;
    }

    /** A game that goes on from a recorded state. */
    static PokerChipRace in(PokerChipRace game, JsonNode state) {
        ChipTable table = ChipTable.empty(game.players(), state.get("chips").size() + 200);
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
        return game.on(table, lost);
    }
}
