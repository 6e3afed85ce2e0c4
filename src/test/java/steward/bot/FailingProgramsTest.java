package steward.bot;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;

/**
 * Real programs that fail, in the languages of the starters and in those that are installed beside them. The first line
 * of each says what has to be found in its stderr. {@link ErrorLineTest} has what they wrote when this was made.
 */
@Tag("process")
@Tag("campaign")
class FailingProgramsTest {

    private static final Path PROGRAMS = Path.of("src/test/resources/failing");
    private static final String SAYS = " says: ";

    @TempDir
    private Path folder;

    @TestFactory
    Stream<DynamicTest> theLineThatSaysWhyIsFound() throws IOException {
        return Files.list(PROGRAMS).filter(Files::isRegularFile).filter(file -> !file.toString().endsWith(".txt"))
            .sorted().map(file -> dynamicTest(file.getFileName().toString(), () -> isFound(file)));
    }

    private void isFound(Path program) throws IOException, InterruptedException {
        String name = program.getFileName().toString();
        String head = Files.readAllLines(program).get(0);
        String expected = head.substring(head.indexOf(SAYS) + SAYS.length());
        Files.copy(program, folder.resolve(name));
        String said = said(name);
        List<String> lines = said.lines().filter(line -> !line.isBlank()).toList();
        int index = ErrorLine.index(lines);
        String line = lines.isEmpty() ? "" : lines.get(index < 0 ? lines.size() - 1 : index);
        assertTrue(ErrorLine.text(line).contains(expected), () -> line + "\nis not '" + expected + "' in\n" + said);
    }

    private String said(String name) throws IOException, InterruptedException {
        String extension = name.substring(name.lastIndexOf('.') + 1);
        return switch (extension) {
            case "py" -> run("python3", name);
            case "js", "mjs", "cjs" -> run("node", "--max-old-space-size=30", name);
            case "java" -> compiled(List.of("javac", name), "java", "-Xmx64m", name.replace(".java", ""));
            case "cpp" -> compiled(List.of("g++", "-o", "program", name), "./program");
            case "go" -> compiled(List.of("go", "build", "-o", "program", name), "./program");
            default -> compiled(List.of("rustc", "-o", "program", name), "./program");
        };
    }

    /** The errors of the compiler, or else the stderr of the program. */
    private String compiled(List<String> compiler, String... program) throws IOException, InterruptedException {
        String errors = run(compiler.toArray(String[]::new));
        return errors.contains("error") || errors.contains("undefined: ") ? errors : run(program);
    }

    private String run(String... command) throws IOException, InterruptedException {
        assumeTrue(command[0].startsWith("./") || ProgramFinder.find(command[0]) != null,
            "skipped: there is no " + command[0]);
        Path stderr = Files.createTempFile(folder, "said", "");
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(stderr.toFile());
        builder.environment().remove("RUST_BACKTRACE");
        builder.redirectInput(Path.of("/dev/null").toFile()).start().waitFor();
        return new String(Files.readAllBytes(stderr), StandardCharsets.UTF_8);
    }
}
