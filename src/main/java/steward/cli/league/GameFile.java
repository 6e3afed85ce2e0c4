package steward.cli.league;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
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
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** Games as CSV, a line for each seat, or as JSON Lines, a line for each game; all values are texts. */
final class GameFile {

    private static final JsonFactory JSON = new JsonFactory();
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
        StringWriter line = new StringWriter();
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), line)) {
            json.writeStartObject();
            GameLine.game(game, season).forEach(json::writeStringProperty);
            JsonObject.writeAll(json, SEATS, game.seats(), seat ->
                GameLine.seat(seat, versions.get(seat.version())).forEach(json::writeStringProperty));
            json.writeEndObject();
        }
        out.print(line + "\n");
    }

    /** A game of a file. */
    record Found(String place, Map<String, String> game, List<Map<String, String>> seats) { }

    /** Takes the games of a file, one by one. */
    interface Taker {
        void take(Found game);
    }

    /** Reads JSON Lines. */
    static void readJson(BufferedReader in, String source, Taker taker) throws IOException {
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
            taker.take(new Found(place, texts(place, fields), seats));
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

    /** Reads CSV; the lines of a game's seats follow each other. */
    static void readCsv(BufferedReader in, String source, Taker taker) throws IOException {
        List<String> heads = new ArrayList<>();
        Found[] last = {null};
        eachLine(in, source, (line, place) -> {
            List<String> cells = cells(line, place);
            if (heads.isEmpty()) {
                heads.addAll(cells);
                List<String> missing = new ArrayList<>(GameLine.GAME);
                missing.addAll(GameLine.SEAT);
                missing.removeAll(heads);
                missing.removeAll(GameLine.OPTIONAL);
                if (!missing.isEmpty()) {
                    throw new InputException(place + ": found no column " + missing.get(0)
                        + ", expected the columns of 'league export'");
                }
                return;
            }
            if (cells.size() != heads.size()) {
                throw new InputException(place + ": found " + cells.size() + " cells, expected " + heads.size());
            }
            Map<String, String> fields = new LinkedHashMap<>();
            for (int k = 0; k < heads.size(); k++) {
                fields.put(heads.get(k), cells.get(k));
            }
            if (last[0] != null && !last[0].game().get("name").equals(fields.get("name"))) {
                taker.take(last[0]);
                last[0] = null;
            }
            last[0] = last[0] == null ? new Found(place, fields, new ArrayList<>()) : last[0];
            last[0].seats().add(fields);
        });
        if (last[0] != null) {
            taker.take(last[0]);
        }
    }

    /** The cells of a line (RFC 4180, without line ends within cells). */
    static List<String> cells(String line, String place) {
        List<String> cells = new ArrayList<>();
        StringBuilder cell = new StringBuilder();
        boolean quoted = false;
        for (int k = 0; k < line.length(); k++) {
            char c = line.charAt(k);
            if (quoted && c == '"' && k + 1 < line.length() && line.charAt(k + 1) == '"') {
                cell.append('"');
                k++;
            } else if (c == '"') {
                quoted = !quoted;
            } else if (c == ',' && !quoted) {
                cells.add(CsvRow.unshielded(cell.toString()));
                cell.setLength(0);
            } else {
                cell.append(c);
            }
        }
        if (quoted) {
            throw new InputException(place + ": found a quotation mark that does not end, expected one more");
        }
        cells.add(CsvRow.unshielded(cell.toString()));
        return cells;
    }
}
