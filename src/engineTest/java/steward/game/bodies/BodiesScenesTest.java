package steward.game.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.Game;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.physics.Bodies;
import steward.physics.Wall;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** Scenes of bodies: listed, from a CSV file, laid out; and what is refused, with its place. */
class BodiesScenesTest {

    private static final String HEAD = """
        { "name": "s", "game": "bodies", "players": 0,
          "field": { "width": 1000, "height": 500, "walls": "box" },
          "bodies": {
        """;
    private static final String TAIL = """
          },
          "play": { "maximumTurns": 5 },
          "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    @TempDir
    private Path temp;

    private static GameSetup open(String bodies) {
        GameSetup setup = TestScenes.TYPES.open(HEAD + bodies + TAIL, "s.json");
        setup.check();
        return setup;
    }

    /** The bodies stand in the fourth line. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "listed": [ DISC, {"x": 60, "y": 50, "radius": 10} ] | 4:47: bodies.listed[1]: OVERLAPS at s.json:4:13, OWN
        "listed": [ SUN, {"x": 25, "y": 20, "radius": 1} ]   | 4:63: bodies.listed[1]: OVERLAPS "sun" at s.json:4:13
        "listed": [ {"x": 5, "y": 50, "radius": 10} ]        | 4:13: bodies.listed[0]: found a place in or behind wall 0
        "listed": [ {"x": -500, "y": 50, "radius": 10} ]     | 4:13: bodies.listed[0]: found a place in or behind wall 0
        "listed": [ {"x": 50, "y": "NaN", "radius": 10} ]    | 4:28: bodies.listed[0].y: found the text "NaN", expected
        "listed": [ {"owner": 0, "radius": 10} ]             | 4:23: bodies.listed[0].owner: found 0, expected none in a
        "listed": [ {"colour": "red", "radius": 10} ]        | 4:24: bodies.listed[0].colour: found "red", expected a
        "fill": {"count": 30, "radius": 60}                  | 4:9: bodies.fill: found room for \\d+ of 30 bodies, exp
        "fill": {"shape": "line", "count": 11, "radius": 10, "in": ENDS} | 4:9: bodies.fill: found room for 1 of 11 b
        "fill": {"count": 3, "radius": 60, "in": {"x": 99, "y": 99, "radius": 50}} | 4:9: bodies.fill: found room for 0
        "fill": {"count": 3, "radius": [9, 8]}               | 4:32: bodies.fill.radius: found 9.0 before 8.0, expected
        "csv": { "file": "discs.csv" }                       | 4:8: bodies.csv: found .*, expected the name of a file
        "fill": []                                           | 3:13: bodies: found no body, expected bodies that are
        """)
    void whatCannotBeIsRefusedWithItsPlace(String bodies, String message) {
        String text = bodies.replace("SUN", "{\"label\": \"sun\", \"x\": 20, \"y\": 20, \"radius\": 10}")
            .replace("DISC", "{\"x\": 50, \"y\": 50, \"radius\": 10}")
            .replace("ENDS", "{\"ax\": 20, \"ay\": 20, \"bx\": 119, \"by\": 20}");
        String regex = message.replace("OVERLAPS", "found a place that overlaps with the body")
            .replace("OWN", "expected a place of its own")
            .replaceAll("[\\[\\]{}]", "\\\\$0");
        String found = assertThrows(SceneException.class, () -> open(text)).getMessage();
        assertTrue(found.matches("s.json:" + regex + ".*"), found);
    }

    @Test
    void aBoxStandsAmongOtherWalls() {
        String walls = "[ {\"type\": \"segment\", \"ax\": 0, \"ay\": 0, \"bx\": 90, \"by\": 40}, "
            + "{\"type\": \"box\", \"restitution\": 0.5} ]";
        String listed = "\"listed\": [ {\"x\": 500, \"y\": 50, \"radius\": 10} ]";
        GameSetup setup = TestScenes.TYPES.open(HEAD.replace("\"box\"", walls) + listed + TAIL, "s.json");
        List<Wall> all = setup.scene().field().orElseThrow().walls();
        assertEquals(5, all.size());
        assertEquals(List.of(Wall.box(0, 0, 1000, 500, 0.5)), all.subList(1, 5));
    }

    @Test
    void aFillIsDrawnFromTheSeedOfTheMatchOrFromItsOwn() {
        GameSetup drawn = open("\"fill\": {\"count\": 100, \"radius\": [5, 15], \"speed\": 50}");
        assertEquals(drawn.create(1).hash(), drawn.create(1).hash());
        assertTrue(drawn.create(1).hash() != drawn.create(2).hash());
        GameSetup own = open("\"fill\": {\"count\": 100, \"radius\": [5, 15], \"seed\": 3}");
        assertEquals(own.create(1).hash(), own.create(2).hash());
        Bodies bodies = drawn.create(1).bodies();
        for (int i = 0; i < 100; i++) {
            assertTrue(bodies.radius[i] >= 5 && bodies.radius[i] <= 15);
            assertEquals(50, Math.hypot(bodies.vx[i], bodies.vy[i]), 1e-12);
            for (int j = 0; j < i; j++) {
                assertTrue(Math.hypot(bodies.x[i] - bodies.x[j], bodies.y[i] - bodies.y[j])
                    >= (bodies.radius[i] + bodies.radius[j]) * (1 - 1e-9), i + " overlaps with " + j);
            }
        }
    }

    @Test
    void aRowOfALatticeARingAndALineAreWhereTheyShouldBe() {
        Bodies lattice = open("\"fill\": {\"shape\": \"lattice\", \"count\": 8, \"radius\": 10}").create(0).bodies();
        assertEquals("125 125; 375 125; 625 125; 875 125; 125 375; 375 375; 625 375; 875 375", places(lattice));
        Bodies ring = open("\"fill\": {\"shape\": \"ring\", \"count\": 4, \"radius\": 10, \"in\": {\"x\": 500, \"y\": "
            + "250, \"radius\": 100}}").create(0).bodies();
        assertEquals("600 250; 500 350; 400 250; 500 150", places(ring));
        Bodies line = open("\"fill\": {\"shape\": \"line\", \"count\": 3, \"radius\": 10, \"in\": {\"ax\": 100, "
            + "\"ay\": 100, \"bx\": 200, \"by\": 300}}").create(0).bodies();
        assertEquals("100 100; 150 200; 200 300", places(line));
    }

    private static String places(Bodies bodies) {
        return IntStream.range(0, bodies.size()).mapToObj(k -> Math.round(bodies.x[k]) + " " + Math.round(bodies.y[k]))
            .collect(Collectors.joining("; "));
    }

    @Test
    void aCsvFileIsTakenIntoTheScene() throws IOException {
        GameSetup setup = csv("x,y,radius,mass,vx,label\n50,60,10,infinite,,a\n\n150,60.5,1e1,2,-3,b\n");
        Bodies bodies = setup.create(0).bodies();
        assertEquals(2, bodies.size());
        assertEquals(60.5, bodies.y[1]);
        assertEquals(-3, bodies.vx[1]);
        assertEquals(Double.POSITIVE_INFINITY, bodies.mass[0]);
        Game again = TestScenes.TYPES.open(setup.scene().json(), "elsewhere").create(0);
        assertEquals(setup.create(0).hash(), again.hash());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        x,y,radius;50,60,10;50,65,10        | 3:1: found a place that overlaps with the body at discs.csv:2:1, exp
        x,y,radius;50,nan,10                | 2:4: y: found the text "nan", expected a number -1e12..1e12
        x,y,radius;50,60                    | 2:1: found 2 cells, expected 3, as many as the first line has names
        x,y,radios;50,60,10                 | 1:1: found no column "radius" in x,y,radios, expected x, y, radius and
        x;y;radius;50;60;10                 | 1:1: found no column "y" in x, expected x, y, radius and others, separated
        x#y#radius;50#60#10                 | 1:1: found semicolons, expected names separated by commas
        x~y~radius;50~60~10                 | 1:1: found tabs, expected names separated by commas
        "x","y","radius";50,60,10           | 1:1: found quotes, expected names separated by commas
        // discs;x,y,radius;50,60,10        | 1:1: found a comment, expected names separated by commas
        x,y,radius;50#60#10                 | 2:1: found semicolons, expected cells separated by commas
        x,y,radius;50,60,"10"               | 2:7: found quotes, expected cells separated by commas, without quotes
        x,y,radius;// none;50,60,10         | 2:1: found a comment, expected cells separated by commas
        x,y,radius;1,60,10;.5.,60,10        | 3:1: x: found the text ".5.", expected a number -1e12..1e12
        x,y,radius,speed;50,60,10,1         | 1:12: speed: found an unknown field, expected one of
        ``                                  | 1:1: found no names, expected a line with the names of the columns
        x,y,x;50,60,10                      | 1:5: found the column "x" a second time, expected it once
        x,y,radius;50,60,-1                 | 2:7: radius: found -1, expected a number above 0
        """)
    void errorsOfACsvFileAreLocatedInIt(String lines, String message) {
        String found = assertThrows(SceneException.class, () -> csv(lines.replace(';', '\n').replace('#', ';')
            .replace('~', '\t'))).getMessage();
        assertTrue(found.startsWith("discs.csv:" + message), found);
    }

    @Test
    void numbersNeedNotBeThoseOfJson() throws IOException {
        Bodies bodies = csv("x [u],y[u],radius,vx\n+100.,060,.5e1,-.25\n").create(0).bodies();
        assertEquals(100, bodies.x[0]);
        assertEquals(60, bodies.y[0]);
        assertEquals(5, bodies.radius[0]);
        assertEquals(-0.25, bodies.vx[0]);
    }

    /** Bodies are those of the last turn; errors are still where they are in the file. */
    @Test
    void aTableOfStatesIsItsLastTurn() throws IOException {
        String states = "turn,id,x [u],y [u],radius [u]\n0,0,50,60,10\n0,1,90,60,10\n1,0,51,60,10\n1,1,91,60,RADIUS\n";
        GameSetup setup = csv(states.replace("RADIUS", "11"));
        Bodies bodies = setup.create(0).bodies();
        assertEquals("51 60; 91 60", places(bodies));
        assertEquals(setup.create(0).hash(), TestScenes.TYPES.open(setup.scene().json(), "elsewhere").create(0).hash());
        assertTrue(assertThrows(SceneException.class, () -> csv(states.replace("RADIUS", "-1"))).getMessage()
            .startsWith("discs.csv:5:11: radius: found -1, expected"));
    }

    @Test
    void wallsThatThereAreNotAreAnsweredWithThoseThatThereAre() {
        String found = assertThrows(SceneException.class, () -> TestScenes.TYPES.open(HEAD.replace("\"box\"",
            "\"periodic\"") + "\"fill\": {\"count\": 1, \"radius\": 5}" + TAIL, "s.json")).getMessage();
        assertEquals("s.json:2:53: field.walls: found \"periodic\", expected \"box\" or an array of walls, each of the "
            + "\"type\" \"arena\", \"box\", \"half-plane\" or \"segment\"", found);
    }

    /** 0.7071 is 1 / sqrt(2) to 1e-5; a disc that bounces keeps its speed. */
    @Test
    void aVectorOfFewDigitsIsMadeOne() {
        String walls = "[ {\"type\": \"half-plane\", \"x\": 500, \"y\": 0, \"insideX\": 0.7071, \"insideY\": 0.7071} ]";
        Game game = TestScenes.TYPES.open(HEAD.replace("\"box\"", walls) + "\"listed\": [ {\"x\": 500, \"y\": 50, "
            + "\"radius\": 10, \"vy\": -60} ]" + TAIL, "s.json").create(0);
        game.play();
        assertEquals(60, game.bodies().vx[0], 1e-12);
        assertEquals(0, game.bodies().vy[0], 1e-12);
    }

    @Test
    void aFileBesideTheSceneIsAllThatIsRead() throws IOException {
        assertTrue(assertThrows(SceneException.class, () -> read("../discs.csv")).getMessage()
            .contains("expected a file's name without a folder"));
        assertTrue(assertThrows(SceneException.class, () -> read("none.csv")).getMessage()
            .contains("bodies.csv: found \"none.csv\", which cannot be read"));
        assertTrue(assertThrows(SceneException.class, () -> open("\"csv\": \"discs.csv\"")).getMessage()
            .contains("found the name of a file in a scene that is none"));
    }

    private GameSetup csv(String text) throws IOException {
        Files.writeString(temp.resolve("discs.csv"), text);
        return read("discs.csv");
    }

    private GameSetup read(String name) throws IOException {
        Path scene = temp.resolve("s.json");
        Files.writeString(scene, HEAD + "\"csv\": \"" + name + "\"" + TAIL);
        Scene read = SceneReader.read(SceneFiles.load(scene.toString()), null);
        return TestScenes.TYPES.open(read);
    }
}
