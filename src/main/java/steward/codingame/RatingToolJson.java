package steward.codingame;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import steward.match.MatchResult;
import steward.report.Fields;

/**
 * Result of a match as JSON for rating tools. Its fields are {@code ranks} (lower is better, ties share one),
 * {@code errors} (1 for a bot that failed), {@code faults} (the reason, or null), {@code test_data} (seed and data of
 * the match) and {@code player_data}, with numbers as numbers. {@code attributes} has all data once more: name, player
 * or null, turn or null, value as text.
 */
public final class RatingToolJson {

    private static final String SEED = "seed";
    private static final Pattern WHOLE = Pattern.compile("[-+]?\\d{1,18}");

    private RatingToolJson() { }

    /** @param faults by player, {@code null} for none */
    public static Fields of(long seed, MatchResult result, String[] faults, LeagueAttributes ofTurns) {
        Map<String, String> matchData = data(result.data());
        matchData.remove(SEED);
        return Fields.of("ranks", Fields.each(result.players(), MatchResult.PlayerResult::rank),
            "errors", Fields.each(result.players(), player -> player.fault() == null ? 0 : 1),
            "faults", Arrays.asList(faults), "test_data", Fields.of(SEED, seed).and(values(matchData)),
            "player_data", Fields.each(result.players(), player -> values(data(player.data()))),
            "attributes", attributes(matchData, result, ofTurns));
    }

    /** Data about single turns have a bracket where a name should begin; they are in the attributes. */
    private static Map<String, String> data(Map<String, String> reported) {
        Map<String, String> data = new TreeMap<>(reported);
        data.keySet().removeIf(name -> name.startsWith("["));
        return data;
    }

    /** Decimals stay texts: psyleague reads text right and truncates numbers. */
    private static Fields values(Map<String, String> data) {
        Fields values = Fields.of();
        data.forEach((name, value) -> values.with(name, WHOLE.matcher(value).matches() ? (Object) Long.valueOf(value)
            : value));
        return values;
    }

    private static Iterable<Object> attributes(Map<String, String> matchData, MatchResult result,
                                               LeagueAttributes ofTurns) {
        List<LeagueAttributes.Attribute> all = new ArrayList<>();
        matchData.forEach((name, value) -> all.add(new LeagueAttributes.Attribute(name, -1, -1, value)));
        for (int player = 0; player < result.players().size(); player++) {
            int number = player;
            data(result.players().get(player).data()).forEach((name, value) ->
                all.add(new LeagueAttributes.Attribute(name, number, -1, value)));
        }
        all.addAll(ofTurns.list());
        return Fields.each(all, each -> Fields.of("name", each.name(), "player", each.player() < 0 ? null
            : each.player(), "turn", each.turn() < 0 ? null : each.turn(), "value", each.value()));
    }
}
