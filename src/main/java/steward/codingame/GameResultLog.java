package steward.codingame;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.GameJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.report.Fields;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.ObjectWriteContext;

/**
 * Log of a match, written as one JSON object with the field names of CodinGame's own game result, for tools that read
 * it. Lists have one entry for the start and one for each turn, {@code null} if there is nothing:
 *
 * <ul>
 * <li>{@code errors}, {@code outputs}: what {@code "referee"}, {@code "0"}, {@code "1"}, ... wrote to stderr and to
 * stdout, line ends included; the referee writes nothing
 * <li>{@code summaries}: which players were eliminated and why; {@code views}: the state after the turn, as the text of
 * a JSON object
 * <li>{@code scores}: see {@link GameResultScores}; {@code uinput}: {@code "seed=N"}; {@code ids} and {@code agents}:
 * the players
 * <li>{@code metadata}: scene, turns and ending, as the text of a JSON object
 * <li>{@code tooltips}: the eliminations, with the turn as {@code event}
 * </ul>
 *
 * <p>Each list keeps at most {@value #MOST_CHARACTERS} characters; later entries are {@code null}.
 */
public final class GameResultLog implements MatchListener {

    /** As many as 500 turns of 16 KiB each: more than any working bot needs. */
    static final int MOST_CHARACTERS = 8 << 20;

    private static final String REFEREE = "referee";
    private static final String ERRORS = "errors";
    private static final String OUTPUTS = "outputs";

    private final List<Texts> outputs = new ArrayList<>();
    private final List<Texts> errors = new ArrayList<>();
    private final Texts nothing = new Texts();
    private final Texts summaries = new Texts();
    private final Texts views = new Texts();
    private final List<Tooltip> tooltips = new ArrayList<>();
    private Game game;
    private GameJson codec;
    private boolean[] in;

    private record Tooltip(String text, int turn) { }

    /**
     * True if a file holds a game result, ours or another referee's: a JSON object with the fields {@code errors} and
     * {@code outputs}. It is read as far as is needed.
     */
    public static boolean isIn(Path file) {
        Set<String> missing = new HashSet<>(Set.of(ERRORS, OUTPUTS));
        try (InputStream bytes = Files.newInputStream(file);
             JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), bytes)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                return false;
            }
            while (!missing.isEmpty() && in.nextToken() == JsonToken.PROPERTY_NAME) {
                missing.remove(in.currentName());
                in.nextToken();
                in.skipChildren();
            }
            return missing.isEmpty();
        } catch (IOException | JacksonException problem) {
            return false;
        }
    }

    @Override
    public void start(Game startedGame, GameJson startedCodec) {
        game = startedGame;
        codec = startedCodec;
        in = new boolean[game.players()];
        for (int player = 0; player < game.players(); player++) {
            in[player] = true;
            outputs.add(new Texts());
            errors.add(new Texts());
        }
        addTurn(player -> null, player -> null, null);
    }

    @Override
    public void played(Turn turn) {
        StringBuilder summary = new StringBuilder();
        for (int player = 0; player < in.length; player++) {
            if (in[player] && !game.isIn(player)) {
                in[player] = false;
                String text = "player " + player + " is out: " + game.eliminationReason(player);
                summary.append(text).append('\n');
                tooltips.add(new Tooltip(text, turn.number()));
            }
        }
        addTurn(player -> lines(turn.answer(player)), turn::stderr, summary.toString());
    }

    private void addTurn(IntFunction<String> output, IntFunction<String> error, String summary) {
        for (int player = 0; player < in.length; player++) {
            outputs.get(player).add(output.apply(player));
            errors.get(player).add(error.apply(player));
        }
        nothing.add(null);
        summaries.add(summary);
        views.add(JsonObject.text(codec::writeState));
    }

    private static String lines(String answer) {
        return answer == null || answer.isEmpty() ? null : answer + "\n";
    }

    /**
     * Writes the match; call when it has its result.
     *
     * @param file is closed
     */
    public void write(OutputStream file, String scene, long seed, MatchResult result) {
        Fields fields = Fields.of(ERRORS, streams(errors), OUTPUTS, streams(outputs), "summaries", summaries.entries,
            "views", views.entries, "scores", perPlayer(GameResultScores.of(result)), "uinput", List.of("seed=" + seed),
            "metadata", JsonObject.text(Fields.of("scene", scene, "turns", result.turns(), "ending",
                result.ending())::write),
            "tooltips", Fields.each(tooltips, each -> Fields.of("text", each.text(), "event", each.turn())),
            "ids", perPlayer(IntStream.range(0, in.length).toArray()),
            "agents", Fields.each(result.players().size(), player -> Fields.of("index", player,
                "name", result.players().get(player).name())));
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), file)) {
            Fields.write(out, fields);
        }
    }

    private Fields streams(List<Texts> players) {
        Fields streams = Fields.of(REFEREE, nothing.entries);
        IntStream.range(0, players.size()).forEach(k -> streams.with(Integer.toString(k), players.get(k).entries));
        return streams;
    }

    private static Fields perPlayer(int... numbers) {
        Fields players = Fields.of();
        IntStream.range(0, numbers.length).forEach(k -> players.with(Integer.toString(k), numbers[k]));
        return players;
    }

    /** One list of texts, bounded as a whole. */
    private static final class Texts {

        private final List<String> entries = new ArrayList<>();
        private int left = MOST_CHARACTERS;

        void add(String text) {
            if (text == null || text.isEmpty() || text.length() > left) {
                entries.add(null);
                left = text == null || text.isEmpty() ? left : 0;
                return;
            }
            entries.add(text);
            left -= text.length();
        }
    }
}
