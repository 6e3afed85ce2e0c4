package steward.cli.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import steward.cli.streams.Json;
import steward.match.MatchResult;
import steward.replay.ReplayReader;

/** Result of a match, read back from its replay. */
public final class RecordedResult {

    private RecordedResult() { }

    /**
     * Returns the result in the last line, or {@code null} if there is none; known at the end of the replay.
     *
     * @param names that the players go by
     */
    public static MatchResult of(ReplayReader replay, List<String> names) {
        if (replay.resultJson() == null) {
            return null;
        }
        Map<String, Object> line = Json.object(replay.resultJson());
        List<Map<?, ?>> standing = Json.objects(line.get("standing"));
        List<Map<?, ?>> said = Json.objects(line.get("players"));
        Map<?, ?> times = line.get("times") instanceof Map<?, ?> map ? map : Map.of();
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (int player = 0; player < names.size(); player++) {
            Map<?, ?> place = player < standing.size() ? standing.get(player) : Map.of();
            Map<?, ?> words = player < said.size() ? said.get(player) : Map.of();
            players.add(new MatchResult.PlayerResult(names.get(player),
                (int) Json.number(place.get("rank")), Json.number(place.get("score")), text(words.get("fault")),
                text(place.get("out")), 0, nanos(times.get("averageNanos"), player),
                nanos(times.get("worstNanos"), player), nanos(times.get("firstNanos"), player),
                (int) nanos(times.get("earlyTurns"), player), Map.of(),
                (int) nanos(times.get("heldFrom"), player)));
        }
        return new MatchResult((int) Json.number(line.get("turns")), replay.ending(), players);
    }

    private static String text(Object value) {
        return value instanceof String text ? text : null;
    }

    private static long nanos(Object list, int player) {
        return list instanceof List<?> all && player < all.size() ? (long) Json.number(all.get(player)) : 0;
    }
}
