package steward.match;

/** Sum and maximum of one player's answer times, in nanoseconds. */
public final class Stopwatch {

    private int answers;
    private long first;
    private long laterSum;
    private long laterWorst;

    /** Adds an answer's time. */
    public void add(long nanos) {
        if (answers++ == 0) {
            first = nanos;
        } else {
            laterSum += nanos;
            laterWorst = Math.max(laterWorst, nanos);
        }
    }

    /** Returns how many answers were added. */
    public int answers() {
        return answers;
    }

    /** The time of the first answer, which includes a process's start. */
    public long firstNanos() {
        return first;
    }

    /** The mean time, the first answer left out when there are more. */
    public long averageNanos() {
        return answers > 1 ? laterSum / (answers - 1) : first;
    }

    /** The longest time, likewise. */
    public long worstNanos() {
        return answers > 1 ? laterWorst : first;
    }
}
