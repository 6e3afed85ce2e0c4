package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.command.CommandLine;
import steward.bot.process.JavaProcess;
import steward.cli.Main;

/** Shell that runs lines of pages in a folder, in whose {@code bin} is the program. */
final class PageShell {

    private final Path folder;
    private final String path;

    /**
     * Puts the program into the folder.
     *
     * @param before lines of shell before the program runs; they may change its arguments
     * @param first  folders that programs are looked for in, before those of the PATH
     */
    PageShell(Path folder, String before, Path... first) throws IOException {
        need("sh");
        this.folder = folder;
        StringBuilder folders = new StringBuilder(folder.resolve("bin").toString());
        for (Path one : first) {
            folders.append(File.pathSeparatorChar).append(one.toAbsolutePath().normalize());
        }
        path = folders.append(File.pathSeparatorChar).append(System.getenv("PATH")).toString();
        String program = CommandLine.quote(JavaProcess.words(Main.class));
        executable("bin/steward", before + "exec " + program + " \"$@\"\n");
    }

    /** Skips the test if a program is missing that runs {@code -c ""}. */
    static void need(String program) {
        boolean there;
        try {
            there = new ProcessBuilder(program, "-c", "").start().waitFor() == 0;
        } catch (IOException | InterruptedException problem) {
            there = false;
        }
        assumeTrue(there, () -> "skipped: there is no " + program + " on the PATH");
    }

    static void assertContains(String expected, String said) {
        assertTrue(said.contains(expected), () -> "expected " + expected + ", found:\n" + said);
    }

    void executable(String name, String script) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, "#!/bin/sh\n" + script);
        assertTrue(file.toFile().setExecutable(true));
    }

    static String fenced(String page, String fence, int number) throws IOException {
        Matcher blocks = Pattern.compile(fence, Pattern.DOTALL).matcher(Files.readString(Path.of(page)));
        for (int k = 0; k <= number; k++) {
            assertTrue(blocks.find(), page + ": block " + k);
        }
        return blocks.group(1);
    }

    /** Lines in code blocks of the page that begin so. */
    static List<String> lines(String page, String begin) {
        return MarkdownPage.read(page).code()
            .filter(text -> text.startsWith(begin)).toList();
    }

    /** The only line in a code block of the page that begins so. */
    static String line(String page, String begin) {
        List<String> lines = lines(page, begin);
        assertEquals(1, lines.size(), page + ": lines that begin with " + begin);
        return lines.get(0);
    }

    /** Runs a line of a page, which has to end with this status and say this; what it wrote to either stream. */
    String run(int status, String page, String begin, String... expected) throws IOException, InterruptedException {
        return runLine(status, line(page, begin), expected);
    }

    String runLine(int status, String line, String... expected) throws IOException, InterruptedException {
        Process process = start(line);
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(status, process.waitFor(), () -> line + "\n" + said);
        List.of(expected).forEach(words -> assertContains(words, said));
        return said;
    }

    /** Starts a line; both its streams can be read as one, and its input is at its end. */
    Process start(String line) throws IOException {
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", line).directory(folder.toFile())
            .redirectErrorStream(true);
        shell.environment().put("PATH", path);
        Process process = shell.start();
        process.getOutputStream().close();
        return process;
    }
}
