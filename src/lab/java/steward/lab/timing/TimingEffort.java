package steward.lab.timing;

/**
 * Effort of a timing: rounds and durations.
 *
 * @param repeats    how many times everything is started anew: what a compiler makes of a loop differs from one JVM to
 *                   the next by more than rounds do
 * @param rounds     in each repeat; in a round each kind of work is measured once
 * @param round      seconds of a kind in a round, at least; all its different pieces once in any case
 * @param warmLeast  seconds that each kind runs before it is timed, at least
 * @param warmMost   seconds after which it is timed although its times are not steady
 */
public record TimingEffort(int repeats, int rounds, double round, double warmLeast, double warmMost) {

    /** Every figure that is stored or published. */
    public static final TimingEffort NORMAL = new TimingEffort(3, 7, 0.02, 0.3, 2);
    /** One JVM of each kind: a first look. */
    public static final TimingEffort QUICK = new TimingEffort(1, 5, 0.01, 0.2, 1);

    /** Returns how many steps of progress a timing of so many jobs makes. */
    public int steps(int jobs) {
        return repeats * (jobs + rounds);
    }
}
