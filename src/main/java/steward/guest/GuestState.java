package steward.guest;

import java.util.ArrayList;
import java.util.List;
import steward.game.StateCodec;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * Answers and states of a guest as a replay keeps them. A command is the lines of an answer, with its time where the
 * referee counts times; a state is all that the referee has said since the last answer.
 */
record GuestState(GuestGame game) implements StateCodec {

    private static final String EXPECTED = ", expected an object with the lines of an answer";

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartObject();
        if (game.isMonitored()) {
            out.writeNumberProperty("ms", game.answerMs());
        }
        writeLines(out, game.answer());
        out.writeEndObject();
    }

    private static void writeLines(JsonGenerator out, List<String> lines) {
        out.writeArrayPropertyStart("lines");
        lines.forEach(out::writeString);
        out.writeEndArray();
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            in.skipChildren();
            return "found no object" + EXPECTED;
        }
        long ms = 0;
        List<String> lines = null;
        String wrong = null;
        while (in.nextToken() != JsonToken.END_OBJECT) {
            String name = in.currentName();
            JsonToken value = in.nextToken();
            if (name.equals("ms") && value == JsonToken.VALUE_NUMBER_INT && game.isMonitored()) {
                ms = in.getLongValue();
            } else if (name.equals("lines") && value == JsonToken.START_ARRAY) {
                lines = new ArrayList<>();
                while (in.nextToken() == JsonToken.VALUE_STRING) {
                    lines.add(in.getString());
                }
                wrong = in.currentToken() == JsonToken.END_ARRAY ? wrong : "found a line that is no text" + EXPECTED;
                while (in.currentToken() != JsonToken.END_ARRAY) {
                    in.skipChildren();
                    in.nextToken();
                }
            } else {
                in.skipChildren();
                wrong = "found the field \"" + name + "\"" + EXPECTED;
            }
        }
        if (wrong == null && (lines == null || lines.size() != game.lines())) {
            wrong = "found " + (lines == null ? "no" : lines.size()) + " lines, expected " + game.lines();
        }
        wrong = wrong == null ? GuestText.wrong(lines) : wrong;
        if (wrong == null) {
            game.answer(lines, ms);
        }
        return wrong;
    }

    @Override
    public void clearCommand(int player) {
        game.answer(null, 0);
    }

    @Override
    public void writeState(JsonGenerator out) {
        List<Block> blocks = game.blocks();
        out.writeArrayPropertyStart("bodies");
        out.writeEndArray();
        if (game.asked() >= 0) {
            out.writeNumberProperty("asked", game.asked());
        }
        out.writeArrayPropertyStart("said");
        for (Block block : blocks) {
            out.writeStartObject();
            out.writeStringProperty("block", block.name().name());
            writeLines(out, block.lines());
            out.writeEndObject();
        }
        out.writeEndArray();
    }
}
