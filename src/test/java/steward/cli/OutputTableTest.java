package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.options.SandboxOptions;

/**
 * Golden files: whole outputs of commands as text, JSON and CSV, to the letter but for times that were measured. A file
 * {@code outputs/NAME.txt} has calls that follow one another in one folder, in the form of {@link BadInputEntry}. With
 * {@code -Dsteward.recordOutputs=FOLDER} the files are written anew to a folder, to be read before they replace the old
 * ones. It takes long because the calls play whole leagues and tests whose bots are processes.
 */
@Tag("process")
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class OutputTableTest {

    private static final List<String> FILES = List.of("bodies", "failures", "league", "leagues", "match", "matches",
        "replays", "resumed", "runs", "sequential", "series", "sprt", "tools");
    /** Measured numbers within a line; each keeps its first group. */
    private static final List<Pattern> MEASURED = List.of(
        Pattern.compile("(\"(?:average|worst|first|mean|p99|meanFirst|worstFirst|meanMs|worstMs|[a-z]+Ms)\":)"
            + "[0-9.Ee+-]+"),
        Pattern.compile("(\"(?:worstGame|worstTurn)\":)[0-9]+"),
        Pattern.compile("(\"answerMs\":)\\[[^]]*]"),
        Pattern.compile("^(>.*,)[0-9.]+,[0-9.]+$"),
        Pattern.compile("( )[0-9.]+(?= ms\\b)"),
        Pattern.compile("(   game )[0-9]+, turn [0-9]+$"),
        Pattern.compile("()20[0-9-]{8}T[0-9:.]+Z"),
        Pattern.compile("(replays/)[0-9a-f]{2}/[0-9a-f]+"),
        Pattern.compile("(\\bprocess )[0-9]+"),
        Pattern.compile("(, program )[0-9a-f]{8}"),
        Pattern.compile("( |SHA256:|\")[0-9a-f]{32,64}\\b"),
        Pattern.compile("(in this run, )[0-9.,]+"),
        Pattern.compile("(\"answerNanos\":)\\[[^]]*]"));
    /** Lines of the standard error that depend on the machine and its user. */
    private static final Pattern MACHINE = Pattern.compile("^! .*(" + SandboxOptions.NOT_APART
        + "|that use a processor out of turn are|warning: (level light|this is root)|^! step [0-9]+: "
        + "|are more games at a time)|^! LLR ");
    private static final Pattern HEAD = Pattern.compile("(?:average|mean|p99|worst|first) ms|worst in");

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"bodies", "failures", "leagues", "match", "matches", "replays", "runs", "sequential",
        "tools"})
    void isWhatItWas(String name) throws IOException {
        compare(name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"league", "resumed", "series", "sprt"})
    @Tag("campaign")
    void ofManyGamesIsWhatItWas(String name) throws IOException {
        compare(name);
    }

    private void compare(String name) throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        for (BadInputEntry entry : BadInputEntry.load("outputs", name)) {
            assertEquals(String.join("\n", entry.expected()), String.join("\n", output(entry, folder.toRealPath())),
                entry.call());
        }
    }

    private static List<String> output(BadInputEntry entry, Path folder) throws IOException {
        List<String> lines = new ArrayList<>();
        List<Integer> columns = List.of();
        for (String line : entry.run(folder)) {
            if (MACHINE.matcher(line).find()) {
                continue;
            }
            columns = line.length() < 3 ? List.of() : columns.isEmpty() ? columns(line) : columns;
            lines.add(masked(line, columns));
        }
        return lines;
    }

    /** The places where right-aligned columns of times end, if this is the head of a table. */
    private static List<Integer> columns(String head) {
        List<Integer> columns = new ArrayList<>();
        for (Matcher found = HEAD.matcher(head); found.find();) {
            if (!found.group().equals("worst in")) {
                columns.add(found.end());
            }
        }
        return columns;
    }

    private static String masked(String line, List<Integer> columns) {
        StringBuilder text = new StringBuilder(line);
        for (int end : columns) {
            for (int k = end - 1; k > 0 && k < text.length() && text.charAt(k) != ' '; k--) {
                text.setCharAt(k, text.substring(k, k + 1).matches("[0-9.]") ? '#' : text.charAt(k));
            }
        }
        String masked = text.toString().replaceAll("(?<=\\s)\\s*#[#.]*(?= |$)", "#");
        for (Pattern each : MEASURED) {
            masked = each.matcher(masked).replaceAll("$1#");
        }
        return masked;
    }

    @Test
    @EnabledIfSystemProperty(named = "steward.recordOutputs", matches = ".+",
        disabledReason = "outputs are recorded on demand, -Psteward.recordOutputs=FOLDER")
    void writesTheFilesAnew() throws IOException {
        Path target = Files.createDirectories(Path.of(System.getProperty("steward.recordOutputs")));
        for (String name : FILES) {
            Path own = Files.createDirectory(folder.resolve(name)).toRealPath();
            List<String> blocks = new ArrayList<>();
            for (BadInputEntry entry : BadInputEntry.load("outputs", name)) {
                blocks.add(entry.text(output(entry, own)));
            }
            Files.writeString(target.resolve(name + ".txt"), String.join("\n", blocks));
        }
    }
}
