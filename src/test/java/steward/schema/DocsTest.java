package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.architecture.SourceText;
import steward.replay.ReplayHeader;

/**
 * README and manual agree with the program: every call that they show can be understood, every option, link and file
 * that they name exists. They can be read without stopping. Nothing is run here; see {@link DocsCommandsTest}.
 */
@Execution(ExecutionMode.CONCURRENT)
class DocsTest {

    private static final int README_LINES = 90;
    private static final int MANUAL_LINES = 2000;
    private static final int VERSION_LINES = 120;
    private static final int MOST_WORDS = 35;
    private static final Pattern WORD = Pattern.compile("\\S*[\\p{L}\\p{N}_]\\S*");
    private static final Set<String> OPTIONS = DocumentedCall.options();
    private static final Pattern FROM_FILE = Pattern.compile(
        "(?s)<!-- generated from (src/\\S+) -->\n(?:```\\w+\n(.*?)```\n|(.*?))<!-- /generated -->");

    private static long words(String sentence) {
        return WORD.matcher(sentence).results().count();
    }

    private static boolean leads(MarkdownPage page, String link) {
        String[] parts = (link + "#").split("#", 3);
        Path path = parts[0].isEmpty() ? Path.of(page.path()) : Path.of(page.path()).resolveSibling(parts[0]);
        return link.matches("https?://.*|mailto:.*") || Files.exists(path) && (parts[1].isEmpty()
            || (parts[0].isEmpty() ? page : MarkdownPage.read(path.toString())).headings().contains(parts[1]));
    }

    /** Everything that is wrong with a page, rule by rule. */
    private static Stream<String> problems(MarkdownPage page) {
        return Stream.of(
            page.code().flatMap(line -> DocumentedCall.problems(line, true).map(fault -> fault + ": " + line)),
            page.spans().flatMap(span -> DocumentedCall.problems(span, false).map(fault -> fault + ": " + span)),
            page.spans().filter(span -> span.startsWith("--") && !OPTIONS.contains(span.split("[ =]")[0]))
                .map("no command has the option "::concat),
            page.spans().filter(span -> span.matches("(?:src|config|docs)/[\\w./-]*\\w"))
                .filter(span -> Files.notExists(Path.of(span))).map("no such file: "::concat),
            page.links().filter(link -> !leads(page, link)).map("no such file or heading: "::concat),
            page.sentences().filter(sentence -> words(sentence) > MOST_WORDS)
                .map(sentence -> words(sentence) + " words, expected at most " + MOST_WORDS + ": " + sentence))
            .flatMap(rule -> rule).map(fault -> page.path() + ": " + fault);
    }

    @Test
    void whatThePagesShowExists() {
        assertEquals("", MarkdownPage.all().stream().flatMap(DocsTest::problems).collect(Collectors.joining("\n")));
    }

    @Test
    void whatIsWrongIsFound() {
        String planted = """
            # A page

            Text with `steward mtach`, `--no-such-option 3`, `src/nowhere.txt` and `steward explain`, which is a part.
            [One](nowhere.md), [two](docs/api.md#nothing), [three](#a-page), [four](#b-page), [five](docs/api.md).

                steward match --bto x           # a comment
                steward replay
                steward feed x.jsonl --player 0 --form-turn 3 -- ./mine --its-own
                java -jar x.jar -r "steward refree" -n 100
                steward match --games many --bot x \\
                    --swpa
                ./gradlew tset
                ./gradlew test -Psteward.trun=1
                ./gradlew test --tests '*NoSuchTest'
                ./gradlew jmh -Pbench='NoSuch -f 1'
                ./gradlew run -Pcli='match --hlep'
                steward replay - --verify < x | steward impotr - > y
                env -i A="$A" steward dmeo
                source <(steward completoin)
                cmd = 'steward "tornament"'

            ```json
            steward nothing
            ```

            # WORDS

            WORDSmore.

                WORDScode

            - WORDS. WORDS.
            - WORDS
              goes on

            | a | WORDSin a cell | `WORDScode` |

            ```
            WORDScode
            ```
            WORDS[WORDS](nowhere.md) 1.5 is no end - of a sentence
            """.replace("WORDS", "word ".repeat(MOST_WORDS));
        assertEquals("comment replay --its-own 100 --swpa tset -Psteward.trun=1 '*NoSuchTest' 1' --hlep' y dmeo"
            + " completoin) \"tornament\"' mtach 3 src/nowhere.txt nowhere.md docs/api.md#nothing #b-page nowhere.md"
            + " more. on cell sentence",
            problems(new MarkdownPage("README.md", planted)).map(fault -> fault.strip().replaceFirst("(?s).*\\s", ""))
                .collect(Collectors.joining(" ")));
    }

