package steward.scene.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import steward.Internal;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonLiteral;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;
import steward.text.NearestName;

/**
 * One JSON object of a scene file, read field by field. Its reader reads every field it knows, stating what the field
 * has to be, and at the end calls {@link #done()}, which refuses the fields that were not read. Every method that reads
 * throws a {@link SceneException}, located in the file, if a field is not as expected; a field is required unless the
 * method takes a default. A {@code null} in the file is not absence but an error.
 *
 * <p>Not thread-safe: a block remembers which fields were read.
 */
public final class Block {

    /** The largest length, mass, speed or impulse that a scene may state; see {@link #positive}. */
    public static final double MAXIMUM = 1e12;

    private static final String ABOVE_0 = "a number above 0";

    private final String source;
    private final String path;
    private final JsonObject object;
    private final Set<String> asked = new LinkedHashSet<>();
    private final Map<String, Block> children = new LinkedHashMap<>();

    @Internal
    public Block(String source, String path, JsonObject object) {
        this.source = source;
        this.path = path;
        this.object = object;
    }

    /** The names from the root to here, as in {@code field.walls[2]}; empty for the root. */
    public String path() {
        return path;
    }

    /** Where this object begins, as {@code FILE:LINE:COLUMN}. */
    public String place() {
        return source + ":" + object.place().line() + ":" + object.place().column();
    }

    /** True if the field is present, with any value. Counts as reading it. */
    public boolean has(String name) {
        return ask(name) != null;
    }

    /** True if the field is present and a string. */
    public boolean isText(String name) {
        return ask(name) instanceof JsonText;
    }

    /** True if the field is present and an array. */
    public boolean isArray(String name) {
        return ask(name) instanceof JsonArray;
    }

    /** True if the field is present and an object. */
    public boolean isBlock(String name) {
        return ask(name) instanceof JsonObject;
    }

    /**
     * A finite number.
     *
     * @param low  the least allowed; may be infinite
     * @param high the greatest allowed; may be infinite
     */
    public double number(String name, double low, double high) {
        String expected = Wording.range(low, high);
        double value = finite(name, expected);
        if (!(value >= low && value <= high)) {
            throw unexpected(name, expected);
        }
        return value;
    }

    /** Reads a field as the method without {@code whenAbsent} does, which is the value of an absent field. */
    public double number(String name, double low, double high, double whenAbsent) {
        return has(name) ? number(name, low, high) : whenAbsent;
    }

    /** A number above 0, neither so small nor so large that arithmetic with it could end in infinity: 1e-12..1e12. */
    public double positive(String name) {
        return sized(name, finite(name, ABOVE_0), ABOVE_0);
    }

    private double sized(String name, double value, String expected) {
        if (!(value > 0)) {
            throw unexpected(name, expected);
        }
        if (value < 1 / MAXIMUM || value > MAXIMUM) {
            throw unexpected(name, "1e-12..1e12");
        }
        return value;
    }

    /** A mass: a number as {@link #positive}, or the string {@code "infinite"} for {@code POSITIVE_INFINITY}. */
    public double mass(String name) {
        if (ask(name) instanceof JsonText text && text.text().equals("infinite")) {
            return Double.POSITIVE_INFINITY;
        }
        String expected = ABOVE_0 + " or \"infinite\"";
        return sized(name, finite(name, expected), expected);
    }

    /** A whole number from low to high, in any notation (1e3 is one). */
    public int integer(String name, int low, int high) {
        String expected = "a whole number " + low + ".." + high;
        double value = finite(name, expected);
        if (value != Math.rint(value) || value < low || value > high) {
            throw unexpected(name, expected);
        }
        return (int) value;
    }

    /** Reads a field as the method without {@code whenAbsent} does, which is the value of an absent field. */
    public int integer(String name, int low, int high, int whenAbsent) {
        return has(name) ? integer(name, low, high) : whenAbsent;
    }

    /** {@code true} or {@code false}. */
    public boolean flag(String name) {
        if (ask(name) instanceof JsonLiteral literal && !literal.text().equals("null")) {
            return literal.text().equals("true");
        }
        throw unexpected(name, "true or false");
    }

