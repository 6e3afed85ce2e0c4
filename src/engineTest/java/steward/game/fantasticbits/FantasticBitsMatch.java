package steward.game.fantasticbits;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import steward.game.fantasticbits.protocol.FantasticBitsType;
import steward.physics.Bodies;
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
record FantasticBitsMatch(String name, JsonNode header, JsonNode start, List<JsonNode> turns, JsonNode end) {

    static FantasticBitsMatch read(Path file) {
        List<JsonNode> lines = new ArrayList<>();
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            in.lines().forEach(line -> lines.add(JsonMapper.shared().readTree(line)));
        } catch (IOException problem) {
            throw new UncheckedIOException(file.toString(), problem);
        }
        return new FantasticBitsMatch(file.getFileName().toString(), lines.get(0), lines.get(1).get("state"),
            lines.subList(2, lines.size() - 1), lines.get(lines.size() - 1));
    }

    private static final FantasticBitsType.FantasticBitsSetup PUZZLE = open("fantastic-bits");
    private static final FantasticBitsType.FantasticBitsSetup CONTEST = open("fantastic-bits-contest");

    private static FantasticBitsType.FantasticBitsSetup open(String scene) {
        return new FantasticBitsType().open(SceneReader.read(SceneFiles.load(scene), null));
    }

    static FantasticBitsType.FantasticBitsSetup setup(Variant variant) {
        return variant == Variant.PUZZLE ? PUZZLE : CONTEST;
    }

    /** The shipped scene, in the league of the match. */
    FantasticBitsType.FantasticBitsSetup setup() {
        Variant variant = Variant.valueOf(header.get("variant").asString().toUpperCase(Locale.ROOT));
        if (!header.has("spells")) {
            return setup(variant);
        }
        String text = setup(variant).scene().json().replace("\"maximumTurns\":", "\"spells\":" + header.get("spells")
            + ",\"bludgers\":" + header.get("bludgers") + ",\"maximumTurns\":");
        return new FantasticBitsType().open(SceneReader.read(text, name));
    }

    long seed() {
        return Long.parseLong(header.get("seed").asString());
    }

    /** A game in the state before the first turn; where it was not set by hand, as the seed gives it. */
    FantasticBits begin() {
        FantasticBits game = setup().create(seed());
        return header.get("injected").asBoolean() ? in(game, start) : game;
    }

    /** A game that goes on from a recorded state. */
    static FantasticBits in(FantasticBits game, JsonNode state) {
        Pitch pitch = new Pitch(state.get("snaffles").size(), state.get("bludgers").size());
        Bodies bodies = pitch.bodies();
        for (JsonNode wizard : state.get("wizards")) {
            int self = move(bodies, wizard);
            bodies.columns[Pitch.HELD][self] = wizard.get("snaffle").asInt();
            bodies.columns[Pitch.WAIT][self] = wizard.get("captureWait").asInt();
            for (Spell spell : Spell.values()) {
                pitch.spells().set(self, spell, wizard.get(spell.text()).get(0).asInt(),
                    wizard.get(spell.text()).get(1).asInt());
            }
            JsonNode cast = wizard.get("cast");
            if (!cast.isNull()) {
                pitch.spells().cast(self, Spell.valueOf(cast.get(0).asString().toUpperCase(Locale.ROOT)),
                    cast.get(1).asInt());
            }
        }
        for (JsonNode snaffle : state.get("snaffles")) {
            int self = move(bodies, snaffle);
            bodies.setKind(self, (!snaffle.get("alive").asBoolean() ? EntityKind.LOST_SNAFFLE
                : snaffle.get("captured").asBoolean() ? EntityKind.HELD_SNAFFLE : EntityKind.SNAFFLE).ordinal());
            snaffle.get("ignores").forEach(other -> Pitch.ignore(bodies, self, other.asInt()));
        }
        for (JsonNode bludger : state.get("bludgers")) {
            bodies.columns[Pitch.LAST_VICTIM][move(bodies, bludger)] = bludger.get("lastVictim").asInt();
        }
        int[] scores = new int[2];
        int[] magic = new int[2];
        for (int player = 0; player < 2; player++) {
            scores[player] = state.get("scores").get(player).asInt();
            magic[player] = state.get("magic").get(player).asInt();
        }
        return game.on(pitch, scores, magic);
    }

    private static int move(Bodies bodies, JsonNode entity) {
        int self = entity.get("id").asInt();
        bodies.setPosition(self, entity.get("x").asDouble(), entity.get("y").asDouble());
        bodies.setVelocity(self, entity.get("vx").asDouble(), entity.get("vy").asDouble());
        return self;
    }
}