    @Test
    void theReadmeLeadsToEveryPage() {
        Set<String> pages = MarkdownPage.all().stream().map(MarkdownPage::path)
            .filter(path -> path.matches("docs/[^/]+")).collect(Collectors.toCollection(TreeSet::new));
        for (String folder : List.of("", "docs/")) {
            MarkdownPage.read(folder + "README.md").links()
                .forEach(link -> pages.remove(folder + link.replaceAll("#.*", "")));
        }
        assertEquals(Set.of(), pages);
    }

    private static void assertAtMost(int lines, String page, long found) {
        assertTrue(found <= lines, page + " has " + found + " lines, expected at most " + lines);
    }

    @Test
    void pagesAreShortWithoutTheTablesThatCommandsWrite() {
        String table = "<!-- generated by x -->\n| a |\n<!-- /generated -->\n";
        assertEquals(2, new MarkdownPage("", "one\n" + table + "two\n").written());
        assertEquals(0, new MarkdownPage("", "# A page\n\nWritten by `steward tradeoff` on 2030-01-02.\n").written());
        assertAtMost(README_LINES, "README.md", SourceText.of("README.md").lines().count());
        assertAtMost(MANUAL_LINES, "docs/*.md", MarkdownPage.all().stream()
            .filter(page -> page.path().matches("docs/[^/]+")).mapToLong(MarkdownPage::written).sum());
        for (String version : SourceText.of("CHANGELOG.md").split("(?m)^(?=## \\[)")) {
            assertAtMost(VERSION_LINES, version.lines().findFirst().orElse(""), version.lines().count());
        }
    }

    private static List<String> found(String pattern, String file) {
        return Pattern.compile(pattern).matcher(SourceText.of(file)).results().map(found -> found.group(1)).distinct()
            .toList();
    }

    /** The version of the build and its notes, the format of replays, and ratios of speed of the README. */
    @Test
    void aFactIsTheSameWhereverItStands() {
        List<String> version = found("(?m)^version = '([^']+)'$", "build.gradle");
        assertEquals(version, found("(?s)\\A.*?\n## \\[([^\\]]+)\\] - \\d{4}-\\d\\d-\\d\\d\n", "CHANGELOG.md"));
        assertEquals(version, found("steward(?:-engine)?(?::|</artifactId><version>)(\\d[\\w.]*)", "docs/library.md"));
        assertEquals(List.of("" + ReplayHeader.FORMAT), found("The format is number (\\d+)\\.", "docs/replays.md"));
        Map.of("race, textbook", "(\\S+) times as fast as a textbook port",
            "answer", "JSON answers are read (\\S+) times as fast as into a tree").forEach((row, sentence) ->
                assertEquals(found("(?m)^\\| " + row + " \\|.* ([0-9.]+) \\|$", "docs/performance.md")
                    .stream().map(ratio -> String.format(Locale.ROOT, "%.1f", Double.parseDouble(ratio))).toList(),
                    found(sentence.replace(" ", "\\s+"), "README.md")));
    }

    /** Examples are as in their files, and the README of the package for Python is without its heading. */
    @Test
    void examplesOfThePagesAreTheFilesThatTheyName() {
        Set<String> files = new TreeSet<>();
        for (MarkdownPage page : MarkdownPage.all()) {
            for (MatchResult example : FROM_FILE.matcher(page.text()).results().toList()) {
                String text = SourceText.of(example.group(1));
                files.add(example.group(1).replaceFirst(".*/", ""));
                assertEquals(text, example.group(2) != null ? example.group(2)
                    : text.split("(?<=\n\n)")[0] + example.group(3), page.path());
            }
        }
        assertEquals(Set.of("DroppedBall.java", "OneMatch.java", "README.md", "ReplayStates.java", "Searcher.java",
            "heap.py"), files);
    }
}
