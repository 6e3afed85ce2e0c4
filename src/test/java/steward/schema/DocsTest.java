package steward.schema;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.architecture.SourceText;
import steward.replay.ReplayHeader;

/**
 * README and manual agree with the program: every call that they show can be understood, every option, link and file
 * that they name exists. Nothing is run here; see {@link DocsCommandsTest}.
 */
@Execution(ExecutionMode.CONCURRENT)
class DocsTest {

    private static final int README_LINES = 90;
    private static final int MANUAL_LINES = 2000;
    /** A page that a command writes as a whole; and tables between these comments. */
    static final Pattern GENERATED_PAGE = Pattern.compile("(?m)^Written by `steward ");
    private static final Pattern GENERATED = Pattern.compile("(?s)<!-- generated.*?<!-- /generated -->\n?");
    private static final Pattern FROM_FILE =
        Pattern.compile("(?s)<!-- generated from (src/examples/\\S+) -->\n```\\w+\n(.*?)```\n<!-- /generated -->");
    private static final Pattern OF_REPOSITORY = Pattern.compile("(?:src|config|docs)/[\\w./-]*\\w");
    private static final Pattern ELSEWHERE = Pattern.compile("https?://.*|mailto:.*");

    /** Everything that is wrong with a page, with the line where it stands. */
    private static List<String> problems(MarkdownPage page) throws IOException {
        List<String> problems = new ArrayList<>();
        for (MarkdownPage.Piece line : page.code()) {
            for (List<String> call : ShellLine.calls(line.text())) {
                add(problems, page, line, DocumentedCall.problem(call, true));
            }
        }
        for (MarkdownPage.Piece span : page.spans()) {
            for (List<String> call : ShellLine.calls(span.text())) {
                add(problems, page, span, DocumentedCall.problem(call, false));
            }
            if (span.text().startsWith("--")) {
                add(problems, page, span, DocumentedCall.optionProblem(span.text().split("[ =]")[0]));
            }
            boolean gone = OF_REPOSITORY.matcher(span.text()).matches() && Files.notExists(Path.of(span.text()));
            add(problems, page, span, gone ? "no such file" : null);
        }
        for (MarkdownPage.Piece link : page.links()) {
            add(problems, page, link, linkProblem(page, link.text()));
        }
        return problems;
    }

    private static void add(List<String> problems, MarkdownPage page, MarkdownPage.Piece piece, String problem) {
        if (problem != null) {
            problems.add(page.path() + ":" + piece.line() + ": " + piece.text() + ": " + problem);
        }
    }

    private static String linkProblem(MarkdownPage page, String target) throws IOException {
        if (ELSEWHERE.matcher(target).matches()) {
            return null;
        }
        int hash = target.indexOf('#');
        String file = hash < 0 ? target : target.substring(0, hash);
        Path path = file.isEmpty() ? Path.of(page.path()) : Path.of(page.path()).resolveSibling(file).normalize();
        if (!file.isEmpty() && Files.notExists(path)) {
            return "no such file";
        }
        MarkdownPage linked = file.isEmpty() ? page : hash < 0 ? null : MarkdownPage.read(path.toString());
        boolean found = linked == null || linked.headings().contains(target.substring(hash + 1));
        return found ? null : "no such heading";
    }

    @Test
    void whatThePagesShowExists() throws IOException {
        List<String> problems = new ArrayList<>();
        for (MarkdownPage page : MarkdownPage.all()) {
            problems.addAll(problems(page));
        }
        assertEquals("", String.join("\n", problems));
    }

    @Test
    void callsAreSeen() throws IOException {
        int calls = 0;
        int links = 0;
        for (MarkdownPage page : MarkdownPage.all()) {
            calls += page.code().stream().mapToInt(line -> ShellLine.calls(line.text()).size()).sum();
            links += page.links().size();
        }
        assertTrue(calls >= 70, "calls in code blocks: " + calls);
        assertTrue(links >= 50, "links: " + links);
        assertEquals(List.of(List.of("steward", "import", "-", "--out", "-"),
            List.of("steward", "replay", "-", "--verify")),
            ShellLine.calls("steward import - --out - < game.json | steward replay - --verify   # comment"));
        assertEquals(List.of(List.of("steward", "play", "$(cat %DIR%)")),
            ShellLine.calls("cmd = 'steward play \"$(cat %DIR%)\"'"));
        assertEquals(List.of(List.of("steward", "completion")), ShellLine.calls("source <(steward completion)"));
        assertEquals(List.of(List.of("steward", "demo")), ShellLine.calls("env -i A=\"$A\" steward demo > x.txt"));
    }

