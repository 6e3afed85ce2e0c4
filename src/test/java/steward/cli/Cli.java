package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import steward.cli.options.SandboxOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One call of the program within this JVM.
 *
 * @param status its exit status
 * @param out    what it wrote to its standard output
 * @param err    what it wrote to its standard error
 */
public record Cli(int status, String out, String err) {

    /** Calls the program as if neither output were a terminal. */
    public static Cli run(String... arguments) {
        return run(false, arguments);
    }

    /** @param terminal whether both outputs are to be taken for terminals */
    public static Cli run(boolean terminal, String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int status = Main.run(new Streams(out, err, terminal, terminal), arguments);
        return new Cli(status, out.toString(StandardCharsets.UTF_8),
            withoutMachine(err.toString(StandardCharsets.UTF_8)));
    }

    /** Calls the program with an input that is no terminal. */
    public static Cli piped(byte[] in, String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int status = Main.run(new Streams(new ByteArrayInputStream(in), false, out, err, false, false), arguments);
        return new Cli(status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    /** @param more further arguments */
    public static Cli run(List<String> call, String... more) {
        return run(words(call, more));
    }

    /** Returns the words of a call. @param more further arguments */
    public static String[] words(List<String> call, String... more) {
        return Stream.concat(call.stream(), Stream.of(more)).toArray(String[]::new);
    }

    /** Calls a command of leagues; {@code TMP} in its words is a folder. */
    public static Cli league(Path folder, String... words) {
        return run(List.of("league"), Stream.of(words).map(word -> word.replace("TMP", folder.toString()))
            .toArray(String[]::new));
    }

    /** Requires that the call is done, and returns it. */
    public Cli done() {
        assertEquals(ExitStatus.DONE, status, err);
        return this;
    }

    /** Without the warning that bots cannot be kept apart here, which depends on the machine alone. */
    private static String withoutMachine(String err) {
        return err.replaceAll("(?m)^.*" + SandboxOptions.NOT_APART + ".*\\n", "");
    }

    /** Refused with status 2 and a message that has these words; nothing on the standard output, no stack trace. */
    public void assertRefused(String message) {
        assertEquals(ExitStatus.UNUSABLE, status, out + err);
        assertTrue(err.startsWith("steward: ") && err.contains(message), err);
        assertFalse(err.contains("\tat "), err);
        assertEquals("", out);
    }

    /** The output, which must be one JSON value on one line. */
    public JsonNode json() {
        if (out.indexOf('\n') != out.length() - 1) {
            throw new AssertionError("not one line: " + out + err);
        }
        return JsonMapper.shared().readTree(out);
    }
}
