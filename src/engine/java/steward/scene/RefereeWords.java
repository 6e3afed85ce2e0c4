package steward.scene;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.scene.json.Block;
import steward.scene.json.JsonValue;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;

/**
 * Paths of files that a scene's own referee names in the scene's folder, resolved as for CSV files. If a word of its
 * command or an entry of its class path is the relative path of a file there, it becomes a path from the current
 * folder.
 */
final class RefereeWords {

    private RefereeWords() { }

    /** Returns the scene with these paths; the scene itself if it names no such file. */
    static Block found(Block root, Path scene) {
        Entry referee = root.entries().get(SceneReader.REFEREE);
        if (scene.getParent() == null || referee == null || !(referee.value() instanceof JsonObject block)) {
            return root;
        }
        Map<String, Entry> entries = new LinkedHashMap<>(block.entries());
        boolean any = false;
        for (String name : List.of("command", "classPath")) {
            if (entries.get(name) != null && entries.get(name).value() instanceof JsonArray words) {
                JsonArray found = found(words, scene, name.equals("command"));
                any |= found != null;
                entries.put(name, found == null ? entries.get(name) : new Entry(entries.get(name).place(), found));
            }
        }
        return any ? root.with(SceneReader.REFEREE, new JsonObject(block.place(), entries)) : root;
    }

    /** The words with their paths, or {@code null} if there is none. @param program whether the first is a program */
    private static JsonArray found(JsonArray words, Path scene, boolean program) {
        List<JsonValue> found = new ArrayList<>();
        for (JsonValue word : words.values()) {
            boolean sought = found.isEmpty() && program;      // on the PATH, if it has no slash
            found.add(word instanceof JsonText text && (!sought || text.text().indexOf('/') >= 0)
                && isBeside(text.text(), scene)
                ? new JsonText(word.place(), scene.resolveSibling(text.text()).normalize().toString()) : word);
        }
        return found.equals(words.values()) ? null : new JsonArray(words.place(), found);
    }

    private static boolean isBeside(String word, Path scene) {
        try {
            return !word.isBlank() && !Path.of(word).isAbsolute() && Files.exists(scene.resolveSibling(word));
        } catch (InvalidPathException noPath) {
            return false;
        }
    }
}