    /** Reads a field as the method without {@code whenAbsent} does, which is the value of an absent field. */
    public boolean flag(String name, boolean whenAbsent) {
        return has(name) ? flag(name) : whenAbsent;
    }

    /** A string that is not blank. */
    public String text(String name) {
        if (ask(name) instanceof JsonText text && !text.text().isBlank()) {
            return text.text();
        }
        throw unexpected(name, "a text");
    }

    /**
     * The value that a string stands for.
     *
     * @param values by their names; an error lists them in the order of a {@code LinkedHashMap}, otherwise sorted
     */
    public <E> E choice(String name, Map<String, E> values) {
        Set<String> known = values instanceof LinkedHashMap ? values.keySet() : new TreeSet<>(values.keySet());
        if (!(ask(name) instanceof JsonText text)) {
            throw unexpected(name, Wording.oneOf(known));
        }
        if (!values.containsKey(text.text())) {
            throw unexpected(name, Wording.choice(text.text(), known));
        }
        return values.get(text.text());
    }

    /** Reads a field as the method without {@code whenAbsent} does, which is the value of an absent field. */
    public <E> E choice(String name, Map<String, E> values, E whenAbsent) {
        return has(name) ? choice(name, values) : whenAbsent;
    }

    /** An object. */
    public Block block(String name) {
        if (ask(name) instanceof JsonObject value) {
            return child(pathOf(name), value);
        }
        throw unexpected(name, "an object");
    }

    /** An object, or empty if the field is absent. */
    public Optional<Block> optionalBlock(String name) {
        return has(name) ? Optional.of(block(name)) : Optional.empty();
    }

    /** An array of objects; may be empty. */
    public List<Block> blocks(String name) {
        List<Block> blocks = new ArrayList<>();
        for (JsonValue value : array(name, "an array of objects")) {
            String at = pathOf(name) + "[" + blocks.size() + "]";
            if (!(value instanceof JsonObject child)) {
                throw problem(value.place(), at, value.shown(), "an object");
            }
            blocks.add(child(at, child));
        }
        return blocks;
    }

    /** An array of strings; may be empty. */
    public List<String> texts(String name) {
        List<String> texts = new ArrayList<>();
        for (JsonValue value : array(name, "an array of strings")) {
            if (!(value instanceof JsonText text)) {
                throw problem(value.place(), pathOf(name) + "[" + texts.size() + "]", value.shown(), "a string");
            }
            texts.add(text.text());
        }
        return texts;
    }

    /** An array of so many finite numbers from low to high. */
    public double[] numbers(String name, int count, double low, double high) {
        List<JsonValue> values = array(name, "an array of " + count + " numbers");
        double[] numbers = values.stream().mapToDouble(value -> value instanceof JsonNumber number
            ? Double.parseDouble(number.text()) : Double.NaN).toArray();
        for (int k = 0; k < numbers.length; k++) {
            if (!(numbers[k] >= low && numbers[k] <= high)) {
                throw problem(values.get(k).place(), pathOf(name) + "[" + k + "]", values.get(k).shown(),
                    Wording.range(low, high));
            }
        }
        if (numbers.length != count) {
            throw error(name, numbers.length + " numbers", Integer.toString(count));
        }
        return numbers;
    }

    private List<JsonValue> array(String name, String expected) {
        if (ask(name) instanceof JsonArray array) {
            return array.values();
        }
        throw unexpected(name, expected);
    }

    /**
     * An error about a field for its reader to throw, located at the field's value, or at this object if it is absent.
     *
     * @param found    such as {@code "3 checkpoints"}
     * @param expected such as {@code "at least 2"}
     */
    public SceneException error(String name, String found, String expected) {
        Entry entry = object.entries().get(name);
        return problem(entry == null ? object.place() : entry.value().place(), pathOf(name), found, expected);
    }

    /** An error about this object as a whole. */
    public SceneException error(String found, String expected) {
        return problem(object.place(), path, found, expected);
    }

