package steward.codingame.recording;

import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import steward.text.TextFormat;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Reader of the results that the SDK's own runner writes. They are the frames of the site's JSON, told apart by kind in
 * place of frame by frame; the runner's page makes frames of them in this way too.
 */
final class RunnerResult {

    private static final String VIEWS = "views";
    private static final String KEY_FRAME = "KEY_FRAME";
    private static final int SHOWN = 100;

    private RunnerResult() { }

    /** True for a result with views as the engine writes them. */
    static boolean is(JsonNode result) {
        return result.path("outputs").isObject() && result.path(VIEWS).path(0).asString("").startsWith(KEY_FRAME);
    }

    /** The result as the site writes it. @throws IllegalArgumentException if the game was broken off */
    static JsonNode frames(JsonNode result, String source) {
        String cause = result.path("failCause").asString("");
        if (!cause.isBlank()) {
            throw new IllegalArgumentException(source + ": failCause: found \""
                + TextFormat.beginning(TextFormat.plain(cause.strip().lines().findFirst().orElse("")), SHOWN)
                + "\", expected a game that came to its end");
        }
        ObjectNode made = JsonMapper.shared().createObjectNode();
        ArrayNode frames = made.putArray("frames");
        Map<Integer, JsonNode> players = new TreeMap<>();
        result.get("outputs").properties().stream().filter(each -> each.getKey().matches("\\d"))
            .forEach(each -> players.put(Integer.parseInt(each.getKey()), each.getValue()));
        for (int k = 0; k < result.get(VIEWS).size(); k++) {
            String view = result.get(VIEWS).get(k).asString(null);
            ObjectNode frame = frames.addObject().put("view", view).put("keyframe",
                view != null && view.startsWith(KEY_FRAME));
            frame.set("summary", result.path("summaries").path(k));
            for (Map.Entry<Integer, JsonNode> player : players.entrySet()) {
                JsonNode stdout = player.getValue().path(k);
                JsonNode stderr = result.path("errors").path(player.getKey().toString()).path(k);
                if (stdout.isString()) {
                    frame.put("agentId", player.getKey()).put("stdout", stdout.stringValue());
                }
                if (stderr.isString() && k > 0) {
                    frame.put("stderr", stderr.stringValue());
                }
            }
        }
        made.put("refereeInput", result.path("uinput").valueStream().map(line -> line.asString(""))
            .collect(Collectors.joining("\n")));
        if (result.path("scores").size() > 0) {
            ArrayNode scores = made.putArray("scores");
            players.keySet().forEach(player -> scores.add(result.get("scores").path(player.toString())));
        }
        for (String same : new String[] {"agents", "tooltips", "metadata"}) {
            made.set(same, result.path(same));
        }
        return made;
    }
}
