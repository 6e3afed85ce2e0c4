package steward.cli.play;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.cli.shared.FailureJson;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.CountedGame;
import steward.contest.Failure;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.match.MatchResult.PlayerResult;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/** Result of a match for programs: one JSON object on one line. */
final class MatchJson {

    private static final double NANOS_PER_MS = 1e6;

    static void print(Streams streams, Contest contest, long seed, CountedGame<?> game, Path file) {
        MatchResult result = game.result();
        printObject(streams, out -> {
            out.writeStringProperty("seed", Long.toString(seed));
            out.writeStringProperty("scene", contest.sceneName());
            out.writeStringProperty("time", contest.time().basis().word());
            out.writeStringProperty("sandbox", contest.sandbox());
            out.writeNumberProperty("turns", result.turns());
            out.writeStringProperty("ending", result.ending());
            JsonNumbers.writeOrNull(out, "winner", result.winner() < 0 ? Double.NaN : result.winner());
            out.writeBooleanProperty("allFailed", result.allFailed());
            JsonObject.writeAll(out, "players", result.players().size(), k -> {
                int player = k;
                writePlayer(out, result.players().get(k), contest.entrants().get(k),
                    game.failures().stream().filter(failure -> failure.player() == player).findFirst().orElse(null));
            });
            writeData(out, result.data());
            JsonObject.writeTexts(out, "playedAgain", game.again());
            out.writeStringProperty("replay", file == null ? null : file.toString());
        });
    }

    private static void writePlayer(JsonGenerator out, PlayerResult player, Contest.Entrant entrant, Failure failure) {
        out.writeStringProperty("name", player.name());
        out.writeStringProperty("bot", entrant.bot());
        out.writeStringProperty(OwnLimits.FIELD, OwnLimits.writtenOrNull(entrant.limits()));
        out.writeNumberProperty("rank", player.rank());
        JsonNumbers.write(out, "score", player.score());
        out.writeStringProperty("out", player.out());
        out.writeStringProperty("fault", player.fault());
        FailureJson.writeField(out, failure);
        out.writeObjectPropertyStart("answerMs");
        JsonNumbers.write(out, "average", player.averageNanos() / NANOS_PER_MS);
        JsonNumbers.write(out, "worst", player.worstNanos() / NANOS_PER_MS);
        JsonNumbers.write(out, "first", player.firstNanos() / NANOS_PER_MS);
        out.writeEndObject();
        out.writeName("heldFrom");
        writeTurn(out, player.heldFrom());
        JsonObject.writeTexts(out, "warnings", warnings(player));
        writeData(out, player.data());
    }

    /** A turn counted from 1; null for 0. */
    static void writeTurn(JsonGenerator out, int turn) {
        JsonNumbers.writeOrNull(out, turn == 0 ? Double.NaN : turn);
    }

    /** Writes the data that bots reported on stderr. */
    private static void writeData(JsonGenerator out, Map<String, String> data) {
        out.writeObjectPropertyStart("data");
        data.forEach(out::writeStringProperty);
        out.writeEndObject();
    }

    private static List<String> warnings(PlayerResult player) {
        List<String> warnings = new ArrayList<>();
        if (player.earlyTurns() > 0) {
            warnings.add("lines beyond the answer in " + TextFormat.count(player.earlyTurns(), "turn"));
        }
        return warnings;
    }

    /** One object with its line end. */
    static void printObject(Streams streams, Consumer<JsonGenerator> fields) {
        Json.print(streams, fields);
    }
}
