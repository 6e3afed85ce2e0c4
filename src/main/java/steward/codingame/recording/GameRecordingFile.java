package steward.codingame.recording;

import java.util.stream.Collectors;
import steward.replay.ReplayHeader;
import steward.scene.json.JsonProblem;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.exc.UnexpectedEndOfInputException;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * JSON file with a recording: {@code {"success":{"gameResult":{"frames":[...],...}}}} or any of the inner objects. For
 * another file, the error says what the file is.
 */
final class GameRecordingFile {

    private static final JsonMapper MAPPER = JsonMapper.builder()
        .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS).build();

    private static final String EXPECTED = "expected CodinGame's game result with an array \"frames\"";
    private static final int MOST_NAMES = 8;
    private static final int LONGEST_NAME = 40;
    private static final int MOST_SHOWN = 40;

    /**
     * The object whose field {@code frames} is an array that is not empty.
     *
     * @param source its name, for errors
     * @throws IllegalArgumentException if it is no recording
     */
    static JsonNode gameResult(String text, String source) {
        if (text.isBlank()) {
            throw new IllegalArgumentException(source + ": found an empty file, " + EXPECTED);
        }
        if (text.startsWith(ReplayHeader.SIGNATURE)) {
            throw new IllegalArgumentException(source + ": found a replay of Steward, " + EXPECTED
                + "; 'steward replay' reads it as it is");
        }
        JsonNode root = parse(text, source);
        JsonNode result = root.has("success") ? root.get("success") : root;
        result = result.has("gameResult") ? result.get("gameResult") : result;
        result = RunnerResult.is(result) ? RunnerResult.frames(result, source) : result;
        JsonNode frames = result.get("frames");
        if (frames == null || !frames.isArray() || frames.isEmpty()) {
            throw new IllegalArgumentException(source + ": found " + kind(result, frames) + ", " + EXPECTED);
        }
        return result;
    }

    private static JsonNode parse(String text, String source) {
        try {
            return MAPPER.readTree(text);
        } catch (UnexpectedEndOfInputException cut) {
            throw new IllegalArgumentException(source + place(cut)
                + ": found the end of the file within the JSON: it was cut off, expected all of it");
        } catch (JacksonException problem) {
            String kind = otherKind(text);
            throw new IllegalArgumentException(source + (kind != null ? ": found " + kind + ", " + EXPECTED
                : place(problem) + ": not JSON: " + JsonProblem.message(problem)));
        }
    }

    private static String place(JacksonException problem) {
        return problem.getLocation() == null ? ""
            : ":" + problem.getLocation().getLineNr() + ":" + problem.getLocation().getColumnNr();
    }

    /** Names the kind of a file that is not one JSON value; {@code null} if it looks like damaged JSON. */
    private static String otherKind(String text) {
        String first = text.stripLeading().lines().findFirst().orElse("");
        if (first.startsWith("<")) {
            return "a web page or XML";
        }
        if (!first.isEmpty() && "{[\"".indexOf(first.charAt(0)) < 0) {
            return "a text file, not JSON: it begins with \"" + TextFormat.shorten(first, MOST_SHOWN) + "\"";
        }
        try {
            return MAPPER.readTree(first).isContainer() ? "JSON Lines, one value a line" : null;
        } catch (JacksonException none) {
            return null;
        }
    }

    private static String kind(JsonNode result, JsonNode frames) {
        if (result.has("views") && result.has("outputs") && result.has("uinput")) {
            return "the game result that 'steward referee -l' writes (its -r writes a replay)";
        }
        if (frames != null) {
            return frames.isArray() ? "an empty array \"frames\"" : "\"frames\" that is no array";
        }
        if (!result.isObject()) {
            return "no frames: " + "the file is " + JsonProblem.kind(result.asToken());
        }
        return "no frames" + (result.isEmpty() ? "" : result.propertyNames().stream().limit(MOST_NAMES)
            .map(name -> TextFormat.shorten(name, LONGEST_NAME))
            .collect(Collectors.joining(", ", ": the object has ", "")));
    }
}
