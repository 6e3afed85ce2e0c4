package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import steward.game.Game;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.scene.Bumper;
import steward.scene.Field;

/**
 * The picture of walls in {@code docs/scenes.md}: a panel for each row of its table of walls, drawn from the syntax
 * that stands there, with the path of a disc as the engine computes it. With {@code -Psteward.recordPictures=FOLDER}
 * {@code walls.svg} is written anew into a folder.
 */
class WallPictureTest {

    private static final Path PICTURE = Path.of("docs", "walls.svg");
    private static final Pattern ROW = Pattern.compile("\\| ([a-z-]+) \\| (?:in `bumpers`: )?`([^`]*)`.*");
    /** Pixels of a panel, and of the space around it. */
    private static final double PANEL = 150;
    private static final double SPACE = 16;
    private static final double LINE = 18;
    private static final int COLUMNS = 3;
    /** Side of the field, in u. */
    private static final double SIDE = 300;
    private static final int TURNS = 18;

    /** Rows of the table: the kind of wall, and its JSON. */
    private static Map<String, String> rows() throws IOException {
        Map<String, String> rows = new LinkedHashMap<>();
        for (String line : Files.readAllLines(Path.of("docs", "scenes.md"))) {
            Matcher row = ROW.matcher(line);
            if (row.matches()) {
                rows.put(row.group(1), row.group(2));
            }
        }
        return rows;
    }

    private static GameSetup scene(String kind, String json) {
        String place = kind.equals("bumper") ? "\"bumpers\": [" + json + "]"
            : "\"walls\": " + (json.startsWith("{") ? "[" + json + "]" : json);
        return TestScenes.TYPES.open("""
            { "name": "%s", "game": "bodies", "players": 0,
              "field": { "width": 300, "height": 300, %s },
              "bodies": { "listed": [ { "x": 150, "y": 150, "vx": -27, "vy": 19, "radius": 12 } ] },
              "play": { "maximumTurns": %d }, "accuracy": { "advance": "event", "arithmetic": "double" } }
            """.formatted(kind, place, TURNS), "docs/scenes.md");
    }

    private static String drawn() throws IOException {
        Map<String, String> rows = rows();
        StringBuilder panels = new StringBuilder();
        int panel = 0;
        for (Map.Entry<String, String> row : rows.entrySet()) {
            double x = SPACE + panel % COLUMNS * (PANEL + SPACE);
            double y = SPACE + LINE + panel / COLUMNS * (PANEL + SPACE + LINE);
            panels.append(tag("<g transform=\"translate(%s %s)\">", x, y)).append('\n')
                .append("<text y=\"-5\">").append(row.getKey()).append("</text>\n")
                .append(tag("<svg width=\"%s\" height=\"%s\" viewBox=\"0 0 %s %s\">", PANEL, PANEL, SIDE, SIDE))
                .append('\n').append(tag("<rect width=\"%s\" height=\"%s\" class=\"field\"/>", SIDE, SIDE))
                .append('\n').append(panel(scene(row.getKey(), row.getValue()))).append("</svg>\n</g>\n");
            panel++;
        }
        double width = SPACE + COLUMNS * (PANEL + SPACE);
        double height = SPACE + (panel + COLUMNS - 1) / COLUMNS * (PANEL + SPACE + LINE);
        return tag("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%s\" height=\"%s\" font-family=\"sans-serif\" "
            + "font-size=\"13\">", width, height) + """

            <style>
            text { fill: #777 }
            .field { fill: #8882 }
            .wall { fill: none; stroke: #2a78d6; stroke-width: 5 }
            .behind { fill: #2a78d655 }
            .path { fill: none; stroke: #c60; stroke-width: 2.5 }
            .disc { fill: #c60 }
            </style>
            """ + panels + "</svg>\n";
    }

    private static String panel(GameSetup setup) {
        StringBuilder out = new StringBuilder();
        Field field = setup.scene().field().orElseThrow();
        for (Wall wall : field.walls()) {
            out.append(wall(wall)).append('\n');
        }
        for (Bumper bumper : field.bumpers()) {
            out.append(tag("<circle cx=\"%s\" cy=\"%s\" r=\"%s\" class=\"wall behind\"/>", bumper.x(), bumper.y(),
                bumper.radius())).append('\n');
        }
        Game game = setup.create(0);
        String disc = tag("<circle cx=\"%s\" cy=\"%s\" r=\"%s\" class=\"disc\"/>", game.bodies().x[0],
            game.bodies().y[0], game.bodies().radius[0]);
        StringBuilder path = new StringBuilder(pair(game.bodies().x[0], game.bodies().y[0]));
        while (!game.isOver()) {
            game.play();
            TurnLog log = game.log();
            for (int k = 0; k < log.kept(); k++) {
                path.append(' ').append(pair(log.impact(k).ax(), log.impact(k).ay()));
            }
            path.append(' ').append(pair(game.bodies().x[0], game.bodies().y[0]));
        }
        return out.append("<polyline points=\"").append(path).append("\" class=\"path\"/>\n")
            .append(disc).append('\n').toString();
    }

    private static String wall(Wall wall) {
        if (wall instanceof Segment segment) {
            return tag("<line x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\" class=\"wall\"/>", segment.ax(), segment.ay(),
                segment.bx(), segment.by());
        }
        if (wall instanceof Arena arena) {
            return tag("<path d=\"M0 0H%s V%s H0z M%s %s a%s %s 0 1 0 1e-3 0z\" class=\"wall behind\"/>", SIDE, SIDE,
                arena.x(), arena.y() - arena.radius(), arena.radius(), arena.radius());
        }
        HalfPlane plane = (HalfPlane) wall;
        double far = 2 * SIDE;
        double alongX = -plane.insideY() * far;
        double alongY = plane.insideX() * far;
        return tag("<path d=\"M%s %s L%s %s l%s %s L%s %s z\" class=\"wall behind\"/>", plane.x() - alongX,
            plane.y() - alongY, plane.x() + alongX, plane.y() + alongY, -plane.insideX() * far,
            -plane.insideY() * far, plane.x() - alongX - plane.insideX() * far,
            plane.y() - alongY - plane.insideY() * far);
    }

    private static String pair(double x, double y) {
        return number(x) + "," + number(y);
    }

    private static String tag(String form, double... numbers) {
        Object[] texts = new Object[numbers.length];
        for (int k = 0; k < numbers.length; k++) {
            texts[k] = number(numbers[k]);
        }
        return form.formatted(texts);
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value).replaceFirst("^-?(0)\\.0$|\\.0$", "$1");
    }

    @Test
    void thePictureIsThatOfTheSyntax() throws IOException {
        assertEquals("[box, segment, half-plane, arena, bumper, curve]", rows().keySet().toString());
        assertEquals(drawn(), Files.readString(PICTURE),
            "./gradlew test --tests '*WallPictureTest' -Psteward.recordPictures=docs draws it anew");
        assertTrue(Files.readString(Path.of("docs", "scenes.md")).contains("(walls.svg)"));
    }

    @Test
    @EnabledIfSystemProperty(named = "steward.recordPictures", matches = ".+",
        disabledReason = "pictures are recorded on demand, -Psteward.recordPictures=FOLDER")
    void thePictureIsDrawnAnew() throws IOException {
        Path folder = Files.createDirectories(Path.of(System.getProperty("steward.recordPictures")));
        Files.writeString(folder.resolve("walls.svg"), drawn());
    }
}
