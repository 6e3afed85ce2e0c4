package steward.replay.verify;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
 */
public record Difference(int turn, String field, String recorded, String found) {

    private static final int SHOWN = 100;

    @Override
    public String toString() {
        return (turn == 0 ? "start" : "turn " + turn) + ", " + field + ": recorded "
            + TextFormat.beginning(recorded, SHOWN) + ", re-simulated " + TextFormat.beginning(found, SHOWN);
    }

    /**
     * The first difference between two JSON values whose bytes differ, in the order of fields. Numbers are compared as
     * they are written: two texts can mean the same double, but only one of them was recorded.
     */
    static Difference between(int turn, byte[] recorded, byte[] found) {
        List<Difference> differences = new ArrayList<>();
        new Comparer(turn, false, 1, differences).compare("", read(recorded), read(found));
        return !differences.isEmpty() ? differences.get(0)
            : new Difference(turn, "spelling", "other blanks, escapes or order", "the spelling of a fresh recording");
    }

    /**
     * Returns the first difference to a record of another referee's observations: fields that it does not have are
     * passed over, and an array that it says is empty may be left out. {@code null} if all that was recorded agrees.
     */
    static Difference fromObserved(int turn, byte[] recorded, byte[] found) {
        List<Difference> differences = new ArrayList<>();
        new Comparer(turn, true, 1, differences).compare("", read(recorded), read(found));
        return differences.isEmpty() ? null : differences.get(0);
    }

    /** All differences between two JSON values, whose path begins with {@code name}. */
    public static List<Difference> all(int turn, String name, byte[] recorded, byte[] found) {
        List<Difference> differences = new ArrayList<>();
        new Comparer(turn, false, Integer.MAX_VALUE, differences).compare(name, read(recorded), read(found));
        return differences;
    }

    /**
     * Walks two values side by side.
     *
     * @param observed whether fields that were not recorded are passed over
     * @param most     how many differences are collected
     */
    private record Comparer(int turn, boolean observed, int most, List<Difference> into) {

        void compare(String path, Object recorded, Object found) {
            if (into.size() >= most || observed && path.endsWith(ViewComparison.FRAMES)) {
                return;                                       // the texts of frames are compared word by word
            }
            if (recorded instanceof Map<?, ?> recordedFields && found instanceof Map<?, ?> foundFields) {
                if (observed && !isInOrder(recordedFields.keySet(), foundFields.keySet())) {
                    into.add(new Difference(turn, path.isEmpty() ? "order" : path, "the fields "
                        + recordedFields.keySet(), "the order " + foundFields.keySet()));
                    return;
                }
                Map<Object, Object> all = new LinkedHashMap<>(observed ? recordedFields : foundFields);
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
            } else if (!isLeftOut(path, recorded, found) && (recorded == null || !recorded.equals(found))) {
                into.add(new Difference(turn, path, shown(recorded), shown(found)));
            }
        }

        /** Another referee may record an empty array of impacts where this program leaves the field out. */
        private boolean isLeftOut(String path, Object recorded, Object found) {
            return observed && found == null && path.equals("impacts") && recorded instanceof List<?> none
                && none.isEmpty();
        }

        /** True if the fields that both have are in the same order. */
        private static boolean isInOrder(Set<?> recorded, Set<?> found) {
            List<Object> common = new ArrayList<>(found);
            common.retainAll(recorded);
            List<Object> seen = new ArrayList<>(recorded);
            seen.retainAll(found);
            return common.equals(seen);
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
