package steward.replay.verify;

import java.util.HashSet;
import java.util.Set;
import java.util.regex.Pattern;
import steward.json.JsonNumbers;
import steward.replay.JsonLine;
import steward.replay.Observations;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Writes another referee's observations again from an imported replay: each value as it is recorded, in the one
 * spelling that is accepted.
 */
final class RecordedObservations implements Observations {

    private static final Pattern RANK = Pattern.compile("[0-9]{1,9}");

    private final ReplayReader replay;
    private byte[] outcome;
    private String outcomePlace;

    RecordedObservations(ReplayReader replay) {
        this.replay = replay;
    }

    /** The outcome of the turn that is written next. */
    void next(byte[] recorded, String where) {
        outcome = recorded;
        outcomePlace = where;
    }

    /** True if an outcome has a state in which every body has its place. */
    static boolean hasState(byte[] outcome) {
        JsonLine fields = new JsonLine("outcome", outcome);
        if (!fields.has("state")) {
            return false;
        }
        JsonLine state = new JsonLine("state", fields.object("state"));
        if (!state.has("bodies")) {
            return false;
        }
        byte[] bodies = state.array("bodies");
        int count = 0;
        try (JsonParser in = parser(bodies)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.START_OBJECT) {
                count++;
                int places = 0;
                while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                    String name = in.currentName();
                    places += name.equals("x") || name.equals("y") ? 1 : 0;
                    in.nextToken();
                    in.skipChildren();
                }
                if (places < 2) {
                    return false;
                }
            }
        }
        return count > 0;
    }

    @Override
    public boolean hasStart() {
        return !new JsonLine(replay.source() + ":1: start", replay.start()).has("hash");
    }

    @Override
    public void writeStart(JsonGenerator out) {
        String where = replay.source() + ":1: start";
        copyFields(new JsonLine(where, replay.start()).object("state"), where + ".state", out);
    }

    @Override
    public void writeOutcome(JsonGenerator out, int turn) {
        copyFields(outcome, outcomePlace + ": outcome", out);
    }

    @Override
    public int rank(int player) {
        String rank = standing(player, "rank");
        return rank != null && RANK.matcher(rank).matches() ? Integer.parseInt(rank) : -1;
    }

    @Override
    public double score(int player) {
        String score = standing(player, "score");
        return score == null ? Double.NaN : Double.parseDouble(score);
    }

    /** A number that the result says of a player, {@code null} if there is none. */
    private String standing(int player, String field) {
        byte[] standing = replay.result().array("standing");
        try (JsonParser in = parser(standing)) {
            in.nextToken();
            for (int k = 0; in.nextToken() == JsonToken.START_OBJECT; k++) {
                String found = null;
                while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                    boolean wanted = k == player && in.currentName().equals(field);
                    if (in.nextToken().isNumeric() && wanted) {
                        found = in.getString();
                    }
                    in.skipChildren();
                }
                if (k == player) {
                    return found;
                }
            }
            return null;
        }
    }

    private static JsonParser parser(byte[] json) {
        return JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), json, 0, json.length);
    }

    /** Writes the fields of an object once more; none may be there twice. */
    private static void copyFields(byte[] object, String where, JsonGenerator out) {
        try (JsonParser in = parser(object)) {
            in.nextToken();
            copyRest(in, where, out);
        }
    }

    private static void copyRest(JsonParser in, String where, JsonGenerator out) {
        Set<String> names = new HashSet<>();
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            if (!names.add(name)) {
                throw new ReplayException(where + "." + name + ": found twice, expected once");
            }
            out.writeName(name);
            copy(in, in.nextToken(), where + "." + name, out);
        }
    }

    private static void copy(JsonParser in, JsonToken token, String where, JsonGenerator out) {
        switch (token) {
            case START_OBJECT -> {
                out.writeStartObject();
                copyRest(in, where, out);
                out.writeEndObject();
            }
            case START_ARRAY -> {
                out.writeStartArray();
                for (JsonToken next = in.nextToken(); next != JsonToken.END_ARRAY; next = in.nextToken()) {
                    copy(in, next, where + "[]", out);
                }
                out.writeEndArray();
            }
            case VALUE_STRING -> out.writeString(in.getString());
            default -> out.writeRawValue(in.getString());
        }
    }
}