    @Test
    void whatIsWrongIsFound() throws IOException {
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
            """;
        List<String> lines = new ArrayList<>();
        for (String problem : problems(MarkdownPage.of("README.md", planted))) {
            lines.add(problem.replaceAll("^README.md:(\\d+): .*", "$1"));
        }
        assertEquals(List.of("6", "7", "8", "9", "10", "12", "13", "14", "15", "16", "3", "3", "3", "4", "4", "4"),
            lines);
    }

    @Test
    void theReadmeIsShortAndLeadsToEveryPage() throws IOException {
        int lines = Files.readAllLines(Path.of("README.md")).size();
        assertTrue(lines <= README_LINES, "the README has " + lines + " lines, expected at most " + README_LINES);

        TreeSet<String> missing = new TreeSet<>();
        MarkdownPage.all().stream().map(MarkdownPage::path).filter(path -> path.matches("docs/[^/]+"))
            .forEach(missing::add);
        for (String page : List.of("README.md", "docs/README.md")) {
            String folder = page.replace("README.md", "");
            MarkdownPage.read(page).links().forEach(link -> missing.remove(folder + link.text().replaceAll("#.*", "")));
        }
        assertEquals(new TreeSet<>(), missing);
    }

    private static long written(String text) {
        return GENERATED_PAGE.matcher(text).find() ? 0 : GENERATED.matcher(text).replaceAll("").lines().count();
    }

    @Test
    void theManualIsShortWithoutTheTablesThatCommandsWrite() throws IOException {
        assertEquals(2, written("one\n<!-- generated by x -->\n| a |\n<!-- /generated -->\ntwo\n"));
        assertEquals(0, written("# A page\n\nWritten by `steward tradeoff` on 2030-01-02.\n"));
        long lines = 0;
        try (DirectoryStream<Path> pages = Files.newDirectoryStream(Path.of("docs"), "*.md")) {
            for (Path page : pages) {
                lines += written(Files.readString(page));
            }
        }
        assertTrue(lines <= MANUAL_LINES, "docs/*.md have " + lines + " lines, expected at most " + MANUAL_LINES);
    }

    /** The version of the build has notes, and is the one that other builds are told to depend on. */
    @Test
    void theVersionIsTheSameWhereverItStands() {
        String version = found("^version = '([^']+)'$", "build.gradle").findFirst().orElseThrow();
        assertEquals(version, found("^## \\[([^\\]]+)\\] - \\d{4}-\\d\\d-\\d\\d$", "CHANGELOG.md").findFirst()
            .orElseThrow());
        assertEquals(List.of(version), found("steward(?:-engine)?(?::|</artifactId><version>)(\\d[\\w.]*)",
            "docs/library.md").distinct().toList());
    }

    private static Stream<String> found(String pattern, String file) {
        return Pattern.compile(pattern, Pattern.MULTILINE).matcher(SourceText.of(file)).results()
            .map(found -> found.group(1));
    }

    @Test
    void theFormatOfReplaysIsTheOneThatIsWritten() throws IOException {
        String page = Files.readString(Path.of("docs/replays.md"));
        assertTrue(page.contains("The format is number " + ReplayHeader.FORMAT + "."), "docs/replays.md");
    }

    @Test
    void thePageOnPythonHasTheReadmeOfThePackage() throws IOException {
        String readme = Files.readString(Path.of("src/python/README.md"));
        String text = "<!-- generated from src/python/README.md -->\n" + readme.substring(readme.indexOf("\n\n") + 2)
            + "<!-- /generated -->";
        assertTrue(Files.readString(Path.of("docs/python.md")).contains(text), "docs/python.md");
    }

    @Test
    void examplesOfThePagesAreTheFilesThatTheyName() throws IOException {
        TreeSet<String> files = new TreeSet<>();
        for (MarkdownPage page : MarkdownPage.all()) {
            Matcher example = FROM_FILE.matcher(Files.readString(Path.of(page.path())));
            while (example.find()) {
                files.add(Path.of(example.group(1)).getFileName().toString());
                assertEquals(Files.readString(Path.of(example.group(1))), example.group(2), page.path());
            }
        }
        assertEquals(new TreeSet<>(List.of("DroppedBall.java", "OneMatch.java", "ReplayStates.java",
            "Searcher.java", "heap.py")), files);
    }
}