    /**
     * Locates the refusal of a constructor that was given this block's values. A message like
     * {@code impact law: batchWindow 0.1, expected 0} is about the field it names, any other about this object.
     */
    public SceneException error(IllegalArgumentException refusal) {
        String message = String.valueOf(refusal.getMessage());
        String plain = message.substring(message.indexOf(": ") < 0 ? 0 : message.indexOf(": ") + 2);
        int split = plain.indexOf(", expected ");
        if (split < 0) {
            return error(plain, "values that go together");
        }
        String expected = plain.substring(split + ", expected ".length());
        String field = plain.split(" ", 2)[0];
        return asked.contains(field)
            ? error(field, shown(field), expected) : error(plain.substring(0, split), expected);
    }

    /**
     * Refuses fields that were not read, here and in all blocks that were handed out from here.
     *
     * @throws SceneException located at the first such field's name; suggests the nearest name that was read
     */
    public void done() {
        object.entries().forEach((name, entry) -> {
            if (!asked.contains(name)) {
                throw problem(entry.place(), pathOf(name), "an unknown field",
                    asked.isEmpty() ? "no fields" : Wording.choice(name, asked));
            }
        });
        children.values().forEach(Block::done);
    }

    /** This object on one line, as it was read. */
    public String json() {
        return JsonTree.write(object);
    }

    /**
     * This object on one line, with other values in a block of it.
     *
     * @param block  the name of the block, which is there
     * @param values fields of it with their values as JSON; behind the others if they are new
     */
    @Internal
    public String json(String block, Map<String, String> values) {
        JsonObject inner = (JsonObject) object.entries().get(block).value();
        Map<String, Entry> entries = new LinkedHashMap<>(inner.entries());
        values.forEach((name, value) ->
            entries.put(name, new Entry(inner.place(), new JsonLiteral(inner.place(), value))));
        return with(block, new JsonObject(inner.place(), entries)).json();
    }

    /** True if the field is present, without counting as reading it: {@link #done()} may still refuse it. */
    public boolean contains(String name) {
        return object.entries().containsKey(name);
    }

    /** Returns how errors name the file. */
    public String source() {
        return source;
    }

    /** The fields as they were read. */
    @Internal
    public Map<String, Entry> entries() {
        return object.entries();
    }

    /** A copy with another object in a field that has been read completely; fields that were read stay so. */
    @Internal
    public Block with(String name, JsonObject value) {
        Map<String, Entry> entries = new LinkedHashMap<>(object.entries());
        entries.put(name, new Entry(entries.get(name).place(), value));
        Block changed = new Block(source, path, new JsonObject(object.place(), entries));
        changed.asked.addAll(asked);
        children.forEach((key, child) -> {
            if (!key.equals(pathOf(name))) {
                changed.children.put(key, child);
            }
        });
        return changed;
    }

    private JsonValue ask(String name) {
        asked.add(name);
        Entry entry = object.entries().get(name);
        return entry == null ? null : entry.value();
    }

    private double finite(String name, String expected) {
        if (ask(name) instanceof JsonNumber number) {
            double value = Double.parseDouble(number.text());
            if (Double.isFinite(value)) {
                return value;
            }
        }
        if (ask(name) instanceof JsonText text) {
            throw error(name, "the text " + text.shown(), expected);
        }
        throw unexpected(name, expected);
    }

    /** A block of the same object, so that the fields read by two readers add up. */
    private Block child(String childPath, JsonObject value) {
        return children.computeIfAbsent(childPath, key -> new Block(source, key, value));
    }

    private String pathOf(String name) {
        return path.isEmpty() ? name : path + "." + name;
    }

    /** Returns how an error names the value of a field. */
    public String shown(String name) {
        Entry entry = object.entries().get(name);
        return entry == null ? "nothing" : entry.value().shown();
    }

    /**
     * The error for a value that is not as expected; if the field is absent, the nearest name that was not read is
     * suggested.
     */
    private SceneException unexpected(String name, String expected) {
        if (object.entries().containsKey(name)) {
            return error(name, shown(name), expected);
        }
        List<String> others = object.entries().keySet().stream().filter(other -> !asked.contains(other)).toList();
        String hint = NearestName.of(name, others).map(other -> "; the nearest field here is \"" + other + "\" in line "
            + object.entries().get(other).place().line()).orElse("");
        return error(name, "nothing", expected + hint);
    }

    private SceneException problem(SourcePosition place, String at, String found, String expected) {
        return SceneException.at(source, place, at, "found " + found + ", expected " + expected);
    }
}
