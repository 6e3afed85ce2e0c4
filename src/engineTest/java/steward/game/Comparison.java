package steward.game;

import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;

/** Values held against recorded ones, to the last bit. */
public final class Comparison {

    private static final int KEPT = 1000;

    private final String source;
    private final List<String> differences = new ArrayList<>();
    private long values;
    private long impacts;

    public Comparison(String source) {
        this.source = source;
    }

    public void same(String what, double recorded, double found) {
        values++;
        if (Double.doubleToLongBits(recorded) != Double.doubleToLongBits(found)) {
            differ(what, Double.toString(recorded), Double.toString(found));
        }
    }

    public void same(String what, Object recorded, Object found) {
        values++;
        if (!recorded.equals(found)) {
            differ(what, recorded.toString(), found.toString());
        }
    }

    /** @param found names of the recorded object's fields, each with what was found */
    public void fields(String what, JsonNode recorded, Object... found) {
        for (int k = 0; k < found.length; k += 2) {
            JsonNode field = recorded.get((String) found[k]);
            Object value = found[k + 1];
            if (value instanceof Double number) {
                same(what + found[k], field.asDouble(), number.doubleValue());
            } else {
                same(what + found[k], value instanceof Boolean ? (Object) field.asBoolean() : field.asInt(), value);
            }
        }
    }

    public void impact() {
        impacts++;
    }

    private void differ(String what, String recorded, String found) {
        if (differences.size() < KEPT) {
            differences.add(source + " " + what + ": recorded " + recorded + ", found " + found);
        }
    }

    public long values() {
        return values;
    }

    public long impacts() {
        return impacts;
    }

    public List<String> differences() {
        return differences;
    }
}
