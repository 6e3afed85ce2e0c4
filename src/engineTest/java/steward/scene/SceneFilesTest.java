package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.Motion;
import steward.scene.json.SceneException;

/** Scene files are found by path or by name, and the shipped ones are whole. */
class SceneFilesTest {

    private static final Path FOLDER = Path.of("config/scenes");

    @TempDir
    Path temp;

    /** The names in the code are those of the folder. */
    @Test
    void theListOfShippedScenesIsTheFolder() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER).filter(file -> !file.toString().endsWith(".accuracy.json"))) {
            assertEquals(files.map(file -> file.getFileName().toString()).sorted().toList(),
                SceneFiles.SHIPPED.stream().map(name -> name + ".json").toList());
        }
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void everyShippedSceneReadsAndIsNamedLikeItsFile(String name) {
        SceneText file = SceneFiles.load(FOLDER.resolve(name + ".json").toString());
        Scene scene = SceneReader.read(file.text(), file.source());
        assertEquals(name, scene.name());
        String game = List.of("fantastic-bits", "mean-max", "poker-chip-race", "search-race").stream()
            .filter(name::startsWith).findFirst().orElse(BODIES.contains(name) ? "bodies" : "pod-race");
        assertEquals(game, scene.gameId());
        assertEquals(scene, SceneReader.read(scene.json(), "again"));
    }

    @Test
    void aCopyHasTheFilesThatBelongToTheScene() throws IOException {
        Path scene = Files.writeString(temp.resolve("s.json"), "{ \"bodies\": { \"csv\": \"discs.csv\" } }");
        Files.writeString(temp.resolve("discs.csv"), "x,y,radius");
        Files.writeString(temp.resolve("s.accuracy.json"), "figures");
        Path folder = Files.createDirectory(temp.resolve("league"));
        SceneFiles.copy(scene, folder.resolve("scene.json"));
        assertEquals("x,y,radius", Files.readString(folder.resolve("discs.csv")));
        assertEquals("figures", Files.readString(folder.resolve("scene.accuracy.json")));
        assertEquals(Files.readString(scene), Files.readString(folder.resolve("scene.json")));
    }

    private static final List<String> BODIES =
        List.of("avalanche", "billiards", "bowl", "bullets", "cradle", "dense-box", "gas");

    static List<String> shipped() {
        return SceneFiles.SHIPPED;
    }

    @Test
    void theOfficialSceneIsTheOfficialLaw() {
        for (String name : List.of("mad-pod-racing", "duel")) {
            Scene scene = fromFolder(name);
            assertEquals(ImpactLaw.OFFICIAL_POD_RACE, scene.law());
            assertEquals(Arithmetic.OFFICIAL, scene.accuracy().arithmetic());
            assertTrue(scene.motion().step(Motion.Of.VELOCITY) != null
                && scene.motion().step(Motion.Of.POSITION) != null && scene.field().isEmpty());
        }
    }

    @Test
    void theWalledRaceHasABoxAndBumpersInside() {
        Field field = fromFolder("walled-race").field().get();
        assertEquals(4, field.walls().size());
        assertEquals(3, field.bumpers().size());
        for (Bumper bumper : field.bumpers()) {
            assertTrue(field.walls().stream().allMatch(wall -> wall.gap(bumper.x(), bumper.y(), bumper.radius()) > 800),
                bumper + " leaves room for a pod on every side");
        }
    }

    @Test
    void aShippedNameIsFoundWhereTheProgramHasItsResources() {
        for (String name : SceneFiles.shipped()) {
            assertEquals(SceneFiles.load(name), SceneFiles.load(name + ".json"));
            assertEquals("scenes/" + name + ".json", SceneFiles.load(name).source());
            assertEquals(fromFolder(name), SceneReader.read(SceneFiles.load(name).text(), name));
        }
    }

    @Test
    void whatIsNotThereIsSaidWithTheNamesThereAre() {
        String message = refused("mad-pod-racign");
        assertTrue(message.startsWith("mad-pod-racign: found no such file, expected a scene file"), message);
        if (!SceneFiles.shipped().isEmpty()) {
            assertTrue(message.endsWith(" or one of \"avalanche\", \"billiards\", \"bowl\", \"bullets\", "
                + "\"cradle\", \"dense-box\", \"duel\", \"fantastic-bits-contest\", \"fantastic-bits\", \"gas\", "
                + "\"mad-pod-racing-silver\", \"mad-pod-racing\", \"mean-max\", \"poker-chip-race\", "
                + "\"search-race\", \"walled-race\"; did you mean \"mad-pod-racing\"?"), message);
        }
        assertTrue(refused("no\0name").startsWith("no\0name: found no such file"));
        assertTrue(refused("").startsWith("\"\": found no such file"));
        assertTrue(refused(temp.toString()).startsWith(temp + ": found a folder, expected a scene file"));
    }

    /** A bot's binary is often called like the game that it plays. */
    @Test
    void aNameOfAShippedSceneIsNeverAFile() throws IOException {
        Path here = Path.of("duel");
        assumeTrue(!SceneFiles.shipped().isEmpty() && !Files.exists(here));
        Files.write(here, new byte[] {0x7f, 'E', 'L', 'F'});
        try {
            assertEquals("scenes/duel.json", SceneFiles.load("duel").source());
            assertEquals(Optional.empty(), SceneFiles.file("duel"));
            assertEquals(Optional.of(Path.of("./duel")), SceneFiles.file("./duel"));
        } finally {
            Files.delete(here);
        }
        Path other = Files.writeString(Path.of("some-bot"), "x");
        try {
            assertTrue(refused("some-bot").startsWith(
                "some-bot: found a file that is named like no scene (write ./some-bot), expected a scene file"),
                refused("some-bot"));
        } finally {
            Files.delete(other);
        }
    }

    @Test
    void aFileMustBeUtf8() throws IOException {
        Path file = temp.resolve("latin.json");
        Files.write(file, "{ \"name\": \"é\" }".getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(file + ":1:12: found the byte 0xE9, which is not UTF-8 here, expected a text in UTF-8",
            refused(file.toString()));
    }

    @Test
    void aFileEndsAtFourMebibytes() throws IOException {
        Path file = Files.writeString(temp.resolve("long.json"), " ".repeat(4 << 20));
        assertEquals(4 << 20, SceneFiles.load(file.toString()).text().length());
        Files.writeString(file, " ".repeat((4 << 20) + 1));
        assertEquals(file + ": found a file of more than 4194304 bytes, expected a scene of at most 4194304",
            refused(file.toString()));
    }

    @Test
    void aByteOrderMarkIsNotPartOfTheText() throws IOException {
        Path file = Files.writeString(temp.resolve("marked.json"), "\ufeff{}");
        assertEquals(new SceneText("{}", file.toString(), Optional.of(temp.resolve("marked.accuracy.json"))),
            SceneFiles.load(file.toString()));
    }

    private static Scene fromFolder(String name) {
        SceneText file = SceneFiles.load(FOLDER.resolve(name + ".json").toString());
        return SceneReader.read(file.text(), file.source());
    }

    private static String refused(String pathOrName) {
        return assertThrows(SceneException.class, () -> SceneFiles.load(pathOrName)).getMessage();
    }

    @Test
    void aNameIsBounded() {
        String text = fromFolder("duel").json();
        assertEquals(100, SceneReader.read(text.replace("\"duel\"", '"' + "n".repeat(100) + '"'), "s").name().length());
        String longer = text.replace("\"duel\"", '"' + "n".repeat(101) + '"');
        String refusal = assertThrows(SceneException.class, () -> SceneReader.read(longer, "s")).getMessage();
        assertTrue(refusal.contains("name: found a name of 101 characters, expected at most 100"), refusal);
    }
}
