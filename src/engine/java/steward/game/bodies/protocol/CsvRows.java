package steward.game.bodies.protocol;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
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
 * Converter of a CSV file's rows to the blocks of a list of discs. The first line names the fields, with or without
 * their units, as in {@code x [u]}. Errors are located in the file, by line and column. Cells are split at commas and
 * have no quotes; an empty cell is an absent field. The columns {@code turn} and {@code id} of a table of states are
 * ignored.
 */
final class CsvRows {

    /** Number, also as {@code .5}, {@code 100.} and {@code +1}, which JSON has not. */
    private static final Pattern NUMBER = Pattern.compile(
        "([+-]?)0*(?=\\.?[0-9])([0-9]*)(?:\\.([0-9]*))?([eE][+-]?[0-9]+)?");
    private static final Pattern UNIT = Pattern.compile("\\s*\\[[^\\]]*]$");
    private static final Set<String> READ_OVER = Set.of("turn", "id");
    private static final List<String> REQUIRED = List.of("x", "y", "radius");
    private static final Set<String> TEXTS = Set.of("label", "colour");

    private final String file;
    private final List<String> lines;
    /** The line of the first row in the file. */
    private final int first;
    private final List<String> names = new ArrayList<>();
    private final List<SourcePosition> places = new ArrayList<>();

    /** @param csv {@code file}, {@code lines} and {@code from}, as {@link steward.scene.CsvLines} puts them */
    CsvRows(Block csv) {
        file = csv.text("file");
        lines = csv.texts("lines");
        first = csv.integer("from", 2, Integer.MAX_VALUE, 2);
        if (!lines.isEmpty()) {
            refuseOtherForms(lines.get(0), 1, "names");
        }
        if (lines.isEmpty() || lines.get(0).isBlank()) {
            throw new SceneException(file + ":1:1: found no names, expected a line with the names of the columns");
        }
        Set<String> seen = new TreeSet<>();
        int column = 1;
        for (String cell : lines.get(0).split(",", -1)) {
            String name = UNIT.matcher(cell.strip()).replaceFirst("");
            if (!seen.add(name)) {
                throw new SceneException(file + ":1:" + column + ": found the column \"" + name
                    + "\" a second time, expected it once");
            }
            names.add(name);
            places.add(new SourcePosition(1, column));
            column += cell.length() + 1;
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
            .mapToObj(k -> row(lines.get(k), k - 1 + first)).toList();
    }

    /** Names what is written otherwise than here: comments, quotes, and other separators. */
    private void refuseOtherForms(String line, int number, String what) {
        String start = line.stripLeading();
        boolean isText = !names.isEmpty() && TEXTS.contains(names.get(0));
        String found = !isText && (start.startsWith("#") || start.startsWith("//")) ? "a comment"
            : line.indexOf('"') >= 0 ? "quotes" : line.indexOf(',') >= 0 ? null
            : line.indexOf(';') >= 0 ? "semicolons" : line.strip().indexOf('\t') >= 0 ? "tabs" : null;
        if (found != null) {
            throw new SceneException(file + ":" + number + ":" + (1 + Math.max(0, found.equals("quotes")
                ? line.indexOf('"') : line.indexOf(start))) + ": found " + found + ", expected " + what
                + " separated by commas, without quotes and comments");
        }
    }

    /** A number as JSON has it, or {@code null}. */
    private static String number(String cell) {
        Matcher number = NUMBER.matcher(cell);
        if (!number.matches()) {
            return null;
        }
        String fraction = number.group(3) == null || number.group(3).isEmpty() ? "" : "." + number.group(3);
        return (number.group(1).equals("-") ? "-" : "") + (number.group(2).isEmpty() ? "0" : number.group(2)) + fraction
            + (number.group(4) == null ? "" : number.group(4));
    }

    private Block row(String text, int number) {
        refuseOtherForms(text, number, "cells");
        String[] cells = text.split(",", -1);
        if (cells.length != names.size()) {
            throw new SceneException(file + ":" + number + ":1: found " + cells.length + " cells, expected "
                + names.size() + ", as many as the first line has names");
        }
        Map<String, Entry> entries = new LinkedHashMap<>();
        int column = 1;
        for (int k = 0; k < cells.length; k++) {
            String cell = cells[k].strip();
            String name = names.get(k);
            if (!cell.isEmpty() && !READ_OVER.contains(name)) {
                SourcePosition place = new SourcePosition(number, column);
                String digits = TEXTS.contains(name) ? null : number(cell);
                JsonValue value = digits != null ? new JsonNumber(place, digits) : new JsonText(place, cell);
                entries.put(name, new Entry(places.get(k), value));
            }
            column += cells[k].length() + 1;
        }
        return new Block(file, "", new JsonObject(new SourcePosition(number, 1), entries));
    }
}
