package steward.cli.league;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import steward.cli.streams.Json;
import steward.files.InputException;
import steward.json.JsonObject;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.store.GameLine;
import steward.league.store.GameStore.Version;
import steward.text.CsvRow;
import tools.jackson.core.JacksonException;

/**
 * Format of exported games: CSV with a line for each seat, or JSON Lines with a line for each game; all values are
 * texts.
 */
final class GameFile {

    private static final String SEATS = "seats";
    private static final String SEAT = "seat";
    /** Characters of a line; a game of 100 seats has less. */
    private static final int LONGEST = 1 << 20;

    static void csvHead(PrintStream out) {
        out.print(new CsvRow().words(Stream.of(GameLine.GAME, List.of(SEAT), GameLine.SEAT).flatMap(List::stream)
            .toArray(String[]::new)).line());
    }

    static void csv(PrintStream out, StoredGame game, Season season, Map<Integer, Version> versions) {
        Map<String, String> fields = GameLine.game(game, season);
        for (int seat = 0; seat < game.seats().size(); seat++) {
            CsvRow row = new CsvRow();
            fields.values().forEach(row::words);
            row.words(Integer.toString(seat));
            GameLine.seat(game.seats().get(seat), versions.get(game.seats().get(seat).version())).values()
                .forEach(row::words);
            out.print(row.line());
        }
    }

    static void json(PrintStream out, StoredGame game, Season season, Map<Integer, Version> versions) {
        out.print(JsonObject.text(json -> {
            GameLine.game(game, season).forEach(json::writeStringProperty);
            JsonObject.writeAll(json, SEATS, game.seats(), seat ->
                GameLine.seat(seat, versions.get(seat.version())).forEach(json::writeStringProperty));
        }) + "\n");
    }

    /** A game of a file. */
    record Found(String place, Map<String, String> game, List<Map<String, String>> seats) { }

    /** Reads JSON Lines. */
    static void readJson(BufferedReader in, String source, Consumer<Found> taker) throws IOException {
        eachLine(in, source, (line, place) -> {
            Map<String, Object> object;
            try {
                object = Json.object(line.getBytes(StandardCharsets.UTF_8));
            } catch (JacksonException | ClassCastException | IllegalStateException problem) {
                throw new InputException(place + ": found no JSON object, expected a game");
            }
            List<Map<String, String>> seats = new ArrayList<>();
            if (object.get(SEATS) instanceof List<?> list) {
                list.forEach(seat -> seats.add(texts(place, seat)));
            }
            Map<String, Object> fields = new LinkedHashMap<>(object);
            fields.remove(SEATS);
            taker.accept(new Found(place, texts(place, fields), seats));
        });
    }

    private static Map<String, String> texts(String place, Object object) {
        if (!(object instanceof Map<?, ?> fields)) {
            throw new InputException(place + ": found a seat that is no object, expected its fields");
        }
        Map<String, String> texts = new LinkedHashMap<>();
        fields.forEach((name, value) -> {
            if (!(value instanceof String)) {
                throw new InputException(place + ": " + name + ": found a value that is no text, expected a text");
            }
            texts.put((String) name, (String) value);
        });
        return texts;
    }

    private static void eachLine(BufferedReader in, String source, BiConsumer<String, String> taker)
            throws IOException {
        int number = 0;
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String place = source + ":" + ++number;
            if (line.length() > LONGEST) {
                throw new InputException(place + ": found a line of " + line.length() + " characters, expected at most "
                    + LONGEST);
            }
            if (!line.isBlank()) {
                taker.accept(line, place);
            }
        }
    }
}
