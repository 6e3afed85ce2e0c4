package steward.replay;

import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Objects;
import steward.json.JsonNumbers;
import steward.match.Turn;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.json.JsonMapper;

/**
 * One turn of a replay.
 *
 * @param number    counted from 1
 * @param commands  the array of commands, one per player or null, as JSON
 * @param faults    per player why it failed in this turn, or null
 * @param hash      of the line
 * @param outcome   impacts, paths, events, state and hash, as JSON
 * @param messages  per player, or null
 * @param stderr    per player what it wrote, or null
 * @param times     the measured part as JSON, or null if absent
 * @param where     file and line, for errors
 */
public record RecordedTurn(int number, byte[] commands, String[] faults, String hash, byte[] outcome, String[] messages,
                           String[] stderr, byte[] times, String where) {

    /** Reader of states: it takes no field twice, no unknown one, and no text or fraction for a whole number. */
    private static final JsonMapper STATES = JsonMapper.builder()
        .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES, DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
        .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT).disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
        .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();
    private static final int SHOWN = 80;

    static RecordedTurn of(JsonLine line, int players) {
        LineFields.TURN.check(line);
        return new RecordedTurn(line.integer("turn"), line.array("commands"), line.texts("faults", players),
            line.text(LineFields.TURN_HASH), line.object("outcome"),
            line.texts("messages", players), line.texts("stderr", players),
            line.has(LineFields.TIMES) ? line.object(LineFields.TIMES) : null, line.where());
    }

    /**
     * True if a player who was in was asked. Only a fault of another in this turn can have spared it the question; it
     * then has neither a command nor a fault.
     */
    public boolean asked(int player) {
        return faults[player] != null || Arrays.stream(faults).allMatch(Objects::isNull) || hasCommand(player);
    }

    public boolean hasCommand(int player) {
        return isValue(entry(commands, player));
    }

    /** Returns a parser on the first token of a player's command; {@code null} if it has none. */
    public JsonParser command(int player) {
        return element(commands, player);
    }

    /** A parser on an element of an array; {@code null} if that is absent or null. */
    private static JsonParser element(byte[] array, int index) {
        byte[] entry = entry(array, index);
        if (!isValue(entry)) {
            return null;
        }
        JsonParser in = parser(entry);
        in.nextToken();
        return in;
    }

    private static boolean isValue(byte[] entry) {
        String text = entry == null ? "" : new String(entry, StandardCharsets.UTF_8);
        return !text.isBlank() && !text.strip().equals("null");
    }

    /** Tells a turn of a player's fault or answer, if it has one. */
    public void tell(Turn turn, int player) {
        if (faults[player] != null) {
            turn.fail(player, faults[player], stderr[player], nanos(player));
        } else if (hasCommand(player)) {
            turn.answer(player, messages[player], stderr[player], nanos(player));
        }
    }

    /**
     * True if the command of the player was recorded in these very bytes. It is not found in another spelling.
     *
     * @param json   a command as JSON, whole
     * @param length how many bytes of it count
     */
    public boolean hasCommand(int player, byte[] json, int length) {
        byte[] entry = entry(commands, player);
        return entry != null && Arrays.equals(entry, 0, entry.length, json, 0, length);
    }

    /**
     * Reads the state after the turn.
     *
     * @param type the record of the game's states, such as {@code PodRaceJson.State}
     * @return {@code null} if the turn has no state, as most of a sparse replay
     * @throws ReplayException if it is that of another game
     */
    public <S extends Record> S state(Class<S> type) {
        JsonLine fields = new JsonLine(where + ": outcome", outcome);
        if (!fields.has("state")) {
            return null;
        }
        try {
            S state = STATES.readValue(fields.object("state"), type);
            for (RecordComponent component : type.getRecordComponents()) {
                if (component.getAccessor().invoke(state) == null) {
                    throw wrong(type, "." + component.getName(), "nothing");
                }
            }
            return state;
        } catch (JacksonException problem) {
            boolean lacks = problem.getOriginalMessage().startsWith("Cannot map `null`");
            StringBuilder place = new StringBuilder();
            problem.getPath().stream().limit(problem.getPath().size() - (lacks ? 1 : 0)).forEach(each ->
                place.append(each.getPropertyName() == null ? "[" + each.getIndex() + "]"
                    : "." + each.getPropertyName()));
            throw wrong(type, place.toString(), lacks ? "null or nothing for a number"
                : problem.getOriginalMessage().replaceAll("\\s+", " "));
        } catch (ReflectiveOperationException hidden) {
            throw new IllegalArgumentException(type + " is not public", hidden);
        }
    }

    private ReplayException wrong(Class<?> type, String place, String found) {
        Class<?> game = type.getEnclosingClass() == null ? type : type.getEnclosingClass();
        return new ReplayException(where + ": outcome: state" + place + ": found " + TextFormat.beginning(found, SHOWN)
            + ", expected a state of " + game.getSimpleName());
    }

    /** Returns an entry of an array as it is written between its commas; {@code null} if there are fewer. */
    private static byte[] entry(byte[] array, int number) {
        int left = number;
        int from = 1;
        int depth = 0;
        boolean quoted = false;
        for (int at = 1; at < array.length; at++) {
            byte one = array[at];
            if (quoted) {
                at += one == '\\' ? 1 : 0;
                quoted = one != '"';
            } else if (one == '"') {
                quoted = true;
            } else if (depth == 0 && (one == ',' || one == ']')) {
                if (left-- == 0) {
                    return at == from ? null : Arrays.copyOfRange(array, from, at);
                }
                from = at + 1;
            } else if (one == '[' || one == '{') {
                depth++;
            } else if (one == ']' || one == '}') {
                depth--;
            }
        }
        return null;
    }

    /**
     * Returns how long the player took, in nanoseconds; 0 if that was not recorded.
     *
     * @throws ReplayException if a whole number beyond 64 bits was
     */
    public long nanos(int player) {
        if (times == null) {
            return 0;
        }
        JsonLine line = new JsonLine(where, times);
        if (!line.has("answerNanos")) {
            return 0;
        }
        try (JsonParser in = element(line.array("answerNanos"), player)) {
            if (in == null || in.currentToken() != JsonToken.VALUE_NUMBER_INT) {
                return 0;
            }
            if (in.getNumberType() == JsonParser.NumberType.BIG_INTEGER) {
                throw new ReplayException(where + ": times: answerNanos[" + player + "]: found "
                    + TextFormat.beginning(in.getString(), 40) + ", expected a whole number below 2^63");
            }
            return in.getLongValue();
        }
    }

    public static JsonParser parser(byte[] json) {
        return JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length);
    }
}
