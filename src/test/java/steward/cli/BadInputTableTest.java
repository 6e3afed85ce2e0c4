package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine.Model.OptionSpec;
import steward.cli.shared.ExitStatus;

/**
 * The table of bad inputs: calls of every command that cannot be used, each with its exit status and everything that it
 * prints, to the letter. A file of resources for each command, {@code bad-input/COMMAND.txt}, see
 * {@link BadInputEntry}. With {@code -Dsteward.recordBadInput=FOLDER} the files are written anew to a folder, with what
 * the program prints now, to be read before they replace the old ones.
 */
@Execution(ExecutionMode.CONCURRENT)
class BadInputTableTest {

    /** Part of what a call says where this JVM cannot start processes, as in quickTest. */
    private static final String NO_PROCESSES = "this JVM cannot start programs";
    /** One entry in so many is called in quickTest. */
    private static final int SAMPLE = 8;
    /** Least entries of the whole table. */
    private static final int LEAST_ENTRIES = 590;

    /** How long a call is waited for when the table is written anew: refusals take milliseconds. */
    private static final long PATIENCE_S = 5;

    @TempDir
    private Path folder;

    private static List<BadInputEntry> entries(String command) {
        return BadInputEntry.load("bad-input", command);
    }

    static Stream<BadInputEntry> table() {
        return Main.commands().stream().flatMap(command -> entries(command).stream());
    }

    /** Some of the entries. */
    static Stream<BadInputEntry> sample() {
        return table().filter(BadInputTableTest::isOfSample);
    }

    /** The other entries. */
    static Stream<BadInputEntry> others() {
        return table().filter(entry -> !isOfSample(entry));
    }

    private static boolean isOfSample(BadInputEntry entry) {
        return entry.key().hashCode() % SAMPLE == 0;
    }

    @ParameterizedTest
    @MethodSource("sample")
    void isRefused(BadInputEntry entry) throws IOException {
        assertRefused(entry);
    }

    @ParameterizedTest
    @MethodSource("others")
    @Tag("slow")
    void isRefusedAsWell(BadInputEntry entry) throws IOException {
        assertRefused(entry);
    }

    /** Warnings about the machine and its user, which come before some refusals. */
    private static final String MACHINE = "! steward: [^\\n]*warning: (level light|this is root)[^\\n]*\\n";

    private void assertRefused(BadInputEntry entry) throws IOException {
        String found;
        try {
            found = String.join("\n", entry.run(folder.toRealPath()))
                .replaceAll(MACHINE, "");              // what the machine lacks is no part of a refusal
        } catch (NoClassDefFoundError problem) {
            assumeFalse(problem.getMessage().endsWith("java.lang.ProcessImpl"), "needs processes");
            throw problem;
        }
        assumeFalse(found.contains(NO_PROCESSES), "needs processes");
        assertEquals(String.join("\n", entry.expected()), found);
    }

    @ParameterizedTest
    @MethodSource("steward.cli.Main#commands")
    void everyRefusalIsAsItShouldBe(String command) {
        entries(command).forEach(BadInputTableTest::assertIsAsItShouldBe);
    }

    private static void assertIsAsItShouldBe(BadInputEntry entry) {
        int status = entry.status();
        assertTrue(status == ExitStatus.UNUSABLE || status == ExitStatus.FAILED,
            () -> entry.key() + ": status " + status);
        List<String> err = entry.lines('!');
        if (status == ExitStatus.UNUSABLE) {
            assertTrue(entry.lines('>').stream().allMatch(line -> entry.command().equals("referee")
                && line.equals("-1")), () -> entry.key() + ": standard output " + entry.lines('>'));
            assertFalse(err.isEmpty(), () -> entry.key() + ": nothing is said");
        }
        for (String line : err) {
            assertEquals(null, BadMessage.problem(line), () -> entry.key() + ": " + line);
        }
    }

    @Test
    void hasManyEntriesForAllCommands() {
        assertTrue(table().count() >= LEAST_ENTRIES, () -> table().count() + " entries");
        Set<String> keys = new HashSet<>();
        for (String command : Main.commands()) {
            List<String> sorted = entries(command).stream().map(BadInputEntry::key).sorted().toList();
            assertEquals(sorted, entries(command).stream().map(BadInputEntry::key).toList(),
                () -> command + ": not sorted");
            sorted.forEach(key -> assertTrue(keys.add(key), () -> "twice: " + key));
            assertTrue(entries(command).stream().anyMatch(entry -> entry.words().get(0).equals(command)), command);
        }
    }

    @ParameterizedTest
    @MethodSource("steward.cli.Main#commands")
    void hasEveryOptionThatTakesAValue(String command) {
        Set<String> used = entries(command).stream().flatMap(entry -> entry.words().stream())
            .map(word -> word.replaceFirst("=.*", "")).collect(Collectors.toSet());
        List<String> missing = new ArrayList<>();
        for (OptionSpec option : HelpTest.specOf(command).options()) {
            if (option.arity().max() > 0 && Stream.of(option.names()).noneMatch(used::contains)) {
                missing.add(option.longestName());
            }
        }
        assertEquals(List.of(), missing);
    }

    @Test
    @EnabledIfSystemProperty(named = "steward.recordBadInput", matches = ".+",
        disabledReason = "bad inputs are recorded on demand, -Psteward.recordBadInput=FOLDER")
    void writesTheTableAnew() throws IOException, InterruptedException {
        Path target = Files.createDirectories(Path.of(System.getProperty("steward.recordBadInput")));
        int calls = 0;
        for (String command : Main.commands()) {
            List<String> blocks = new ArrayList<>();
            for (BadInputEntry entry : entries(command).stream().sorted(Comparator.comparing(BadInputEntry::key))
                    .toList()) {
                Path own = Files.createDirectory(folder.resolve(String.valueOf(calls++))).toRealPath();
                blocks.add(entry.text(recorded(entry, own)));
                Files.writeString(target.resolve(command + ".txt"), String.join("\n", blocks));
            }
        }
        assertTrue(calls > 0);
    }

    /** A call that is accepted after all may take long: what comes of it then is not waited for. */
    private static List<String> recorded(BadInputEntry entry, Path own) throws InterruptedException {
        FutureTask<List<String>> run = new FutureTask<>(() -> entry.run(own));
        Thread thread = new Thread(run, "bad input");
        thread.setDaemon(true);
        thread.start();
        try {
            return run.get(PATIENCE_S, TimeUnit.SECONDS);
        } catch (TimeoutException accepted) {
            return List.of("= accepted, and still running after " + PATIENCE_S + " s");
        } catch (ExecutionException problem) {
            return List.of("= " + problem.getCause().toString().replace('\n', ' '));
        }
    }
}
