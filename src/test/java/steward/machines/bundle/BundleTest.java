package steward.machines.bundle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.command.BotCommand;
import steward.bot.command.Platform;
import steward.files.InputException;
import steward.files.Sha256;
import steward.game.GameSetup;
import steward.guest.GuestType;
import steward.league.LeagueBot;
import steward.match.GuestSetup;
import steward.scene.SceneReader;

/** Bots packed and unpacked; archives that want out of their folder. */
@Tag("process")
class BundleTest {

    private static final String EMPTY = "{\"command\":[\"sh\",\"-c\",\"true\"],\"files\":[]}";

    @TempDir
    private Path folder;

    @Test
    void aBotIsUnpackedAsItWasPacked() throws IOException {
        Path program = Files.writeString(folder.resolve("bot.sh"), "#!/bin/sh\nexit 0\n");
        assertTrue(program.toFile().setExecutable(true));
        Path data = Files.writeString(folder.resolve("weights"), "1 2 3");
        LeagueBot bot = new LeagueBot("mine", "sh " + program, List.of(program.toString(), data.toString()), false,
            false);
        Bundle bundle = Bundle.of(bot);
        assertEquals(bundle.hash(), Bundle.of(bot).hash(), "the same files make the same bundle");

        UnpackedBundle unpacked = UnpackedBundle.of(folder.resolve("there"), bundle.hash(), bundle.bytes(),
            Platform.here());
        Path there = Path.of(unpacked.program().words().get(1));
        assertTrue(there.startsWith(folder.resolve("there").toAbsolutePath()), there.toString());
        assertEquals(Files.readString(program), Files.readString(there));
        assertTrue(Files.isExecutable(there));
        assertEquals("1 2 3", Files.readString(there.resolveSibling("weights")));
        Files.writeString(data, "4");
        assertFalse(Bundle.of(bot).hash().equals(bundle.hash()), "another file is another bundle");
    }

    @Test
    void aRefereeOfTooManyOrTooLargeFilesIsRefusedAsOne() throws IOException {
        Path classes = Files.createDirectory(folder.resolve("classes"));
        GameSetup setup = new GuestType(true).open(SceneReader.read("""
            {"name": "x", "game": "guest", "players": 2, "referee": {"classPath": ["%s"]}}""".formatted(classes), "x"));
        for (int k = 0; k < Bundle.MOST_FILES; k++) {
            Files.createFile(classes.resolve(k + ".class"));
        }
        assertEquals("the scene's referee: found 901 files, expected at most 900 for workers; pack its classes into a "
            + "jar", refusal(setup));
        Files.delete(classes.resolve("0.class"));
        try (RandomAccessFile large = new RandomAccessFile(classes.resolve("1.class").toFile(), "rw")) {
            large.setLength(Bundle.LARGEST + 1L);
        }
        assertTrue(refusal(setup).endsWith("1.class, expected at most 67108864 (64 MiB) for workers; take what only "
            + "people see from its class path"), refusal(setup));
    }

    private static String refusal(GameSetup setup) {
        return assertThrows(InputException.class, () -> Bundle.of((GuestSetup) setup)).getMessage();
    }

    /** A class path of a contest alone is longer than a text of JSON may be. */
    @Test
    void aCommandOfManyWordsArrivesWordByWord() {
        List<String> words = new ArrayList<>(List.of("sh", "", " ", "it's", "a=b"));
        for (int k = 0; k < 30; k++) {
            words.add("/repository/of/jars/" + "far/away/".repeat(10) + k + ".jar");
        }
        Bundle bundle = Bundle.of(new LeagueBot("long", new BotCommand(null, BotCommand.Prefix.CODINGAME, words)
            .toString(), List.of(), false, false));
        UnpackedBundle unpacked = UnpackedBundle.of(folder, bundle.hash(), bundle.bytes(), Platform.here());
        assertEquals(new BotCommand(null, BotCommand.Prefix.CODINGAME, words), unpacked.command());
    }

    private static byte[] archive(String... namesAndTexts) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            for (int k = 0; k < namesAndTexts.length; k += 2) {
                zip.putNextEntry(new ZipEntry(namesAndTexts[k]));
                zip.write(namesAndTexts[k + 1].getBytes(StandardCharsets.UTF_8));
                zip.closeEntry();
            }
        }
        return bytes.toByteArray();
    }

    private void refused(byte[] bytes, String what) throws IOException {
        Path bundles = folder.resolve("bundles");
        InputException problem = assertThrows(InputException.class,
            () -> UnpackedBundle.of(bundles, Sha256.hex(bytes), bytes, Platform.here()));
        assertTrue(problem.getMessage().contains(what), problem.getMessage());
        assertFalse(Files.exists(folder.resolve("out")), "nothing is written outside");
        try (var files = Files.walk(folder)) {
            assertEquals(0, files.filter(Files::isRegularFile).count());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"../out", "here/../../out", "/out", "here//out", "here/./out", "..", "here/a\\..\\out",
        "C:/out", "here/", "here/\u0007"})
    void aNameThatLeadsOutIsRefused(String name) throws IOException {
        refused(archive(Bundle.LIST, EMPTY, name, "x"), "expected one within the bundle");
    }

    @Test
    void aListThatNamesFilesOutsideIsRefused() throws IOException {
        refused(archive(Bundle.LIST, "{\"command\":[\"sh\"],\"files\":[{\"typed\":\"x\",\"place\":\"../../out\"}]}"),
            "is not within the bundle");
        refused(archive(Bundle.LIST, "{\"command\":[\"sh\",\"x\"],\"files\":7}"), "expected an array of objects");
        refused(archive("here/a", "x"), "expected the list of the others");
        byte[] good = archive(Bundle.LIST, EMPTY);
        InputException other = assertThrows(InputException.class,
            () -> UnpackedBundle.of(folder, "0".repeat(64), good, Platform.here()));
        assertTrue(other.getMessage().contains("found other bytes"), other.getMessage());
    }

    @Test
    void whatIsUnpackedThereAlreadyStays() throws IOException {
        byte[] bytes = archive(Bundle.LIST, EMPTY, "here/a", "x");
        UnpackedBundle first = UnpackedBundle.of(folder, Sha256.hex(bytes), bytes, Platform.here());
        assertEquals(first, UnpackedBundle.of(folder, Sha256.hex(bytes), bytes, Platform.here()));
        assertEquals(List.of(Sha256.hex(bytes)), List.of(folder.toFile().list()), "and nothing else is left");
    }
}
