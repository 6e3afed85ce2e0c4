package steward.replay;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.game.JsonNumbers;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Where a recorded match and its re-simulation first differ.
 *
 * @param turn     counted from 1; 0 is the start, before the first turn
 * @param field    path of the field, such as {@code state.bodies[2].x}
 * @param recorded what the replay says
 * @param found    what the re-simulation gives
 */
public record Difference(int turn, String field, String recorded, String found) {

    private static final int SHOWN = 100;

    @Override
    public String toString() {
        return (turn == 0 ? "start" : "turn " + turn) + ", " + field + ": recorded " + shorten(recorded)
            + ", re-simulated " + shorten(found);
    }

    private static String shorten(String text) {
        return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "...";
    }

    /**
     * The first difference between two JSON values whose bytes differ, in the order of fields. Numbers are compared as
     * they are written: two texts can mean the same double, but only one of them was recorded.
     */
    static Difference between(int turn, byte[] recorded, byte[] found) {
        Difference difference = between(turn, "", read(recorded), read(found), false);
        return difference != null ? difference
            : new Difference(turn, "spelling", "other blanks, escapes or order", "the spelling of a fresh recording");
    }

    /**
     * The same for a record of what another referee saw: fields that it does not have are passed over, and an array
     * that it says is empty may be left out. {@code null} if all that was recorded agrees.
     */
    static Difference fromObserved(int turn, byte[] recorded, byte[] found) {
        return between(turn, "", read(recorded), read(found), true);
    }

    private static Difference between(int turn, String path, Object recorded, Object found, boolean observed) {
        if (recorded instanceof Map<?, ?> recordedFields && found instanceof Map<?, ?> foundFields) {
            Map<Object, Object> all = new LinkedHashMap<>(observed ? recordedFields : foundFields);
            recordedFields.forEach(all::putIfAbsent);
            for (Object name : all.keySet()) {
                Difference inside = between(turn, path.isEmpty() ? name.toString() : path + "." + name,
                    recordedFields.get(name), foundFields.get(name), observed);
                if (inside != null) {
                    return inside;
                }
            }
            return null;
        }
        if (recorded instanceof List<?> recordedValues && found instanceof List<?> foundValues) {
            for (int k = 0; k < Math.max(recordedValues.size(), foundValues.size()); k++) {
                Difference inside = between(turn, path + "[" + k + "]",
                    k < recordedValues.size() ? recordedValues.get(k) : null,
                    k < foundValues.size() ? foundValues.get(k) : null, observed);
                if (inside != null) {
                    return inside;
                }
            }
            return null;
        }
        if (observed && found == null && recorded instanceof List<?> none && none.isEmpty()) {
            return null;
        }
        return recorded != null && recorded.equals(found) ? null
            : new Difference(turn, path, shown(recorded), shown(found));
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
