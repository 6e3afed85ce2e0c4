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
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.architecture.SourceText;
import steward.replay.ReplayHeader;
import steward.schema.MarkdownPage.Piece;

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
    private static final String OF_REPOSITORY = "(?:src|config|docs)/[\\w./-]*\\w";
    private static final Pattern FROM_FILE = Pattern.compile(
        "(?s)<!-- generated from (src/\\S+) -->\n(?:```\\w+\n(.*?)```\n|(.*?))<!-- /generated -->");

    /** The pieces of a page that a rule is about; and the fault of a piece of this page, or {@code null}. */
    private record Rule(Function<MarkdownPage, List<Piece>> pieces, BiFunction<MarkdownPage, String, String> fault) {
    }

    private static final List<Rule> RULES = List.of(
        new Rule(MarkdownPage::code, (page, line) -> DocumentedCall.problem(line, true)),
        new Rule(MarkdownPage::spans, (page, span) -> DocumentedCall.problem(span, false)),
        new Rule(MarkdownPage::spans, (page, span) -> span.startsWith("--") && !OPTIONS.contains(span.split("[ =]")[0])
            ? "no command has such an option" : null),
        new Rule(MarkdownPage::spans, (page, span) -> span.matches(OF_REPOSITORY) && Files.notExists(Path.of(span))
            ? "no such file" : null),
        new Rule(MarkdownPage::links, DocsTest::linkProblem),
        new Rule(MarkdownPage::sentences, (page, sentence) -> words(sentence) > MOST_WORDS
            ? words(sentence) + " words, expected at most " + MOST_WORDS : null));

    private static long words(String sentence) {
        return WORD.matcher(sentence).results().count();
    }

    private static String linkProblem(MarkdownPage page, String target) {
        if (target.matches("https?://.*|mailto:.*")) {
            return null;
        }
        String[] parts = target.split("#", 2);
        Path path = Path.of(page.path()).resolveSibling(parts[0]).normalize();
        if (Files.notExists(path)) {
            return "no such file";
        }
        MarkdownPage linked = parts[0].isEmpty() || parts.length < 2 ? page : MarkdownPage.read(path.toString());
        return parts.length < 2 || linked.headings().contains(parts[1]) ? null : "no such heading";
    }

    /** Everything that is wrong with a page, rule by rule, with the line where it stands. */
    private static Stream<String> problems(MarkdownPage page) {
        return RULES.stream().flatMap(rule -> rule.pieces().apply(page).stream().flatMap(piece ->
            Stream.ofNullable(rule.fault().apply(page, piece.text()))
                .map(fault -> page.path() + ":" + piece.line() + ": " + fault + ": " + piece.text())));
    }

    private static int seen(Function<MarkdownPage, Stream<?>> pieces) {
        return (int) MarkdownPage.all().stream().flatMap(pieces).count();
    }

    @Test
    void whatThePagesShowExists() {
        assertEquals("", MarkdownPage.all().stream().flatMap(DocsTest::problems).collect(Collectors.joining("\n")));
    }

    @Test
    void callsAreSeen() {
        int calls = seen(page -> page.code().stream().flatMap(line -> DocumentedCall.calls(line.text()).stream()));
        assertTrue(calls >= 70, "calls in code blocks: " + calls);
        int links = seen(page -> page.links().stream());
        assertTrue(links >= 50, "links: " + links);
        assertEquals(List.of(List.of("steward", "import", "-", "--out", "-"),
            List.of("steward", "replay", "-", "--verify")),
            DocumentedCall.calls("steward import - --out - < game.json | steward replay - --verify   # comment"));
        assertEquals(List.of(List.of("steward", "play", "$(cat %DIR%)")),
            DocumentedCall.calls("cmd = 'steward play \"$(cat %DIR%)\"'"));
        assertEquals(List.of(List.of("steward", "completion")), DocumentedCall.calls("source <(steward completion)"));
        assertEquals(List.of(List.of("steward", "demo")),
            DocumentedCall.calls("env -i A=\"$A\" steward demo > x.txt"));
    }

    @Test
    void whatIsWrongIsFound() {
        String words = "word ".repeat(MOST_WORDS);
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
            """.replace("WORDS", words);
        assertEquals("6 7 8 9 10 12 13 14 15 16 3 3 3 4 4 4 37 24: 36 29: 37 32: 38 37: 77",
            problems(new MarkdownPage("README.md", planted)).map(fault -> fault.replaceAll(
                "README.md:(\\d+(?:: \\d+(?= words))?).*", "$1")).collect(Collectors.joining(" ")));
    }

    @Test
    void theReadmeLeadsToEveryPage() {
        Set<String> missing = MarkdownPage.all().stream().map(MarkdownPage::path)
            .filter(path -> path.matches("docs/[^/]+")).collect(Collectors.toCollection(TreeSet::new));
        for (String folder : List.of("", "docs/")) {
            MarkdownPage.read(folder + "README.md").links()
                .forEach(link -> missing.remove(folder + link.text().replaceAll("#.*", "")));
        }
        assertEquals(Set.of(), missing);
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
        String[] versions = SourceText.of("CHANGELOG.md").split("(?m)^(?=## \\[)");
        assertTrue(versions.length > 3, versions.length + " parts");
        for (String version : versions) {
            assertAtMost(VERSION_LINES, version.lines().findFirst().orElse(""), version.lines().count());
        }
    }

    /** The version of the build has notes, and is the one that other builds are told to depend on. */
    @Test
    void theVersionIsTheSameWhereverItStands() {
        String version = found("(?m)^version = '([^']+)'$", "build.gradle").get(0);
        assertEquals(version, found("(?m)^## \\[([^\\]]+)\\] - \\d{4}-\\d\\d-\\d\\d$", "CHANGELOG.md").get(0));
        assertEquals(Set.of(version), Set.copyOf(
            found("steward(?:-engine)?(?::|</artifactId><version>)(\\d[\\w.]*)", "docs/library.md")));
    }

    private static List<String> found(String pattern, String file) {
        return Pattern.compile(pattern).matcher(SourceText.of(file)).results().map(found -> found.group(1)).toList();
    }

    @Test
    void theFormatOfReplaysIsTheOneThatIsWritten() {
        assertEquals(List.of("" + ReplayHeader.FORMAT), found("The format is number (\\d+)\\.", "docs/replays.md"));
    }

    @Test
    void theReadmesRatiosOfSpeedAreThoseOfTheTable() {
        String readme = SourceText.of("README.md").replaceAll("\\s+", " ");
        Map.of("race, simulator", "%.1f times as fast as a textbook port",
            "answer", "JSON answers are read %.1f times as fast as into a tree").forEach((row, sentence) -> {
                String ratio = found("(?m)^\\| " + row + " \\|(?: [^|]+\\|){3} ([0-9.]+) \\|", "docs/performance.md")
                    .get(0);
                String expected = String.format(Locale.ROOT, sentence, Double.parseDouble(ratio));
                assertTrue(readme.contains(expected), () -> "README.md: expected \"" + expected + "\"");
            });
    }

    /** Examples are as in their files, and the README of the package for Python is without its heading. */
    @Test
    void examplesOfThePagesAreTheFilesThatTheyName() {
        Set<String> files = new TreeSet<>();
        for (MarkdownPage page : MarkdownPage.all()) {
            for (MatchResult example : FROM_FILE.matcher(page.text()).results().toList()) {
                String file = example.group(1);
                files.add(file.replaceFirst(".*/", ""));
                assertEquals(SourceText.of(file), example.group(2) != null ? example.group(2)
                    : SourceText.of(file).split("(?<=\n\n)")[0] + example.group(3), page.path());
            }
        }
        assertEquals(Set.of("DroppedBall.java", "OneMatch.java", "README.md", "ReplayStates.java", "Searcher.java",
            "heap.py"), files);
    }
}
