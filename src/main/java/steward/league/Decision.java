package steward.league;

import java.util.List;
import java.util.Map;

/**
 * A decision of the schedule: which group of bots plays on one seed, with every bot on every seat.
 *
 * @param number from 0 on
 * @param group  the versions, ascending; where each plays alone, all that did at the time
 * @param paused those that were not chosen among, ascending
 */
public record Decision(int number, long seed, List<Integer> group, List<Integer> paused) {

    public Decision {
        group = List.copyOf(group);
        paused = List.copyOf(paused);
    }

    /**
     * News of a schedule, to be stored before a game of it begins.
     *
     * @param made    in their order
     * @param dropped by number, whether games of a decision are missing that are not to be played, since a bot of it
     *                has changed or plays no more
     */
    public record News(List<Decision> made, Map<Integer, Boolean> dropped) {

        public static final News NONE = new News(List.of(), Map.of());

        public News {
            made = List.copyOf(made);
            dropped = Map.copyOf(dropped);
        }

        public boolean isEmpty() {
            return made.isEmpty() && dropped.isEmpty();
        }
    }
}
