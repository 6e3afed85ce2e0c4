package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Lineups of a decision: the same bots on one seed, rotated so that each bot sits on every seat. */
final class Lineups {

    /** All ways to move these versions up by a place. */
    static List<int[]> rotations(int... versions) {
        List<int[]> lineups = new ArrayList<>();
        for (int by = 0; by < versions.length; by++) {
            int[] lineup = new int[versions.length];
            for (int seat = 0; seat < versions.length; seat++) {
                lineup[seat] = versions[(seat + by) % versions.length];
            }
            lineups.add(lineup);
        }
        return lineups;
    }

    /** The group of a decision; where each plays alone, none: all play. */
    static List<Integer> group(int players, int... versions) {
        return players == 1 ? List.of() : Arrays.stream(versions).sorted().boxed().toList();
    }
}
