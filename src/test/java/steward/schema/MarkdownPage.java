package steward.schema;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.architecture.SourceText;

/**
 * Page of Markdown, read by one pattern for each kind of its pieces.
 *
 * @param path from the top of the repository
 */
record MarkdownPage(String path, String text) {

    private static final Set<String> OTHER_LANGUAGES = Set.of("json", "java", "python");
    /** A fenced block and its language; or indented lines, after an empty line or a comment. */
    private static final Pattern BLOCK = Pattern.compile(
        "(?m)^[ \t]*```(\\w*)[ \t]*\n(?s:.*?)(?:^[ \t]*```\\w*[ \t]*$|\\z)|(?<=\\A|\n\n|-->\n)(?:^ {4}.*\n?)+");
    private static final Pattern LINE = Pattern.compile("(?m)^[ \t]*+(?!```)(\\S.*(?:(?<=\\\\)\n.*)*)");
    private static final Pattern SPAN = Pattern.compile("`([^`]+)`");
    private static final Pattern LINK = Pattern.compile("\\[[^\\]]*\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#{1,6} +(.*)");
    /** A row of a table; or a heading, an item or a paragraph, up to a line that begins another. */
    private static final Pattern UNIT = Pattern.compile(
        "(?m)^[ \t]*+(\\|.*|\\S.*(?:\n(?![ \t]*+(?:$|\\||(?:#+|[-*>]|\\d+\\.) .)).*)*)");
    private static final Pattern CELL_END = Pattern.compile("(?<!\\\\)\\|");
    private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])[)\"*]*\\s+");
    /** A page that a command writes as a whole; and tables between these comments. */
    private static final Pattern GENERATED_PAGE = Pattern.compile("(?m)^Written by `steward ");
    private static final Pattern GENERATED = Pattern.compile("(?s)<!-- generated.*?<!-- /generated -->\n?");

    /** Piece of a page, and the number of the line where it begins. */
    record Piece(int line, String text) {

        private Piece with(String pattern, String replacement) {
            return new Piece(line, text.replaceAll(pattern, replacement).strip());
        }
    }

    /** README, manual, and what is written for contributors. */
    static List<MarkdownPage> all() {
        return Stream.concat(Stream.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"),
            SourceText.ofKind(".md", "docs").keySet().stream()).map(MarkdownPage::read).toList();
    }

    static MarkdownPage read(String path) {
        return new MarkdownPage(path, SourceText.of(path));
    }

    private static int line(String text, int at) {
        return 1 + (int) text.substring(0, at).chars().filter(c -> c == '\n').count();
    }

    private static Stream<Piece> pieces(Pattern pattern, String text, int first) {
        return pattern.matcher(text).results()
            .map(found -> new Piece(first - 1 + line(text, found.start(1)), found.group(1)));
    }

    /** Lines of code blocks, those continued by a backslash joined; blocks of JSON, Java or Python are left out. */
    List<Piece> code() {
        return BLOCK.matcher(text).results().filter(block -> !OTHER_LANGUAGES.contains("" + block.group(1)))
            .flatMap(block -> pieces(LINE, block.group(), line(text, block.start())))
            .map(line -> line.with("\\\\\n\\s*", "")).toList();
    }

    private String prose() {
        return BLOCK.matcher(text).replaceAll(block -> block.group().replaceAll(".", ""));
    }

    /** Code within sentences. */
    List<Piece> spans() {
        return pieces(SPAN, prose(), 1).map(span -> span.with("\\s+", " ")).toList();
    }

    /** Places where links and pictures lead. */
    List<Piece> links() {
        return pieces(LINK, SPAN.matcher(prose()).replaceAll(span -> span.group().replaceAll(".", "_")), 1).toList();
    }

    /** Headings as fragments of a link, as GitHub makes them; those that stand on a page twice get numbers. */
    List<String> headings() {
        Map<String, Integer> seen = new HashMap<>();
        List<String> fragments = new ArrayList<>();
        pieces(HEADING, prose(), 1).forEach(heading -> {
            String fragment = heading.text().replaceAll("\\[([^\\]]*)\\]\\([^)\\s]+\\)", "$1").toLowerCase(Locale.ROOT)
                .strip().replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-');
            int before = seen.merge(fragment, 1, Integer::sum) - 1;
            fragments.add(before == 0 ? fragment : fragment + "-" + before);
        });
        return fragments;
    }

    /**
     * Sentences of headings, paragraphs, items and cells, with the line where that begins. Code is one word, a link the
     * words shown. Lines of figures are left out, on pages that a command writes as a whole.
     */
    List<Piece> sentences() {
        String figures = isGenerated() ? "(?m)^(?:<!--|[|>]).*$" : "(?m)^<!--.*$";
        return pieces(UNIT, prose().replaceAll(figures, ""), 1).flatMap(unit ->
            (unit.text().startsWith("|") ? CELL_END.splitAsStream(unit.text()) : Stream.of(unit.text()))
                .map(cell -> cell.replaceAll("`[^`]*`", "code").replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
                    .replaceAll("<[^>]*>|\\s+", " ").strip())
                .flatMap(SENTENCE_END::splitAsStream).map(sentence -> new Piece(unit.line(), sentence))).toList();
    }

    private boolean isGenerated() {
        return GENERATED_PAGE.matcher(text).find();
    }

    /** Returns the number of lines that people write. */
    long written() {
        return isGenerated() ? 0 : GENERATED.matcher(text).replaceAll("").lines().count();
    }
}
