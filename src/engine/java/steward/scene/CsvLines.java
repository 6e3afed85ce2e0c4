package steward.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import steward.scene.json.Block;
import steward.scene.json.JsonLimits;
import steward.scene.json.JsonValue;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;
import steward.scene.json.SceneException;
import steward.scene.json.SourcePosition;

/**
 * Lines of CSV files, copied into a scene, so that leagues, replays and workers have them. In a block of a scene
 * {@code "csv": "NAME"} names a file in the scene's folder; it becomes
 * {@code "csv": {"file": "NAME", "lines": ["x,y,radius", "1,2,3"]}}. If the table has states by turn, its first column
 * is {@code turn}, and only the last turn is copied; then {@code "from"} is the line of its first row.
 */
final class CsvLines {

    private static final String FIELD = "csv";
    private static final Pattern TURN = Pattern.compile("\\s*turn\\s*(\\[[^\\]]*]\\s*)?,");

    /** Returns the scene with the lines of its files. */
    static Block takenIn(SceneText text, Block root) {
        Block taken = root;
        for (Map.Entry<String, Entry> block : root.entries().entrySet()) {
            if (block.getValue().value() instanceof JsonObject object && object.entries().get(FIELD) != null
                && object.entries().get(FIELD).value() instanceof JsonText name) {
                Map<String, Entry> entries = new LinkedHashMap<>(object.entries());
                Block of = root.block(block.getKey());
                entries.put(FIELD, new Entry(entries.get(FIELD).place(), lines(text, of, name)));
                taken = taken.with(block.getKey(), new JsonObject(object.place(), entries));
            }
        }
        return taken;
    }

    /** Returns the names of the files that the scene takes in, in its order. */
    static List<String> names(Block root) {
        List<String> names = new ArrayList<>();
        for (Entry block : root.entries().values()) {
            if (block.value() instanceof JsonObject object && object.entries().get(FIELD) != null
                && object.entries().get(FIELD).value() instanceof JsonText name) {
                names.add(name.text());
            }
        }
        return names;
    }

    private static JsonObject lines(SceneText text, Block block, JsonText name) {
        if (text.figures().isEmpty()) {
            throw block.error(FIELD, "the name of a file in a scene that is none", "\"file\" and \"lines\" of it");
        }
        List<JsonValue> lines = new ArrayList<>();
        int from = 2;
        String source = name.text();
        try {
            Path path = text.figures().get().resolveSibling(source);
            if (path.getNameCount() == 0 || !path.getFileName().toString().equals(source)) {
                throw block.error(FIELD, name.shown(), "a file's name without a folder");
            }
            String[] all = SceneFiles.decode(bytes(path, source), source).split("\r?\n", -1);
            from = lastTurn(all);
            for (int k = 0; k < all.length; k = k == 0 ? from - 1 : k + 1) {
                String line = all[k];
                lines.add(new JsonText(name.place(), line));
                if (line.length() > JsonLimits.TEXT) {
                    throw new SceneException(source + ":" + (k + 1) + ":1: found a line of " + line.length()
                        + " characters, expected at most " + JsonLimits.TEXT);
                }
            }
        } catch (InvalidPathException | IOException problem) {
            throw block.error(FIELD, name.shown() + ", which cannot be read", "a file in the folder of the scene");
        }
        if (lines.size() > 1 && ((JsonText) lines.get(lines.size() - 1)).text().isEmpty()) {
            lines.remove(lines.size() - 1);
        }
        if (lines.size() > JsonLimits.ROWS) {
            throw new SceneException(source + ":" + (JsonLimits.ROWS + 1) + ":1: found more lines, expected at most "
                + JsonLimits.ROWS);
        }
        SourcePosition place = name.place();
        Map<String, Entry> entries = new LinkedHashMap<>();
        entries.put("file", new Entry(place, name));
        entries.put("lines", new Entry(place, new JsonArray(place, lines)));
        if (from > 2) {
            entries.put("from", new Entry(place, new JsonNumber(place, Integer.toString(from))));
        }
        return new JsonObject(place, entries);
    }

    /** The line, from 1, at which the last turn of a table by turns begins; 2 for another table. */
    private static int lastTurn(String... lines) {
        int line = lines.length;
        while (line > 1 && lines[line - 1].isBlank()) {
            line--;
        }
        if (line < 2 || !TURN.matcher(lines[0]).lookingAt()) {
            return 2;
        }
        String turn = lines[line - 1].split(",", 2)[0].strip();
        while (line > 2 && lines[line - 2].split(",", 2)[0].strip().equals(turn)) {
            line--;
        }
        return line;
    }

    private static byte[] bytes(Path path, String source) throws IOException {
        try (InputStream in = Files.newInputStream(path)) {
            byte[] bytes = in.readNBytes(JsonLimits.ROW_BYTES + 1);
            if (bytes.length > JsonLimits.ROW_BYTES) {
                throw new SceneException(source + ": found a file of more than " + JsonLimits.ROW_BYTES
                    + " bytes, expected at most " + JsonLimits.ROW_BYTES);
            }
            return bytes;
        }
    }
}
