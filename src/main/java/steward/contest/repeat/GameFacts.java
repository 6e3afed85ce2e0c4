package steward.contest.repeat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import steward.game.Game;
import steward.replay.TranscriptDigest;

/**
 * Facts of one game that its result does not contain: how it went rather than how it ended.
 *
 * @param transcript digest of all commands and states, see {@link TranscriptDigest}; 0 if it is not known
 * @param values     the game's own values by player, see {@link Game#ownValues}; empty if they are not known
 * @param behindFrom by player, the turn from which on another was ahead to the end; empty if that was not looked at
 */
public record GameFacts(long transcript, List<SortedMap<String, Double>> values, List<Integer> behindFrom) {

    public static final GameFacts UNKNOWN = new GameFacts(0, List.of(), List.of());

    public GameFacts {
        values = List.copyOf(values);
        behindFrom = List.copyOf(behindFrom);
    }

    /** Returns these facts, and from which turn on each player was behind. */
    public GameFacts behind(List<Integer> turns) {
        return new GameFacts(transcript, values, turns);
    }

    /** Own values of a player; empty if they are not known. */
    public SortedMap<String, Double> values(int player) {
        return player < values.size() ? values.get(player) : Collections.emptySortedMap();
    }

    public static GameFacts of(Game game, TranscriptDigest digest) {
        List<SortedMap<String, Double>> values = new ArrayList<>();
        for (int player = 0; player < game.players(); player++) {
            SortedMap<String, Double> own = new TreeMap<>();
            for (Map.Entry<String, double[]> value : game.ownValues().entrySet()) {
                own.put(value.getKey(), value.getValue()[player]);
            }
            values.add(own);
        }
        return new GameFacts(digest.value(), values, List.of());
    }
}
