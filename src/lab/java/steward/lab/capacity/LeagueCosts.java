package steward.lab.capacity;

/**
 * Cost of a worker's game to the league's process: microseconds of CPU time in each part of it.
 *
 * @param broker   the broker and TLS: jobs out, leases, results in
 * @param messages the one thread that reads what workers say
 * @param check    playing the game again
 * @param again    asking the bots of one game again
 * @param share    of the games in which they are asked, 0..1
 * @param schedule the schedule and pairing, under a lock
 * @param store    the one thread that stores
 */
public record LeagueCosts(double broker, double messages, double check, double again, double share, double schedule,
                          double store) {

    /** All of them together, for a game on average. */
    public double total() {
        return broker + messages + check + share * again + schedule + store;
    }

    /** A part of the league's process that can be busy. */
    public enum Part {
        /** Its processors, which all parts share. */
        PROCESSORS("the processors"),
        /** The thread that reads what workers say. */
        MESSAGES("the thread that reads messages"),
        /** The lock of the schedule. */
        SCHEDULE("the schedule"),
        /** The thread that stores games. */
        STORE("the thread that stores"),
        /** How many games may be under way. */
        PLACES("the number of games under way"),
        /** Nothing: the workers are all busy. */
        WORKERS("the workers");

        private final String words;

        Part(String words) {
            this.words = words;
        }

        /** In words, with an article. */
        public String words() {
            return words;
        }
    }

    /**
     * Returns how many games in a second a part can take at most.
     *
     * @param processors of the league's machine
     */
    public double most(Part part, int processors) {
        return switch (part) {
            case PROCESSORS -> processors * 1e6 / total();
            case MESSAGES -> 1e6 / messages;
            case SCHEDULE -> 1e6 / schedule;
            case STORE -> 1e6 / store;
            default -> Double.POSITIVE_INFINITY;
        };
    }

    /** The part that is the first to have no time left when there are more and more games. */
    public Part first(int processors) {
        Part first = Part.PROCESSORS;
        for (Part part : Part.values()) {
            first = most(part, processors) < most(first, processors) ? part : first;
        }
        return first;
    }
}
