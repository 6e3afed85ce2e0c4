package steward.game.pokerchiprace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import steward.game.ServerView;
import steward.game.ShownSeed;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRaceSettings;
import steward.json.JsonObject;
import steward.scene.SceneFiles;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/**
 * A game of the Poker Chip Race as the views of the server show it:
 * <pre>
 * line 0      the number of the frame
 * frame 0     PokerChipRace, then players, width, height, most turns
 * then        how many chips there are, and a line for each
 * a chip      id owner radius x y rotation points     places from the corner; radius -1.00: eaten in this turn
 *             and t x y radius rotation other         for each of the points, then its message
 * then        an area per player and of all chips; a score per player
 * </pre>
 * The input of the server's referee, {@code refereeInput}, has a line {@code seed=} and the settings of the start.
 */
final class PokerChipRaceShown implements ServerView.Shown {

    private static final String SCENE = "poker-chip-race";
    private static final Map<String, String> SETTINGS = Map.of("player_initial_radius", "radius",
        "chips_count_per_player", "perPlayer", "symmetric", "symmetric", "max_neutral_count", "neutral");
    private static final String VALUE = "-?[0-9]{1,18}(\\.[0-9]{1,9})?|true|false";
    private static final int SIZES_LINE = 2;
    private static final int SIZES = 4;
    private static final int FIRST_LINE_OF_START = 3;
    private static final int CHIP_WORDS = 7;
    private static final int POINT_WORDS = 6;
    private static final int MOST = 1_000_000;

    private final int players;
    private final StringBuilder fields = new StringBuilder();
    private final long seed;
    private final Turn start;
    private final List<Turn> shown = new ArrayList<>();

    /** Chips on the table, and scores. */
    private record Turn(List<PokerChipRaceView.Chip> chips, int[] scores) { }

    PokerChipRaceShown(ViewLines first, String input) {
        String[] sizes = first.words(SIZES_LINE);
        if (sizes.length != SIZES) {
            throw first.wrong(SIZES_LINE, "players, width, height and the most turns");
        }
        players = first.whole(sizes[0], PokerChipRaceSettings.MOST_PLAYERS, SIZES_LINE);
        readInput(first.source(), input);
        seed = ShownSeed.required(input, first.source());
        start = read(first, FIRST_LINE_OF_START);
    }

    private void readInput(String source, String input) {
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
    }

    /** The shipped scene, with what the server's referee was given. */
    @Override
    public String scene() {
        return SceneFiles.load(SCENE).text().replaceFirst("\"players\": [0-9]+", "\"players\": " + players)
            .replaceFirst("\"maximumTurns\": [0-9]+", "$0" + fields);
    }

    @Override
    public long seed() {
        return seed;
    }

    @Override
    public void add(ViewLines view) {
        shown.add(view.count() == 0 ? null : read(view, 1));
    }

    private Turn read(ViewLines view, int first) {
        String[] counts = view.words(first);
        if (counts.length != 1) {
            throw view.wrong(first, "how many chips there are");
        }
        int behind = first + 1 + view.whole(counts[0], MOST, first);
        List<PokerChipRaceView.Chip> chips = new ArrayList<>();
        for (int line = first + 1; line < behind; line++) {
            readChip(view, line, chips);
        }
        if (view.words(behind).length != players + 1) {
            throw view.wrong(behind, "the areas of " + players + " players and of all chips");
        }
        String[] words = view.words(behind + 1);
        if (words.length != players) {
            throw view.wrong(behind + 1, "the scores of " + players + " players");
        }
        int[] scores = new int[players];
        for (int player = 0; player < players; player++) {
            scores[player] = view.whole(words[player], MOST, behind + 1);
        }
        return new Turn(chips, scores);
    }

    /** A chip that was eaten in this turn is shown with a radius below 0, and is no longer there. */
    private void readChip(ViewLines view, int line, List<PokerChipRaceView.Chip> chips) {
        String[] words = view.words(line);
        if (words.length < CHIP_WORDS
            || words.length < CHIP_WORDS + POINT_WORDS * view.whole(words[CHIP_WORDS - 1], MOST, line)) {
            throw view.wrong(line, "id owner radius x y rotation points, and six words for each point, perhaps a "
                + "message");
        }
        int owner = words[1].equals(Integer.toString(ChipTable.NEUTRAL)) ? ChipTable.NEUTRAL
            : view.whole(words[1], players - 1, line);
        double radius = view.number(words[2], line);
        if (radius >= 0) {
            chips.add(new PokerChipRaceView.Chip(view.whole(words[0], MOST, line), owner, radius,
                view.number(words[3], line),
                view.number(words[4], line)));
        }
    }

    @Override
    public void writeStart(JsonGenerator out) {
        writeChips(out, start);
    }

    private static void writeChips(JsonGenerator out, Turn turn) {
        JsonObject.writeEach(out, "bodies", turn.chips, chip -> PokerChipRaceView.write(out, chip));
    }

    @Override
    public void writeOutcome(JsonGenerator out, int number) {
        Turn turn = shown.get(number - 1);
        if (turn == null) {
            return;
        }
        out.writeName("scores");
        out.writeArray(turn.scores, 0, turn.scores.length);
        out.writeObjectPropertyStart("state");
        writeChips(out, turn);
        out.writeEndObject();
    }
}
