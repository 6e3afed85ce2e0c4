package steward.cli.replay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import steward.cli.streams.Json;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;

/**
 * Map of the end of a recorded match, drawn with characters. It shows the field, its zones with their labels, the last
 * positions of each player's bodies, a letter per body, and the final positions of the others. It draws from the game's
 * own description and knows no game.
 */
public final class TextMap {

    private static final int WIDEST = 98;
    private static final int HIGHEST = 26;
    /** A character is about twice as high as it is wide. */
    private static final double CHARACTER_HEIGHT = 2.1;
    private static final int CIRCLE_STEPS = 240;
    private static final String LETTERS = "abcdefghijklmnopqrstuvwxyz";
    /** How many positions are drawn in all: more would hide each other. */
    private static final int PLACES = 160;

    private final double left;
    private final double top;
    private final double perColumn;
    private final double perRow;
    private final char[][] cells;

    private TextMap(Map<?, ?> field) {
        left = Json.number(field.get("x"));
        top = Json.number(field.get("y"));
        double width = Json.number(field.get("width"));
        double height = Json.number(field.get("height"));
        perColumn = Math.max(width / WIDEST, height / HIGHEST / CHARACTER_HEIGHT);
        perRow = perColumn * CHARACTER_HEIGHT;
        cells = new char[Math.min(HIGHEST, (int) Math.ceil(height / perRow))]
            [Math.min(WIDEST, (int) Math.ceil(width / perColumn))];
        for (char[] row : cells) {
            Arrays.fill(row, ' ');
        }
    }

    /** @param replay just opened, with a header; read to its end */
    public static String of(ReplayReader replay) {
        Map<String, Object> drawing = Json.object(replay.drawing());
        if (!(drawing.get("field") instanceof Map<?, ?> field)) {
            return "";
        }
        TextMap map = new TextMap(field);
        Map<Integer, List<double[]>> trails = new LinkedHashMap<>();
        Map<String, Object> end = end(replay, trails);
        trails.keySet().removeIf(body -> ownerOf(drawing, body) < 0);
        Map<Integer, Character> letters = letters(trails, drawing);
        List<Map<?, ?>> zones = new ArrayList<>(Json.objects(drawing.get("zones")));
        zones.addAll(Json.objects(end.get("zones")));
        for (Map<?, ?> zone : zones) {
            map.circle(zone, '.');
        }
        map.drawOthers(end, drawing);
        for (Map<?, ?> body : Json.objects(drawing.get("bodies"))) {
            if (body.containsKey("x")) {
                map.circle(body, '#');
            }
        }
        int turns = PLACES / Math.max(1, trails.size());
        trails.forEach((body, trail) -> trail.subList(Math.max(0, trail.size() - turns), trail.size())
            .forEach(place -> map.put(place[0], place[1], letters.get(body))));
        zones.forEach(map::label);
        return map.framed() + legend(replay, drawing, letters) + "(0) (1) ... zones; the last " + turns + " turns\n";
    }

    /** Collects the places of all bodies. @return the last outcome */
    private static Map<String, Object> end(ReplayReader replay, Map<Integer, List<double[]>> trails) {
        Map<String, Object> end = Json.object(replay.start());
        add(trails, end);
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            end = Json.object(turn.outcome());
            add(trails, end);
        }
        return end;
    }

    /** Bodies that are no player's, such as tankers. */
    private void drawOthers(Map<String, Object> end, Map<String, Object> drawing) {
        if (end.get("state") instanceof Map<?, ?> state) {
            for (Map<?, ?> body : Json.objects(state.get("bodies"))) {
                if (ownerOf(drawing, (int) Json.number(body.get("id"))) < 0) {
                    put(Json.number(body.get("x")), Json.number(body.get("y")), 'o');
                }
            }
        }
    }

    private static void add(Map<Integer, List<double[]>> trails, Map<String, Object> outcome) {
        if (outcome.get("state") instanceof Map<?, ?> state) {
            for (Map<?, ?> body : Json.objects(state.get("bodies"))) {
                trails.computeIfAbsent((int) Json.number(body.get("id")), id -> new ArrayList<>())
                    .add(new double[] {Json.number(body.get("x")), Json.number(body.get("y"))});
            }
        }
    }

    /** Small letters for the even players, capitals for the odd ones. */
    private static Map<Integer, Character> letters(Map<Integer, List<double[]>> trails, Map<String, Object> drawing) {
        Map<Integer, Character> letters = new LinkedHashMap<>();
        for (int body : trails.keySet()) {
            char letter = LETTERS.charAt(letters.size() % LETTERS.length());
            letters.put(body, ownerOf(drawing, body) % 2 == 1 ? Character.toUpperCase(letter) : letter);
        }
        return letters;
    }

    private static int ownerOf(Map<String, Object> drawing, int id) {
        return Json.objects(drawing.get("bodies")).stream().filter(body -> Json.number(body.get("id")) == id
            && body.containsKey("owner")).mapToInt(body -> (int) Json.number(body.get("owner"))).findFirst().orElse(-1);
    }

    private void put(double x, double y, char c) {
        int column = (int) Math.floor((x - left) / perColumn);
        int row = (int) Math.floor((y - top) / perRow);
        if (row >= 0 && row < cells.length && column >= 0 && column < cells[row].length) {
            cells[row][column] = c;
        }
    }

    private void circle(Map<?, ?> round, char c) {
        double radius = Json.number(round.get("radius"));
        for (int step = 0; step < CIRCLE_STEPS; step++) {
            double angle = 2 * Math.PI * step / CIRCLE_STEPS;
            put(Json.number(round.get("x")) + radius * Math.cos(angle),
                Json.number(round.get("y")) + radius * Math.sin(angle), c);
        }
    }

    /** The last word of a label: there is little room. */
    private void label(Map<?, ?> zone) {
        String words = Json.word(zone.get("label"), 0);
        String label = "(" + words.substring(words.lastIndexOf(' ') + 1) + ")";
        double x = Json.number(zone.get("x")) - perColumn * (label.length() / 2);
        for (int k = 0; k < label.length(); k++) {
            put(x + k * perColumn, Json.number(zone.get("y")), label.charAt(k));
        }
    }

    private String framed() {
        String edge = "+" + "-".repeat(cells[0].length) + "+\n";
        return Arrays.stream(cells).map(row -> "|" + new String(row) + "|\n")
            .collect(Collectors.joining("", edge, edge));
    }

    private static String legend(ReplayReader replay, Map<String, Object> drawing, Map<Integer, Character> letters) {
        StringBuilder text = new StringBuilder();
        for (int player = 0; player < replay.header().names().size(); player++) {
            for (Map.Entry<Integer, Character> letter : letters.entrySet()) {
                if (ownerOf(drawing, letter.getKey()) == player) {
                    text.append(letter.getValue()).append(' ');
                }
            }
            text.append(ReplayHeaderText.name(replay.header(), player)).append("    ");
        }
        return text.toString();
    }
}
