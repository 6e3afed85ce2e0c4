package steward.replay;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

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
     * The first difference between two JSON values, in the order of fields, or {@code null} if they say the same (only
     * their spelling differs).
     */
    static Difference between(int turn, byte[] recorded, byte[] found) {
        JsonMapper mapper = JsonMapper.shared();
        return between(turn, "", mapper.readTree(recorded), mapper.readTree(found));
    }

    private static Difference between(int turn, String path, JsonNode recorded, JsonNode found) {
        if (recorded.isObject() && found.isObject()) {
            for (String name : found.propertyNames()) {
                String field = path.isEmpty() ? name : path + "." + name;
                Difference inside = betweenFields(turn, field, recorded.get(name), found.get(name));
                if (inside != null) {
                    return inside;
                }
            }
            for (String name : recorded.propertyNames()) {
                if (found.get(name) == null) {
                    return betweenFields(turn, path.isEmpty() ? name : path + "." + name, recorded.get(name), null);
                }
            }
            return null;
        }
        if (recorded.isArray() && found.isArray()) {
            for (int k = 0; k < Math.max(recorded.size(), found.size()); k++) {
                Difference inside = betweenFields(turn, path + "[" + k + "]", recorded.get(k), found.get(k));
                if (inside != null) {
                    return inside;
                }
            }
            return null;
        }
        boolean same = recorded.isNumber() && found.isNumber()
            ? Double.doubleToLongBits(recorded.doubleValue()) == Double.doubleToLongBits(found.doubleValue())
            : recorded.equals(found);
        return same ? null : new Difference(turn, path, recorded.toString(), found.toString());
    }

    private static Difference betweenFields(int turn, String field, JsonNode recorded, JsonNode found) {
        if (recorded == null || found == null) {
            return new Difference(turn, field, recorded == null ? "nothing" : recorded.toString(),
                found == null ? "nothing" : found.toString());
        }
        return between(turn, field, recorded, found);
    }
}
