package steward.scene;

import java.util.List;
import java.util.TreeMap;
import steward.numerics.StateHash;
import steward.scene.json.Block;
import steward.scene.json.JsonValue;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;

/**
 * Key of everything in a scene that decides what happens in its games. It leaves out the name, the time limits, the
 * accuracy and the name of the JSON Schema. Neither the order of fields nor the notation of numbers matters (1, 1.0,
 * 1e0).
 */
public final class SceneKey {

    private static final List<String> LEFT_OUT = List.of(SceneReader.SCHEMA, "name", "time", "accuracy");

    private SceneKey() { }

    /** A hash of the rest of the scene: 16 hexadecimal digits. */
    public static String of(Scene scene) {
        return of(scene.root());
    }

    static String of(Block root) {
        StringBuilder text = new StringBuilder();
        new TreeMap<>(root.entries()).forEach((name, entry) -> {
            if (!LEFT_OUT.contains(name)) {
                append(text.append(name.length()).append(name), entry.value());
            }
        });
        StateHash hash = new StateHash().add(text.length());
        text.chars().forEach(hash::add);
        return StateHash.toHex(hash.value());
    }

    /** Lengths and brackets make the text of different values different. */
    private static void append(StringBuilder text, JsonValue value) {
        if (value instanceof JsonObject object) {
            text.append('{');
            new TreeMap<>(object.entries()).forEach((name, entry) ->
                append(text.append(name.length()).append(name), entry.value()));
            text.append('}');
        } else if (value instanceof JsonArray array) {
            text.append('[');
            array.values().forEach(each -> append(text, each));
            text.append(']');
        } else if (value instanceof JsonText word) {
            text.append('"').append(word.text().length()).append(word.text());
        } else if (value instanceof JsonNumber number) {
            text.append(Long.toHexString(Double.doubleToLongBits(Double.parseDouble(number.text()) + 0.0))).append(',');
        } else {
            text.append(value.shown()).append(',');
        }
    }
}
