package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;

/**
 * The evening of docs/league.md, by its own call: five starters in four languages, each of which aims against another
 * drift. The first time one has a typing error and one is not there yet. What is printed is what the page says.
 */
@Tag("process")
@Tag("campaign")
@Timeout(900)
class EveningTest {

    private static final Pattern CALL = Pattern.compile("(?m)^    steward (tournament submissions .*?) --watch");
    private static final Pattern BLOCK = Pattern.compile("(?s)<!-- generated -->\n(.*?)<!-- /generated -->");
    private static final Pattern SPEED = Pattern.compile("[0-9.,]+ games/s");

    private static final Map<String, String> FILES = Map.of("python", "bot.py", "java", "Bot.java", "cpp", "bot.cpp",
        "js", "bot.js");

    @TempDir
    private Path folder;

    private String page() throws IOException {
        String page = Files.readString(Path.of("docs/league.md"));
        return page.substring(page.indexOf("## A tournament in one command"));
    }

    /** Writes a starter. @param turns of its own speed against which it aims; the starter itself has 4 */
    private void handIn(String language, String name, int turns, String typo) throws IOException {
        Path place = folder.resolve("starters").resolve(name + typo);
        assertEquals(ExitStatus.DONE, Cli.run("new", language, place.toString(), "--protocol", "codingame").status());
        String file = FILES.get(language);
        String source = Files.readString(place.resolve(file)).replace("- 4 * pod", "- " + turns + " * pod")
            .replaceFirst("const targetX", "const " + typo);
        Files.writeString(Files.createDirectories(folder.resolve("submissions"))
            .resolve(name + file.substring(file.lastIndexOf('.'))), source);
    }

    /** The block of the page, or what was printed, in words with single blanks and without what was measured. */
    private static String words(String text) {
        return SPEED.matcher(text.strip().replaceAll("\\s+", " ")).replaceAll("N games/s");
    }

    private String call(String page) {
        Matcher call = CALL.matcher(page);
        assertTrue(call.find(), page);
        List<String> words = new ArrayList<>(List.of(call.group(1).split(" ")));
        words.replaceAll(word -> word.equals("submissions") || word.equals("results") ? folder.resolve(word).toString()
            : word);
        Cli played = Cli.run(words.toArray(String[]::new)).done();
        return words(Stream.concat(played.err().lines(), played.out().lines()).filter(line ->
            !line.contains("warning: ") && !line.contains("out of turn") && !line.startsWith("Written: "))
            .collect(Collectors.joining("\n")));
    }

    @Test
    void whatIsPrintedIsWhatThePageSays() throws IOException {
        for (String program : List.of("python3", "javac", "g++", "node")) {
            assumeTrue(ProgramFinder.find(program) != null, "there is no " + program);
        }
        Matcher block = BLOCK.matcher(page());
        handIn("python", "ann", 2, "");
        handIn("java", "Ben", 3, "");
        handIn("cpp", "cyd", 4, "");
        handIn("js", "dee", 5, "targtX");
        assertTrue(block.find(), "a block of what is printed");
        assertEquals(words(block.group(1)), call(page()));
        handIn("js", "dee", 5, "targetX");
        handIn("python", "eve", 6, "");
        assertTrue(block.find(), "another");
        assertEquals(words(block.group(1)), call(page()));
    }
}
