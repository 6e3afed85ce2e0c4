package steward.replay.page;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.IntPredicate;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.io.JsonStringEncoder;

/**
 * A long replay as a page holds it: lines without the large lists of numbers, which follow in tables
 * ({@link PackedTable}). The lists are the bodies of states, the impacts and the paths of turns. Between lines and
 * tables stand a line that describes the tables and a zero byte, which no JSON has. If the whole is still too large for
 * a page, only every k-th turn keeps its lists, as in a sparse replay. A list with anything but numbers stays in its
 * line, and a replay that is not long is held as it is, to the last digit.
 */
final class PackedTurns {

    /** Bytes of a replay up to which it is held as it is: most games between bots. */
    private static final int MOST_PLAIN = 2 << 20;
    /** Characters that a replay takes of a page at most. */
    private static final int MOST = 20_000_000;

    private static final String OUTCOME = "outcome";
    private static final String STATE = "state";

    private final PackedTable bodies = new PackedTable("bodies", true);
    private final PackedTable impacts = new PackedTable("impacts", false);
    private final PackedTable paths = new PackedTable("paths", false);
    private final List<PackedTable> tables = List.of(bodies, impacts, paths);
    private final ByteArrayOutputStream lines = new ByteArrayOutputStream();
    private int turns;

    private PackedTurns() { }

    /** Returns the text that stands in the page for a replay, gzip in base64. */
    static String of(byte[] replay) {
        return replay.length <= MOST_PLAIN ? ReplayPage.embedded(replay) : of(replay, MOST);
    }

    /** As {@link #of(byte[])} does for a long replay. @param most characters, as far as leaving out turns helps */
    static String of(byte[] replay, int most) {
        PackedTurns packed = new PackedTurns();
        int from = 0;
        for (int end = 0; end < replay.length; end++) {
            if (replay[end] == '\n' || end == replay.length - 1) {
                packed.line(Arrays.copyOfRange(replay, from, replay[end] == '\n' ? end : end + 1));
                from = end + 1;
            }
        }
        String text = ReplayPage.embedded(packed.bytes(1));
        for (int every = 1; text.length() > most && every < packed.turns;) {
            every = Math.max(every + 1, (int) Math.min(packed.turns, (long) every * text.length() / most));
            text = ReplayPage.embedded(packed.bytes(every));
        }
        return text;
    }

    private byte[] bytes(int every) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes(lines.toByteArray());
        all.writeBytes(JsonObject.of(out -> {
            out.writeStringProperty("type", "packed");
            out.writeNumberProperty("every", every);
            JsonObject.writeAll(out, "tables", tables, table -> table.describe(out));
        }));
        all.write(0);
        IntPredicate isKept = turn -> turn % every == 0 || turn == turns;
        try {
            for (PackedTable table : tables) {
                table.write(all, isKept);
            }
        } catch (IOException inMemory) {
            throw new IllegalStateException(inMemory);
        }
        return all.toByteArray();
    }

    /** Copies a line; the numbers of a turn go into the tables. */
    private void line(byte[] line) {
        int[] from = tables.stream().mapToInt(PackedTable::rows).toArray();
        boolean[] isTaken = new boolean[from.length];
        boolean[] isTurn = {false};
        lines.writeBytes(copied(line, (name, value) -> {
            isTurn[0] |= name.equals(OUTCOME);
            return name.equals(OUTCOME) ? copied(value, (part, inner) -> switch (part) {
                case STATE -> copied(inner, (field, array) ->
                    field.equals("bodies") && (isTaken[0] = take(bodies, array)) ? null : array);
                case "impacts" -> (isTaken[1] = take(impacts, inner)) ? null : inner;
                case "paths" -> (isTaken[2] = take(paths, inner)) ? null : inner;
                default -> inner;
            }) : value;
        }));
        lines.write('\n');
        if (isTurn[0]) {
            if (turns++ == 0) {
                tables.forEach(table -> table.endTurn(-1));          // the start, which stays in the header
            }
            for (int k = 0; k < from.length; k++) {
                tables.get(k).endTurn(isTaken[k] ? from[k] : -1);
            }
        }
    }

    /** Returns a JSON object with each value as a function gives it back, without those for which it gives null. */
    private static byte[] copied(byte[] object, BiFunction<String, byte[], byte[]> values) {
        ByteArrayOutputStream copy = new ByteArrayOutputStream(object.length);
        try (JsonParser in = parser(object)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                int from = (int) in.currentTokenLocation().getByteOffset();
                in.skipChildren();
                in.finishToken();
                byte[] value = values.apply(name, Arrays.copyOfRange(object, from,
                    (int) in.currentLocation().getByteOffset()));
                if (value != null) {
                    copy.write(copy.size() == 0 ? '{' : ',');
                    copy.write('"');
                    copy.writeBytes(JsonStringEncoder.getInstance().quoteAsUTF8(name));
                    copy.write('"');
                    copy.write(':');
                    copy.writeBytes(value);
                }
            }
        }
        copy.writeBytes((copy.size() == 0 ? "{}" : "}").getBytes(StandardCharsets.US_ASCII));
        return copy.toByteArray();
    }

    private static JsonParser parser(byte[] json) {
        return JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length);
    }

    /** Takes an array of objects into a table; returns false, and leaves none, if they have anything but numbers. */
    private boolean take(PackedTable table, byte[] array) {
        int before = table.rows();
        try (JsonParser in = parser(array)) {
            boolean isNumbers = in.nextToken() == JsonToken.START_ARRAY;
            while (isNumbers && in.nextToken() == JsonToken.START_OBJECT) {
                isNumbers = table == paths ? path(in) : row(table, in);
            }
            if (isNumbers && in.currentToken() == JsonToken.END_ARRAY) {
                return true;
            }
        }
        table.dropFrom(before);
        return false;
    }

    private static boolean row(PackedTable table, JsonParser in) {
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            if (!in.nextToken().isNumeric()) {
                return false;
            }
            table.set(name, in.getDoubleValue());
        }
        table.endRow();
        return true;
    }

    /** A path {"id":1,"knots":[[t,x,y],...]} is a row for each knot. */
    private boolean path(JsonParser in) {
        in.nextToken();
        if (!"id".equals(in.currentName()) || in.nextToken() != JsonToken.VALUE_NUMBER_INT) {
            return false;
        }
        int id = in.getIntValue();
        if (in.nextToken() != JsonToken.PROPERTY_NAME || in.nextToken() != JsonToken.START_ARRAY) {
            return false;
        }
        while (in.nextToken() == JsonToken.START_ARRAY) {
            paths.set("id", id);
            for (String column : List.of("t", "x", "y")) {
                if (!in.nextToken().isNumeric()) {
                    return false;
                }
                paths.set(column, in.getDoubleValue());
            }
            paths.endRow();
            in.nextToken();
        }
        return in.nextToken() == JsonToken.END_OBJECT;
    }
}
