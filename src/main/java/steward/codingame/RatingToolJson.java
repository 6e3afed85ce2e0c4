package steward.codingame;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import steward.json.JsonObject;
import steward.match.MatchResult;
import tools.jackson.core.JsonGenerator;

/**
 * Result of a match as JSON for rating tools. Its fields are {@code ranks} (lower is better, ties share one),
 * {@code errors} (1 for a bot that failed), {@code faults} (the reason, or null), {@code test_data} (seed and data of
 * the match) and {@code player_data}, with numbers as numbers. {@code attributes} has all data once more: name, player
 * or null, turn or null, value as text.
 */
public final class RatingToolJson {

    private static final String SEED = "seed";
    private static final Pattern WHOLE = Pattern.compile("[-+]?\\d{1,18}");

    private RatingToolJson() { }

    /**
     * Fields of the object, which the caller has opened and closes.
     *
     * @param faults by player, {@code null} for none
     */
    public static void write(JsonGenerator out, long seed, MatchResult result, String[] faults,
                             LeagueAttributes ofTurns) {
        JsonObject.writeEach(out, "ranks", result.players(), player -> out.writeNumber(player.rank()));
        JsonObject.writeEach(out, "errors", result.players(), player ->
            out.writeNumber(player.fault() == null ? 0 : 1));
        Map<String, String> matchData = data(result.data());
        matchData.remove(SEED);
        JsonObject.writeTexts(out, "faults", Arrays.asList(faults));
        out.writeObjectPropertyStart("test_data");
        out.writeNumberProperty(SEED, seed);
        matchData.forEach((name, value) -> writeValue(out, name, value));
        out.writeEndObject();
        JsonObject.writeAll(out, "player_data", result.players(),
            player -> data(player.data()).forEach((name, value) -> writeValue(out, name, value)));
        writeAttributes(out, matchData, result, ofTurns);
    }

    /** Data about single turns have a bracket where a name should begin; they are in the attributes. */
    private static Map<String, String> data(Map<String, String> reported) {
        Map<String, String> data = new TreeMap<>(reported);
        data.keySet().removeIf(name -> name.startsWith("["));
        return data;
    }

    private static void writeValue(JsonGenerator out, String name, String value) {
        out.writeName(name);
        if (WHOLE.matcher(value).matches()) {
            out.writeNumber(Long.parseLong(value));
        } else {
            out.writeString(value);                   // decimals too: psyleague reads text right and truncates numbers
        }
    }

    private static void writeAttributes(JsonGenerator out, Map<String, String> matchData, MatchResult result,
                                        LeagueAttributes ofTurns) {
        out.writeArrayPropertyStart("attributes");
        matchData.forEach((name, value) -> write(out, new LeagueAttributes.Attribute(name, -1, -1, value)));
        for (int player = 0; player < result.players().size(); player++) {
            int number = player;
            data(result.players().get(player).data()).forEach((name, value) ->
                write(out, new LeagueAttributes.Attribute(name, number, -1, value)));
        }
        ofTurns.list().forEach(attribute -> write(out, attribute));
        out.writeEndArray();
    }

    private static void write(JsonGenerator out, LeagueAttributes.Attribute attribute) {
        out.writeStartObject();
        out.writeStringProperty("name", attribute.name());
        writeOrNull(out, "player", attribute.player());
        writeOrNull(out, "turn", attribute.turn());
        out.writeStringProperty("value", attribute.value());
        out.writeEndObject();
    }

    private static void writeOrNull(JsonGenerator out, String name, int number) {
        if (number < 0) {
            out.writeNullProperty(name);
        } else {
            out.writeNumberProperty(name, number);
        }
    }
}
