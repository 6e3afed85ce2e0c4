package steward.guest;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import steward.game.GameJson;
import steward.game.TextCodec;
import steward.json.DrawingJson;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Lines of the bots of a {@link GuestGame}, which pass unchanged, and JSON of its answers and states in replays. A
 * command is the lines of an answer, with its time if the referee counts times. A state is everything that the referee
 * has said since the last answer.
 */
record GuestCodec(GuestGame game) implements GameJson, TextCodec {

    private static final String LINES = "lines";
    private static final String EXPECTED = ", expected an object with the lines of an answer";

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        throw linesOnly();
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        throw linesOnly();
    }

    private static UnsupportedOperationException linesOnly() {
        return new UnsupportedOperationException("bots of a guest speak its lines only");
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        // The referee itself sends what bots get first, with its first question.
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        out.append(game.input(player));
    }

    @Override
    public int answerLines(int player) {
        return game.lines();
    }

    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return game.refusal(List.of(new String(answer, 0, length, StandardCharsets.UTF_8).split("\n", -1)),
            game.answerMs());
    }

    @Override
    public String message(int player) {
        return null;
    }

    @Override
    public void writeCommand(JsonGenerator out, int player) {
        out.writeStartObject();
        if (game.isMonitored()) {
            out.writeNumberProperty("ms", game.answerMs());
        }
        JsonObject.writeTexts(out, LINES, game.answer());
        out.writeEndObject();
    }

    @Override
    public String readCommand(JsonParser in, int player) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return "found no object" + EXPECTED;
        }
        long ms = 0;
        List<String> lines = null;
        while (in.nextToken() != JsonToken.END_OBJECT) {
            String name = in.currentName();
            JsonToken value = in.nextToken();
            if (name.equals("ms") && value == JsonToken.VALUE_NUMBER_INT && game.isMonitored()) {
                ms = in.getLongValue();
            } else if (name.equals(LINES) && value == JsonToken.START_ARRAY) {
                lines = new ArrayList<>();
                while (in.nextToken() == JsonToken.VALUE_STRING) {
                    lines.add(in.getString());
                }
                if (in.currentToken() != JsonToken.END_ARRAY) {
                    return "found a line that is no text" + EXPECTED;
                }
            } else {
                return "found the field \"" + name + "\"" + EXPECTED;
            }
        }
        return lines == null ? "found no lines, expected " + game.lines() : game.refusal(lines, ms);
    }

    @Override
    public void clearCommand(int player) {
        game.answer(null, 0);
    }

    @Override
    public void writeState(JsonGenerator out) {
        JsonObject.writeTexts(out, "bodies", List.of());
        if (game.asked() >= 0) {
            out.writeNumberProperty("asked", game.asked());
        }
        JsonObject.writeAll(out, "said", game.blocks(), block -> {
            out.writeStringProperty("block", block.name().name());
            JsonObject.writeTexts(out, LINES, block.lines());
        });
    }

    /** An empty field: what the guest shows is not known. */
    @Override
    public void writeDrawing(JsonGenerator out) {
        DrawingJson.field(out, 0, 0, GuestGame.WIDTH, GuestGame.HEIGHT);
        List.of("walls", "zones", "bodies").forEach(shapes -> JsonObject.writeTexts(out, shapes, List.of()));
    }

    /** Reads what the referee said from a start or outcome; a block of no known name is a failure of it. */
    static List<RefereeBlock> said(byte[] outcome) {
        List<RefereeBlock> said = new ArrayList<>();
        for (JsonNode block : JsonMapper.shared().readTree(outcome).at("/state/said")) {
            said.add(new RefereeBlock(Stream.of(RefereeBlock.Name.values()).filter(name ->
                name.name().equals(block.path("block").asString(""))).findFirst().orElse(RefereeBlock.Name.FAIL),
                block.path(LINES).valueStream().map(line -> line.asString("")).toList()));
        }
        return said;
    }
}
