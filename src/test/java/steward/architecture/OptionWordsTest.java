package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Texts of the libraries do not speak of options: who calls them from Java has none. They name the parameter, and
 * commands name their option, see {@link steward.files.Remedied}.
 */
class OptionWordsTest {

    private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"");
    private static final Pattern OPTION = Pattern.compile("(?<!-)--[a-z][a-z-]*");

    private static final String OF_OTHERS = "options of other programs that are started";
    private static final String STORED = "league.json has the sandbox as the words of a call";
    private static final String ADVICE = "advice to people who play games, beside what happened, in no exception";
    private static final String OTHER_SIDE = "about a call on the other side of a connection";

    /** Sources that may, with the reason. */
    private static final Map<String, String> REASONS = Map.ofEntries(
        Map.entry("bot/isolation/StrictSandbox", OF_OTHERS), Map.entry("bot/isolation/ShellLauncher", OF_OTHERS),
        Map.entry("bot/command/Program", OF_OTHERS), Map.entry("guest/GuestProgram", OF_OTHERS),
        Map.entry("live/PagePicture", OF_OTHERS), Map.entry("league/LeagueText", STORED),
        Map.entry("league/LeagueReader", STORED), Map.entry("league/LeagueSettings", STORED),
        Map.entry("contest/FailureHints", ADVICE), Map.entry("contest/FailureStreaks", ADVICE),
        Map.entry("league/play/Roster", ADVICE), Map.entry("bot/command/ProgramFinder", ADVICE),
        Map.entry("scene/AccuracyFigures", "the whole call of the workshop that makes the file"),
        Map.entry("machines/worker/Worker", OTHER_SIDE), Map.entry("machines/serve/WorkerState", OTHER_SIDE),
        Map.entry("machines/check/GameJar", OTHER_SIDE));

    private static List<String> options(String source) {
        List<String> found = new ArrayList<>();
        for (String line : source.lines().toList()) {
            LITERAL.matcher(line).results().forEach(literal ->
                OPTION.matcher(literal.group()).results().map(MatchResult::group).forEach(found::add));
        }
        return found;
    }

    @Test
    void librariesDoNotSpeakOfOptions() throws IOException {
        List<String> wrong = new ArrayList<>();
        Set<String> used = new TreeSet<>();
        for (Path root : List.of(Path.of("src/engine/java/steward"), Path.of("src/main/java/steward"))) {
            try (Stream<Path> files = Files.walk(root)) {
                for (Path file : files.filter(each -> each.toString().endsWith(".java")).sorted().toList()) {
                    String name = root.relativize(file).toString().replace('\\', '/').replace(".java", "");
                    List<String> found = name.startsWith("cli/") ? List.of() : options(Files.readString(file));
                    if (!found.isEmpty() && REASONS.containsKey(name)) {
                        used.add(name);
                    } else if (!found.isEmpty()) {
                        wrong.add(name + ": " + found);
                    }
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertEquals(new TreeSet<>(REASONS.keySet()), used, "reasons that are needed no more");
    }

    @Test
    void plantedOptionsAreFound() {
        assertEquals(List.of("--overwrite", "--out"), options("throw new InputException(file + \": kept; --overwrite "
            + "would\");\nString s = \"--out\"; int k = 3; k--; // --none\n"));
        assertEquals(List.of(), options("for (int k = 3; k --> 0;) { a(\"a - b\"); }"));
    }
}
