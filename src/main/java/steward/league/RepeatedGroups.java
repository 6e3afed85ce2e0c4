package steward.league;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.contest.repeat.Repeats;

/**
 * Groups of bots that only repeat games: the last {@value steward.contest.repeat.Repeats#ENOUGH} games of a group, in
 * the order of decisions, equalled earlier ones. More games of such a group give no information. In a game for one
 * player, all bots are one group. An answer uses only games of decisions below a given number, so that it does not
 * depend on threads.
 *
 * <p>Not thread-safe.
 */
public final class RepeatedGroups {

    private final boolean alone;
    private final TreeMap<Integer, List<Game>> later = new TreeMap<>();
    private final Map<List<Integer>, Repeats> seen = new HashMap<>();
    private final Map<List<Integer>, Integer> inARow = new HashMap<>();

    private record Game(long transcript, int... lineup) { }

    /** @param alone true if each bot plays alone */
    public RepeatedGroups(boolean alone) {
        this.alone = alone;
    }

    /**
     * Adds a game that counts.
     *
     * @param transcript its digest; 0 if it is not known, or a bot draws by lot
     */
    public void add(int decision, long transcript, int... lineup) {
        later.computeIfAbsent(decision, number -> new ArrayList<>(2)).add(new Game(transcript, lineup.clone()));
    }

    /** Takes the games of decisions below a number, which is not less than in the call before. */
    void goTo(int decision) {
        while (!later.isEmpty() && later.firstKey() < decision) {
            later.pollFirstEntry().getValue().forEach(this::take);
        }
    }

    private void take(Game game) {
        List<Integer> lineup = Arrays.stream(game.lineup()).boxed().toList();
        boolean repeat = seen.computeIfAbsent(lineup, key -> new Repeats()).isRepeat(0, game.transcript());
        List<Integer> group = alone ? List.of() : lineup.stream().sorted().toList();
        inARow.merge(group, repeat ? 1 : 0, (before, one) -> one == 0 ? 0 : before + 1);
    }

    /** True if the games so far of these versions, ascending, have come to an end of what is new. */
    boolean isRepeated(int... group) {
        List<Integer> key = alone ? List.of() : Arrays.stream(group).boxed().toList();
        return inARow.getOrDefault(key, 0) >= Repeats.ENOUGH;
    }
}
