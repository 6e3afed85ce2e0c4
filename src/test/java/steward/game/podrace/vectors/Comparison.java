package steward.game.podrace.vectors;

import java.util.ArrayList;
import java.util.List;

/** Values held against recorded ones, to the last bit. */
final class Comparison {

    private static final int KEPT = 1000;

    private final String source;
    private final List<String> differences = new ArrayList<>();
    private long values;
    private long impacts;

    Comparison(String source) {
        this.source = source;
    }

    void same(String what, double recorded, double found) {
        values++;
        if (Double.doubleToLongBits(recorded) != Double.doubleToLongBits(found)) {
            differ(what, Double.toString(recorded), Double.toString(found));
        }
    }

    void same(String what, Object recorded, Object found) {
        values++;
        if (!recorded.equals(found)) {
            differ(what, recorded.toString(), found.toString());
        }
    }

    void impact() {
        impacts++;
    }

    private void differ(String what, String recorded, String found) {
        if (differences.size() < KEPT) {
            differences.add(source + " " + what + ": recorded " + recorded + ", found " + found);
        }
    }

    long values() {
        return values;
    }

    long impacts() {
        return impacts;
    }

    List<String> differences() {
        return differences;
    }
}
