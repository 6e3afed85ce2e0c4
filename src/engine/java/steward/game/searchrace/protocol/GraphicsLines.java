package steward.game.searchrace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Views of the site's toolkit for games, written as lines in a fixed order. The toolkit itself writes the updates of a
 * frame, and the attributes of an update, in the order of a hash table. Line 0 of a view has its number, line 1 is
 * JSON:
 * <pre>
 * entitymodule   a text of lines; that which begins with U holds updates, separated by ";", each
 *                id time key value [curve] key value [curve] ..; of what has not changed there are none
 * tooltips       [{"id": "text"}] of those that have changed
 * endScreen      [[score], image, ["score"]] at the end
 * </pre>
 * In frame 0 they stand in {@code frame}. A value with a blank stands in single quotes.
 */
final class GraphicsLines {

    static final String UPDATE = "update ";
    static final String TOOLTIP = "tooltip ";
    static final String END = "endScreen ";

    private static final Set<String> CURVES = Set.of("_", "\u0393", "/", "\ud83d\ude56", "\ud83d\ude52", "\u222b", "~");
    private static final JsonMapper MAPPER = JsonMapper.shared();

    /** The JSON of a view, or {@code null} if its line 1 is none. */
    static JsonNode json(String line) {
        try {
            JsonNode json = MAPPER.readTree(line);
            return !json.isObject() ? null : json.has("frame") ? json.get("frame") : json;
        } catch (JacksonException problem) {
            return null;
        }
    }

    /**
     * Returns the lines of a view that are compared.
     *
     * @param text of the view
     * @param kept the attributes that count, per entity; {@code null} for an entity that does not
     */
    static List<String> of(String text, IntFunction<Set<String>> kept) {
        List<String> lines = new ArrayList<>(List.of(text.split("\r?\n", -1)));
        JsonNode json = lines.size() < 2 ? null : json(lines.get(1));
        if (json == null) {
            return lines;
        }
        List<String> found = new ArrayList<>();
        for (List<String> update : updates(json)) {
            String line = line(update, kept);
            if (line != null) {
                found.add(line);
            }
        }
        for (JsonNode tips : json.path("tooltips")) {
            tips.properties().forEach(tip -> found.add(TOOLTIP + tip.getKey() + " " + tip.getValue().asString("")));
        }
        if (json.has("endScreen")) {
            JsonNode end = json.get("endScreen");
            found.add(END + end.path(0).path(0).asString("") + " " + end.path(2).path(0).asString(""));
        }
        found.sort(null);
        found.add(0, lines.get(0));
        found.addAll(lines.subList(2, lines.size()));
        return found;
    }

    /** The words of all updates of a frame. */
    static List<List<String>> updates(JsonNode frame) {
        List<List<String>> updates = new ArrayList<>();
        for (String line : split(frame.path("entitymodule").asString(""), '\n')) {
            if (line.startsWith("U")) {
                split(line.substring(1), ';').forEach(update -> updates.add(split(update, ' ')));
            }
        }
        return updates;
    }

    private static String line(List<String> words, IntFunction<Set<String>> kept) {
        if (words.size() < 2 || !words.get(0).matches("[0-9]{1,7}")) {
            return UPDATE + String.join(" ", words);
        }
        Set<String> keys = kept.apply(Integer.parseInt(words.get(0)));
        if (keys == null) {
            return null;
        }
        List<String> attributes = new ArrayList<>();
        for (int k = 2; k < words.size(); k += 2) {
            String key = words.get(k);
            String value = k + 1 < words.size() ? words.get(k + 1) : "";
            boolean curved = k + 2 < words.size() && CURVES.contains(words.get(k + 2));
            if (keys.contains(key)) {
                attributes.add(key + " " + value);
            }
            k += curved ? 1 : 0;
        }
        return update(words.get(0) + " " + words.get(1), attributes);
    }

    /** @param attributes each a key and its value; they are sorted */
    static String update(String idAndTime, List<String> attributes) {
        attributes.sort(null);
        return UPDATE + idAndTime + (attributes.isEmpty() ? "" : " " + String.join(" ", attributes));
    }

    /** Parts of a text, which may be empty; nothing is split between single quotes. */
    private static List<String> split(String text, char separator) {
        List<String> parts = new ArrayList<>();
        boolean quoted = false;
        int from = 0;
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            if (c == '\'' && !(quoted && text.charAt(k - 1) == '\\')) {
                quoted = !quoted;
            } else if (c == separator && !quoted) {
                parts.add(text.substring(from, k));
                from = k + 1;
            }
        }
        parts.add(text.substring(from));
        return parts;
    }
}
