package steward.match;

/** Sums up one player's answer times. */
final class Stopwatch {

    private int answers;
    private long first;
    private long laterSum;
    private long laterWorst;

    void add(long nanos) {
        if (answers++ == 0) {
            first = nanos;
        } else {
            laterSum += nanos;
            laterWorst = Math.max(laterWorst, nanos);
        }
    }

    int answers() {
        return answers;
    }

    long firstNanos() {
        return first;
    }

    long averageNanos() {
        return answers > 1 ? laterSum / (answers - 1) : first;
    }

    long worstNanos() {
        return answers > 1 ? laterWorst : first;
    }
}
