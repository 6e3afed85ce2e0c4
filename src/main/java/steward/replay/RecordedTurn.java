package steward.replay;

import steward.game.JsonNumbers;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * One turn as it was recorded.
 *
 * @param number    counted from 1
 * @param commands  the array of commands, one per player or null, as JSON
 * @param faults    per player why it failed in this turn, or null
 * @param inputHash a hash of commands and faults
 * @param outcome   impacts, paths, events, state and hash, as JSON
 * @param messages  per player, or null
 * @param stderr    per player what it wrote, or null
 * @param times     the measured part as JSON, or null if absent
 * @param where     file and line, for errors
 */
public record RecordedTurn(int number, byte[] commands, String[] faults, String inputHash, byte[] outcome,
                           String[] messages, String[] stderr, byte[] times, String where) {

    static RecordedTurn of(JsonLine line, int players) {
        return new RecordedTurn(line.integer("turn"), line.array("commands"), line.texts("faults", players),
            line.text("inputHash"), line.object("outcome"), line.texts("messages", players),
            line.texts("stderr", players), line.has("times") ? line.object("times") : null, line.where());
    }

    /** Whether a command of the player was recorded. */
    public boolean hasCommand(int player) {
        try (JsonParser in = parser(commands)) {
            in.nextToken();
            JsonToken token = in.nextToken();
            for (int k = 0; k < player && token != JsonToken.END_ARRAY; k++) {
                in.skipChildren();
                token = in.nextToken();
            }
            return token != JsonToken.END_ARRAY && token != JsonToken.VALUE_NULL;
        }
    }

    /** How long the player took, in nanoseconds; 0 if that was not recorded. */
    public long nanos(int player) {
        if (times == null) {
            return 0;
        }
        JsonLine line = new JsonLine(where, times);
        if (!line.has("answerNanos")) {
            return 0;
        }
        try (JsonParser in = parser(line.array("answerNanos"))) {
            in.nextToken();
            JsonToken token = in.nextToken();
            for (int k = 0; k < player && token != JsonToken.END_ARRAY; k++) {
                token = in.nextToken();
            }
            return token == JsonToken.VALUE_NUMBER_INT ? in.getLongValue() : 0;
        }
    }

    public static JsonParser parser(byte[] json) {
        return JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length);
    }
}
