package steward.cli;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.command.CommandLine;
import steward.cli.streams.Streams;

/**
 * One entry of the table of bad inputs: a call, its files, and what comes of it. The lines of an entry, in this order:
 * <pre>
 * $ ARGUMENTS      as a shell would split them
 * < FILE BASE      a file of the call and what it is made of, see {@link BadInputFiles}; - is the standard input
 * - OLD            what is replaced in it, once, by the next line
 * + NEW
 * ? FILE           a file that is shown afterwards
 * = STATUS         the exit status
 * > LINE           each line of the standard output
 * ! LINE           each line of the standard error
 * : LINE           each line of the files that are shown
 * </pre>
 * {@value #FOLDER} is the folder of the call: its files are in there.
 *
 * @param command  whose file it stands in
 * @param call     the arguments
 * @param recipe   the lines that begin with {@code <}, {@code -}, {@code +}, {@code ~} and {@code ?}
 * @param expected the lines that begin with {@code =}, {@code >}, {@code !} and {@code :}
 */
record BadInputEntry(String command, String call, List<String> recipe, List<String> expected) {

    /** Stands for the folder of the call, in arguments and in expected lines. */
    static final String FOLDER = "TMP";

    private static final String CALL = "$ ";

    /** The entries of a file of resources. */
    static List<BadInputEntry> load(String folder, String command) {
        try (InputStream in = BadInputEntry.class.getResourceAsStream("/" + folder + "/" + command + ".txt")) {
            assertTrue(in != null, () -> "there is no file " + folder + "/" + command + ".txt");
            return read(command, new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** The entries of a file, as they stand there; they are apart by empty lines. */
    private static List<BadInputEntry> read(String command, String text) {
        List<BadInputEntry> entries = new ArrayList<>();
        for (String block : text.split("\n\n+")) {
            List<String> lines = block.lines().filter(line -> !line.startsWith("#")).toList();
            if (lines.isEmpty()) {
                continue;
            }
            if (!lines.get(0).startsWith(CALL)) {
                throw new AssertionError(command + ": expected a line that begins with $: " + lines.get(0));
            }
            entries.add(new BadInputEntry(command, lines.get(0).substring(CALL.length()),
                lines.stream().skip(1).filter(line -> "<-+~?".indexOf(line.charAt(0)) >= 0).toList(),
                lines.stream().skip(1).filter(line -> "=>!:".indexOf(line.charAt(0)) >= 0).toList()));
        }
        return entries;
    }

    /** The lines of a file. */
    String text(List<String> result) {
        List<String> lines = new ArrayList<>(List.of(CALL + call));
        lines.addAll(recipe);
        lines.addAll(result);
        return String.join("\n", lines) + "\n";
    }

    /** Returns the key by which entries are sorted. */
    String key() {
        return call + "\n" + String.join("\n", recipe);
    }

    /** The words of the call. */
    List<String> words() {
        return CommandLine.split(call);
    }

    /** The expected exit status. */
    int status() {
        return Integer.parseInt(expected.get(0).substring(2));
    }

    /** The lines of an output, each without its mark. */
    List<String> lines(char mark) {
        return expected.stream().filter(line -> line.charAt(0) == mark)
            .map(line -> line.length() < 2 ? "" : line.substring(2)).toList();
    }

    /** Makes the files, calls the program, and returns what came of it in the form of {@link #expected}. */
    List<String> run(Path folder) throws IOException {
        byte[] input = new BadInputFiles(folder).make(recipe);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        String[] arguments = words().stream().map(word -> word.replace(FOLDER, folder.toString()))
            .toArray(String[]::new);
        int status = Main.run(new Streams(new ByteArrayInputStream(input), false, out, err, false, false), arguments);
        List<String> result = new ArrayList<>(List.of("= " + status));
        add(result, "> ", out, folder);
        add(result, "! ", err, folder);
        for (String line : recipe) {
            if (line.charAt(0) == '?') {
                ByteArrayOutputStream shown = new ByteArrayOutputStream();
                shown.write(Files.readAllBytes(folder.resolve(line.substring(2))));
                add(result, ": ", shown, folder);
            }
        }
        return result;
    }

    private static void add(List<String> result, String mark, ByteArrayOutputStream bytes, Path folder) {
        String text = bytes.toString(StandardCharsets.UTF_8).replace(folder.toString(), FOLDER);
        text.lines().forEach(line -> result.add((mark + line).stripTrailing()));
    }

    @Override
    public String toString() {
        return call + (recipe.isEmpty() ? "" : " " + recipe);
    }
}
