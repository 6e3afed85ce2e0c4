package steward.game.pokerchiprace.protocol;

import java.util.Map;
import steward.game.ServerView;
import steward.game.ShownSeed;
import steward.game.pokerchiprace.PokerChipRaceSettings;
import steward.scene.SceneFiles;
import steward.text.ViewLines;

/**
 * Reader of scene and seed of a Poker Chip Race from a server's recording. The first view has the number of players,
 * {@code refereeInput} a line {@code seed=} and the settings of the start.
 */
final class PokerChipRaceView implements ServerView {

    static final String TITLE = "PokerChipRace";

    private static final Map<String, String> SETTINGS = Map.of("player_initial_radius", "radius",
        "chips_count_per_player", "perPlayer", "symmetric", "symmetric", "max_neutral_count", "neutral");
    private static final String VALUE = "-?[0-9]{1,18}(\\.[0-9]{1,9})?|true|false";
    private static final int SIZES_LINE = 2;
    private static final int SIZES = 4;

    @Override
    public String title() {
        return TITLE;
    }

    @Override
    public Start open(ViewLines first, String input) {
        String[] sizes = first.words(SIZES_LINE);
        if (sizes.length != SIZES) {
            throw first.wrong(SIZES_LINE, "players, width, height and the most turns");
        }
        int players = first.whole(sizes[0], PokerChipRaceSettings.MOST_PLAYERS, SIZES_LINE);
        String scene = SceneFiles.load("poker-chip-race").text().replaceFirst("\"players\": [0-9]+",
            "\"players\": " + players).replaceFirst("\"maximumTurns\": [0-9]+", "$0" + fields(first.source(), input));
        return new Start(scene, ShownSeed.required(input, first.source()));
    }

    private static String fields(String source, String input) {
        StringBuilder fields = new StringBuilder();
        for (String line : input.strip().lines().toList()) {
            String[] property = line.strip().split("=", 2);
            String value = property.length < 2 ? "" : property[1];
            if (SETTINGS.containsKey(property[0]) && value.matches(VALUE)) {
                fields.append(", \"").append(SETTINGS.get(property[0])).append("\": ").append(value);
            } else if (ShownSeed.of(line).isEmpty()) {
                throw new IllegalArgumentException(source + ": refereeInput: found " + ViewLines.quote(line)
                    + ", expected seed=NUMBER or a setting of the start with its value");
            }
        }
        return fields.toString();
    }
}
