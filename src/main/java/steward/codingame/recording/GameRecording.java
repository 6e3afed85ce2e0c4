package steward.codingame.recording;

import java.util.List;

/**
 * An official game of the pod race, as CodinGame's server recorded it: two players with two pods each.
 *
 * @param checkpoints {@code [n][x, y]}
 * @param start       before the first turn
 * @param first       the texts of frame 0
 * @param turns       in order
 * @param ranks       per player, 0 for the best; empty if not recorded
 * @param facts       what is told of the game beside
 */
record GameRecording(double[][] checkpoints, State start, ShownFrame first, List<Turn> turns, List<Integer> ranks,
                     GameFacts facts) {

    static final int PLAYERS = 2;
    static final int PODS_PER_PLAYER = 2;
    static final int PODS = PLAYERS * PODS_PER_PLAYER;

    /**
     * State between two turns, as far as it is known.
     *
     * @param pods     in order; empty if not recorded
     * @param counters per player; empty if not recorded
     */
    record State(List<Pod> pods, List<Counter> counters) {

        static final State UNKNOWN = new State(List.of(), List.of());
    }

    /**
     * One turn.
     *
     * @param frame    number of the key frame that ends it, for errors
     * @param commands per player the lines it wrote, possibly none or too few; {@code null} for a player that was not
     *                 asked any more
     * @param after    what the turn led to
     * @param impacts  in order; {@code null} if the recording tells nothing of impacts
     * @param frames   the texts of all frames of the turn
     */
    record Turn(int frame, List<List<String>> commands, State after, List<Impact> impacts, List<ShownFrame> frames) {

        /** True if no player said anything. */
        boolean isSilent() {
            return commands.stream().allMatch(lines -> lines == null || lines.isEmpty());
        }

        /** Returns the command to a pod, in words; none if nothing was said. */
        String[] command(int pod) {
            List<String> lines = commands.get(pod / PODS_PER_PLAYER);
            int line = pod % PODS_PER_PLAYER;
            return lines == null || line >= lines.size() ? new String[0] : lines.get(line).strip().split("\\s+");
        }
    }

    /**
     * A pod between two turns.
     *
     * @param heading        in radians, NaN while unset
     * @param shield         whether it was raised in the turn that led here
     * @param nextCheckpoint index of the next checkpoint
     */
    record Pod(double x, double y, double vx, double vy, double heading, boolean shield, int nextCheckpoint) { }

    /**
     * Counters of a player.
     *
     * @param rank      0 for the best
     * @param turnsLeft to pass a checkpoint
     */
    record Counter(int rank, int turnsLeft) { }

    /**
     * An impact.
     *
     * @param time    within the turn
     * @param a       the first pod
     * @param ax      its place at the impact, rounded
     * @param b       the second pod
     * @param impulse the whole impulse
     * @param meanVx  half the sum of the two speeds before the impact, rounded
     */
    record Impact(double time, int a, long ax, long ay, int b, long bx, long by, double impulse, long meanVx,
                  long meanVy) { }
}
