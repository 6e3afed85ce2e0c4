package steward.game.bodies.protocol;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import steward.scene.json.Block;
import steward.scene.json.JsonValue;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;
import steward.scene.json.SceneException;
import steward.scene.json.SourcePosition;

/**
 * Rows of a CSV file as the blocks that a list of discs would have: the first line names the fields. Errors are located
 * in the file, by line and column. Cells are split at commas and have no quotes; an empty cell is an absent field.
 */
final class CsvRows {

    private static final Pattern NUMBER = Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?");
    private static final List<String> REQUIRED = List.of("x", "y", "radius");
    private static final Set<String> TEXTS = Set.of("label", "colour");

    private final String file;
    private final List<String> lines;
    private final List<String> names = new ArrayList<>();
    private final List<SourcePosition> places = new ArrayList<>();

    /** @param csv {@code file} and {@code lines}, as {@link steward.scene.CsvLines} puts them */
    CsvRows(Block csv) {
        file = csv.text("file");
        lines = csv.texts("lines");
        if (lines.isEmpty() || lines.get(0).isBlank()) {
            throw new SceneException(file + ":1:1: found no names, expected a line with the names of the columns");
        }
        Set<String> seen = new TreeSet<>();
        for (String name : lines.get(0).split(",", -1)) {
            SourcePosition place = new SourcePosition(1, places.isEmpty() ? 1 : places.get(places.size() - 1).column()
                + names.get(names.size() - 1).length() + 1);
            if (!seen.add(name.strip())) {
                throw new SceneException(file + ":1:" + place.column() + ": found the column \"" + name.strip()
                    + "\" a second time, expected it once");
            }
            names.add(name);
            places.add(place);
        }
        for (String name : REQUIRED) {
            if (!seen.contains(name)) {
                throw new SceneException(file + ":1:1: found no column \"" + name + "\" in " + lines.get(0).strip()
                    + ", expected " + String.join(", ", REQUIRED) + " and others, separated by commas");
            }
        }
    }

    /** The rows; blank lines are left out. */
    List<Block> blocks() {
        return IntStream.range(1, lines.size()).filter(k -> !lines.get(k).isBlank())
            .mapToObj(k -> row(lines.get(k), k + 1)).toList();
    }

    private Block row(String text, int number) {
        String[] cells = text.split(",", -1);
        if (cells.length != names.size()) {
            throw new SceneException(file + ":" + number + ":1: found " + cells.length + " cells, expected "
                + names.size() + ", as many as the first line has names");
        }
        Map<String, Entry> entries = new LinkedHashMap<>();
        int column = 1;
        for (int k = 0; k < cells.length; k++) {
            String cell = cells[k].strip();
            if (!cell.isEmpty()) {
                SourcePosition place = new SourcePosition(number, column);
                String name = names.get(k).strip();
                JsonValue value = !TEXTS.contains(name) && NUMBER.matcher(cell).matches()
                    ? new JsonNumber(place, cell) : new JsonText(place, cell);
                entries.put(name, new Entry(places.get(k), value));
            }
            column += cells[k].length() + 1;
        }
        return new Block(file, "", new JsonObject(new SourcePosition(number, 1), entries));
    }
}
