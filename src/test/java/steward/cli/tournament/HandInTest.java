package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.ShellBots;
import steward.files.InputException;

/** Hand-ins are data: regular files within bounds are copied, and nothing else is opened. */
class HandInTest {

    private static final HandIn.Bounds BOUNDS = new HandIn.Bounds(1, 10);

    @TempDir
    private Path folder;

    private Path in;
    private Path secret;

    @BeforeEach
    void folders() throws IOException {
        in = Files.createDirectory(folder.resolve("in"));
        secret = Files.writeString(folder.resolve("secret"), "root:x:0:0");
    }

    private HandIn copied(Path source) throws IOException {
        HandIn found = HandIn.of(source, BOUNDS);
        found.copy(folder.resolve("out"));
        return found;
    }

    private String refused(Path source) {
        return assertThrows(InputException.class, () -> HandIn.of(source, BOUNDS)).getMessage();
    }

    @Test
    void linksAreLeftOutAndNamed() throws IOException {
        Files.writeString(in.resolve("run"), "sh main.sh");
        Files.createSymbolicLink(in.resolve("passwd"), secret);
        Files.createSymbolicLink(in.resolve("root"), folder);
        HandIn found = copied(in);
        assertEquals(Set.of("run"), found.files().keySet());
        assertFalse(Files.exists(folder.resolve("out/passwd")) || Files.exists(folder.resolve("out/root")));
        assertTrue(found.left().contains("passwd (a link)") && found.left().contains("root (a link)"), found.left());
    }

    @Test
    void aLinkInPlaceOfAFileIsRefused() throws IOException {
        Files.createSymbolicLink(in.resolve("a.py"), secret);
        assertEquals("found a link, expected a regular file", refused(in.resolve("a.py")));
    }

    @Test
    void aLinkThatComesAfterTheLookIsNotFollowed() throws IOException {
        Path file = Files.writeString(in.resolve("a.py"), "pass");
        HandIn found = HandIn.of(file, BOUNDS);
        Files.delete(file);
        Files.createSymbolicLink(file, secret);
        assertThrows(InputException.class, () -> found.copy(folder.resolve("out")));
        assertFalse(Files.exists(folder.resolve("out")));
    }

    @Test
    @Tag("process")
    void aPipeIsNotWaitedFor() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "there is no mkfifo");
        Files.writeString(in.resolve("run"), "sh main.sh");
        assertEquals(0, new ProcessBuilder("/usr/bin/mkfifo", in.resolve("pipe").toString(),
            folder.resolve("b.py").toString()).start().waitFor());
        assertTimeoutPreemptively(Duration.ofSeconds(60), () -> {
            assertTrue(copied(in).left().contains("pipe (a pipe, socket or device)"));
            assertTrue(refused(folder.resolve("b.py")).startsWith("found a pipe"));
        });
    }

    @Test
    void aFolderOfEmptyFoldersIsRefused() throws IOException {
        Files.createDirectory(in.resolve("run"));
        assertEquals("found no regular file, expected a regular file", refused(in));
    }

    /** In no encoding that Java has here: printed by a shell. */
    @Test
    @Tag("process")
    void aNameThatCannotBeDecodedIsLeftOutAndNamed() throws Exception {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Files.writeString(in.resolve("run"), "sh main.sh");
        foreign("m");
        HandIn found = copied(in);
        assertEquals(Set.of("run"), found.files().keySet());
        assertTrue(found.left().endsWith("(a name in another encoding)"), found.left());
    }

    @Test
    @Tag("process")
    void programsWhoseNamesCannotBeDecodedKeepNamesOfTheirOwn() throws Exception {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        foreign("m");
        Path into = folder.resolve("into");
        for (int call = 0; call < 3; call++) {
            List<Programs.Program> programs = Programs.in(in, into).programs();
            assertEquals(Set.of("m", "m-2"), programs.stream().map(Programs.Program::name)
                .collect(Collectors.toSet()));
            for (Programs.Program program : programs) {
                Files.writeString(Files.createDirectories(into.resolve(Programs.FOLDER).resolve(program.name()))
                    .resolve(Programs.HANDED_IN_AS), program.source().getFileName().toString());
            }
        }
    }

    /** Two files whose names end in bytes of Latin 1. */
    private void foreign(String name) throws IOException, InterruptedException {
        assertEquals(0, new ProcessBuilder("/bin/sh", "-c", "for end in '\\351' '\\350'; do echo pass > "
            + "\"$(printf \"" + name + "$end.py\")\"; done").directory(in.toFile()).start().waitFor());
    }

    @Test
    void theSizeThatAFileAppearsToHaveCounts() throws IOException {
        try (RandomAccessFile holes = new RandomAccessFile(in.resolve("a.py").toFile(), "rw")) {
            holes.setLength(1 << 30);
        }
        assertEquals("found more than 1 MB, expected less (--most-megabytes)", refused(in));
        assertEquals("found more than 1 MB, expected less (--most-megabytes)", refused(in.resolve("a.py")));
    }

    @Test
    void filesAndFoldersAreCountedBeforeAnyIsCopied() throws IOException {
        for (int k = 0; k < 5; k++) {
            Files.createDirectories(in.resolve("f" + k));
            Files.createFile(in.resolve("f" + k + "/x"));
        }
        assertEquals("found more than 10 files and folders, expected fewer (--most-files)", refused(in));
        Path deep = in.resolve("f0");
        for (int k = 0; k < 60; k++) {
            deep = Files.createDirectory(deep.resolve("d"));
        }
        assertTrue(assertThrows(InputException.class, () -> HandIn.of(in.resolve("f0"), new HandIn.Bounds(1, 100)))
            .getMessage().startsWith("found folders more than 40 deep"));
    }

    @Test
    void whatIsHandedInNoMoreIsNoLongerThere() throws IOException {
        Files.writeString(in.resolve("run"), "sh main.sh");
        Files.writeString(in.resolve("old"), "x");
        HandIn first = HandIn.of(in, BOUNDS);
        String digest = first.copy(folder.resolve("out"));
        assertNull(first.left());
        assertFalse(first.isChanged(BOUNDS));
        assertEquals(digest, HandIn.of(in, BOUNDS).copy(folder.resolve("out")));
        Files.delete(in.resolve("old"));
        assertTrue(first.isChanged(BOUNDS));
        assertFalse(digest.equals(copied(in).copy(folder.resolve("out"))));
        assertFalse(Files.exists(folder.resolve("out/old")));
        assertTrue(Files.exists(folder.resolve("out/run")));
    }
}
