package steward.replay.verify;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.json.JsonNumbers;
import steward.text.TextFormat;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * First place where a recorded match and its re-simulation differ.
 *
 * @param turn     counted from 1; 0 is the start, before the first turn
 * @param field    path of the field, such as {@code state.bodies[2].x}
 * @param recorded what the replay says
 * @param found    what the re-simulation gives
 * @param lines    of a server's text and of ours in which they stand, or {@code null}
 */
public record ReplayDifference(int turn, String field, String recorded, String found, Lines lines) {

    private static final int SHOWN = 100;

    /** Lines of a server's text and of ours in which a word differs. */
    public record Lines(String server, String ours) { }

    /** A difference that is in no text of a server. */
    public ReplayDifference(int turn, String field, String recorded, String found) {
        this(turn, field, recorded, found, null);
    }

    @Override
    public String toString() {
        return (turn == 0 ? "start" : "turn " + turn) + ", " + field + ": recorded "
            + TextFormat.beginning(recorded, SHOWN) + ", re-simulated " + TextFormat.beginning(found, SHOWN);
    }

    /**
     * The first difference between two JSON values whose bytes differ, in the order of fields. Numbers are compared as
     * they are written: two texts can mean the same double, but only one of them was recorded.
     */
    static ReplayDifference between(int turn, byte[] recorded, byte[] found) {
        List<ReplayDifference> differences = new ArrayList<>();
        new Comparer(turn, 1, differences).compare("", read(recorded), read(found));
        return !differences.isEmpty() ? differences.get(0)
            : new ReplayDifference(turn, "spelling", "other blanks, escapes or order",
                "the spelling of a fresh recording");
    }

    /** All differences between two JSON values, whose path begins with {@code name}. */
    public static List<ReplayDifference> all(int turn, String name, byte[] recorded, byte[] found) {
        List<ReplayDifference> differences = new ArrayList<>();
        new Comparer(turn, Integer.MAX_VALUE, differences).compare(name, read(recorded), read(found));
        return differences;
    }

    /**
     * Walks two values side by side.
     *
     * @param most how many differences are collected
     */
    private record Comparer(int turn, int most, List<ReplayDifference> into) {

        void compare(String path, Object recorded, Object found) {
            if (into.size() >= most) {
                return;
            }
            if (recorded instanceof Map<?, ?> recordedFields && found instanceof Map<?, ?> foundFields) {
                Map<Object, Object> all = new LinkedHashMap<>(foundFields);
                recordedFields.forEach(all::putIfAbsent);
                for (Object name : all.keySet()) {
                    compare(path.isEmpty() ? name.toString() : path + "." + name, recordedFields.get(name),
                        foundFields.get(name));
                }
            } else if (recorded instanceof List<?> recordedValues && found instanceof List<?> foundValues) {
                for (int k = 0; k < Math.max(recordedValues.size(), foundValues.size()); k++) {
                    compare(path + "[" + k + "]", k < recordedValues.size() ? recordedValues.get(k) : null,
                        k < foundValues.size() ? foundValues.get(k) : null);
                }
            } else if (recorded == null || !recorded.equals(found)) {
                into.add(new ReplayDifference(turn, path, shown(recorded), shown(found)));
            }
        }
    }

    private static String shown(Object value) {
        if (value instanceof List<?> values) {
            return "an array of " + values.size();
        }
        return value == null ? "nothing" : value instanceof Map ? "an object" : value.toString();
    }

    /** A map, a list, or the text of a scalar, strings in quotes. */
    private static Object read(byte[] json) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length)) {
            return read(in, in.nextToken());
        }
    }

    private static Object read(JsonParser in, JsonToken first) {
        switch (first) {
            case START_OBJECT -> {
                Map<String, Object> fields = new LinkedHashMap<>();
                while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                    String name = in.currentName();
                    fields.put(name, read(in, in.nextToken()));
                }
                return fields;
            }
            case START_ARRAY -> {
                List<Object> values = new ArrayList<>();
                for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
                    values.add(read(in, token));
                }
                return values;
            }
            case VALUE_STRING -> {
                return '"' + in.getString() + '"';
            }
            default -> {
                return in.getString();
            }
        }
    }
}
