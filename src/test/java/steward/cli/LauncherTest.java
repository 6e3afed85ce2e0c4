package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The script that starts the program, with a Java that only prints what it was called with. */
@Tag("process")
class LauncherTest {

    private static final String LINUX = "/proc/self/exe";
    private static final String VFORK = "-Djdk.lang.Process.launchMechanism=VFORK";

    @TempDir
    private Path folder;

    @BeforeEach
    void shell() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Files.createDirectories(folder.resolve("java/bin"));
        Path java = Files.writeString(folder.resolve("java/bin/java"), "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
        assertTrue(java.toFile().setExecutable(true));
    }

    /** The output of a script that ends well, with a Java of this version. */
    private String run(Path script, String version, String... words) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("java/release"), "JAVA_VERSION=\"" + version + "\"\n");
        ProcessBuilder shell = new ProcessBuilder(Cli.words(List.of("/bin/sh", script.toString()), words))
            .redirectErrorStream(true);
        shell.environment().put("JAVA_HOME", folder.resolve("java").toString());
        shell.environment().put("XDG_CACHE_HOME", folder.resolve("cache").toString());
        Process process = shell.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        return said;
    }

    /** @param linux the file by which the script knows Linux */
    private String started(String version, String linux, String... words) throws IOException, InterruptedException {
        String said = run(Files.writeString(folder.resolve("steward"), Files.readString(Path.of("src/launcher/steward"))
            .replace(LINUX, linux)), version, words);
        assertTrue(said.endsWith("steward.cli.Main\n" + Stream.of(words).map(word -> word + "\n")
            .collect(Collectors.joining())), said);
        return said;
    }

    /**
     * Java for other systems knows no VFORK, and could start no bot; from 25 on it warns about it. The broker's queues
     * use what Java from 23 on warns of on the standard error; older Java refuses the word.
     */
    @ParameterizedTest
    @CsvSource({"17.0.1, true, false", "22, true, false", "23, true, true", "24, true, true", "25, false, true",
        "25.0.3, false, true"})
    void aJavaIsAskedForWhatItKnows(String version, boolean vfork, boolean unsafe) throws Exception {
        String said = started(version, Files.createFile(folder.resolve("there")).toString(), "help");
        assertEquals(vfork, said.contains(VFORK));
        assertEquals(unsafe, said.contains("--sun-misc-unsafe-memory-access=allow\n"));
        assertFalse(started(version, folder + "/no such file", "help").contains(VFORK), "not on Linux");
    }

    @Test
    void aCurrentFolderThatHasBeenRemovedIsSaid() throws IOException, InterruptedException {
        String script = Path.of("src/launcher/steward").toRealPath().toString();
        Process shell = new ProcessBuilder("sh", "-c", "mkdir gone && cd gone && rmdir ../gone && exec sh \"$0\" help",
            script).directory(folder.toFile()).start();
        String said = new String(shell.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(2, shell.waitFor(), said);
        assertTrue(said.endsWith("steward: found no current folder, expected one: it has been removed\n"), said);
    }

    /** A start of an installation with a Java that writes the archives that it is asked for, as empty files. */
    private String installed(Path home, String version, String... words) throws IOException, InterruptedException {
        Path java = folder.resolve("java/bin/java");
        Files.writeString(java, """
            #!/bin/sh
            for word; do case $word in -XX:ArchiveClassesAtExit=*) echo made >>"%s"; : >"${word#*=}" ;; esac; done
            printf '%%s\n' "$@"
            """.formatted(folder.resolve("made")));
        Files.createDirectories(home.resolve("bin"));
        Files.createDirectories(home.resolve("lib"));
        Files.writeString(home.resolve("lib/jars.sha256"), "00  steward.jar\n");
        Files.copy(Path.of("src/launcher/steward"), home.resolve("bin/steward"), StandardCopyOption.REPLACE_EXISTING);
        return run(home.resolve("bin/steward"), version, words);
    }

    private int made() throws IOException {
        Path file = folder.resolve("made");
        return Files.exists(file) ? Files.readAllLines(file).size() : 0;
    }

    @Test
    void anInstallationThatMovedHasArchivesOfItsOwnInTheCache() throws IOException, InterruptedException {
        Path home = folder.resolve("home");
        installed(home, "17", "--make-archives");
        assertEquals(2, made(), "one for the program, one for bots");
        String own = "-XX:SharedArchiveFile=" + home.toRealPath().resolve("lib/steward.jsa");
        assertTrue(installed(home, "17", "demo").contains(own));
        assertEquals(2, made());

        Path moved = Files.move(home, folder.resolve("moved"));
        String cached = "-XX:SharedArchiveFile=" + folder.toRealPath().resolve("cache/steward/archives-");
        assertTrue(installed(moved, "17", "demo").contains(cached));
        assertEquals(4, made(), "at the first start");
        assertTrue(installed(moved, "17", "demo").contains(cached));
        assertEquals(4, made());

        assertTrue(installed(moved, "21", "demo").contains(cached), "another Java at the place of the first");
        assertEquals(6, made());
    }

    /** Somebody else makes them: this start is as ever, without. */
    @Test
    void whoDoesNotGetTheLockStartsWithoutArchives() throws IOException, InterruptedException {
        Path home = folder.resolve("home");
        installed(home, "17", "demo");
        Path archives;
        try (Stream<Path> found = Files.list(folder.resolve("cache/steward"))) {
            archives = found.findFirst().orElseThrow();
        }
        Files.delete(archives.resolve("archives.for"));
        Files.delete(archives.resolve("steward.jsa"));
        Path lock = Files.createDirectory(archives.resolveSibling(archives.getFileName() + ".lock"));
        assertFalse(installed(home, "17", "demo").contains("-XX:SharedArchiveFile=" + archives.resolve("steward.jsa")));
        assertEquals(2, made());
        assertTrue(Files.exists(lock));
        assertTrue(lock.toFile().setLastModified(System.currentTimeMillis() - 3_600_000));
        assertTrue(installed(home, "17", "demo").contains("steward.jsa"), "whoever had it was killed");
        assertEquals(4, made());
        assertFalse(Files.exists(lock));
    }

    /** Long runs need the compiler that optimizes, short ones start faster without it; options in both forms. */
    @Test
    void whatMayTakeLongIsNotLeftToTheQuickCompiler() throws IOException, InterruptedException {
        String quick = "-XX:TieredStopAtLevel=1\n-XX:+UseSerialGC\n-XX:-UsePerfData\n-Xshare:auto\n";
        for (String call : List.of("run bowl", "run bowl --turns 200", "match duel -b x -g 5", "match duel -g5",
            "match duel --games 5", "match duel --games=5", "match duel --swap", "sprt", "tournament")) {
            assertFalse(started("17", LINUX, call.split(" ")).contains(quick), call);
        }
        for (String call : List.of("match duel -b x", "explain bowl", "replay x", "demo")) {
            assertTrue(started("17", LINUX, call.split(" ")).contains(quick), call);
        }
    }

    /** A longer class path slows down every start. */
    @Test
    void theLabStandsLastAndOnlyWhereItIsNeeded() throws IOException, InterruptedException {
        String lab = "/lib/steward-lab.jar\nsteward.cli.Main\n";
        for (String call : List.of("bench --quick", "tradeoff --calibrate duel",
            "help", "--help", "completion", "--cli bench", "")) {
            assertTrue(started("17", LINUX, call.isEmpty() ? new String[0] : call.split(" ")).contains(lab), call);
        }
        for (String call : List.of("match --games 5", "explain duel", "league run night", "worker --join x:1",
            "replay x --help", "demo")) {
            assertFalse(started("17", LINUX, call.split(" ")).contains("steward-lab"), call);
        }
    }
}
