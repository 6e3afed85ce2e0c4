package steward.schema;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.architecture.SourceText;

/**
 * Page of Markdown, read by one pattern for each kind of its pieces.
 *
 * @param path from the top of the repository
 */
record MarkdownPage(String path, String text) {

    /** A fenced block and its language; or indented lines, after an empty line or a comment. */
    private static final Pattern BLOCK = Pattern.compile(
        "(?m)^[ \t]*```(\\w*)[ \t]*\n(?s:.*?)(?:^[ \t]*```\\w*[ \t]*$|\\z)|(?<=\\A|\n\n|-->\n)(?:^ {4}.*\n?)+");
    private static final Pattern SPAN = Pattern.compile("`([^`]+)`");
    private static final Pattern LINK = Pattern.compile("!?\\[([^\\]]*)\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#{1,6} +(.*)");
    /** An empty line, or one before a row of a table, a heading, an item or a quotation. */
    private static final Pattern UNIT_END = Pattern.compile("\n(?=[ \t]*(?:\n|\\||(?:#+|[-*>]|\\d+\\.) .))");
    private static final Pattern CELL_END = Pattern.compile("(?<!\\\\)\\|");
    private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])[)\"*]*\\s+");
    /** A page that a command writes as a whole; and tables between these comments. */
    private static final Pattern GENERATED_PAGE = Pattern.compile("(?m)^Written by `(?:steward|\\./gradlew) ");
    private static final Pattern GENERATED = Pattern.compile("(?s)<!-- generated.*?<!-- /generated -->\n?");

    /** README, manual, and what is written for contributors. */
    static List<MarkdownPage> all() {
        return Stream.concat(Stream.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"),
            SourceText.ofKind(".md", "docs").keySet().stream()).map(MarkdownPage::read).toList();
    }

    static MarkdownPage read(String path) {
        return new MarkdownPage(path, SourceText.of(path));
    }

    /** Lines of code blocks, those continued by a backslash joined; blocks of JSON, Java or Python are left out. */
    Stream<String> code() {
        return BLOCK.matcher(text).results().filter(block -> !("" + block.group(1)).matches("json|java|python"))
            .flatMap(block -> block.group().replaceAll("\\\\\n\\s*", "").lines()).map(String::strip)
            .filter(line -> !line.isEmpty() && !line.startsWith("```"));
    }

    private String prose() {
        return BLOCK.matcher(text).replaceAll("\n\n");
    }

    /** Code within sentences. */
    Stream<String> spans() {
        return SPAN.matcher(prose()).results().map(span -> span.group(1).strip().replaceAll("\\s+", " "));
    }

    /** Places where links and pictures lead. */
    Stream<String> links() {
        return LINK.matcher(SPAN.matcher(prose()).replaceAll("code")).results().map(link -> link.group(2));
    }

    /** Headings as fragments of a link, as GitHub makes them. */
    List<String> headings() {
        return HEADING.matcher(prose()).results().map(heading -> heading.group(1).toLowerCase(Locale.ROOT).strip()
            .replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-')).toList();
    }

    /**
     * Sentences of headings, paragraphs, items and cells. Code is one word, a link the words shown. Lines of figures
     * are left out, on pages that a command writes as a whole.
     */
    Stream<String> sentences() {
        String plain = prose().replaceAll(isGenerated() ? "(?m)^(?:<!--|[|>]).*$" : "(?m)^<!--.*$", "");
        plain = LINK.matcher(SPAN.matcher(plain).replaceAll("code")).replaceAll("$1").replaceAll("<[^>]*>", " ");
        return UNIT_END.splitAsStream(plain).map(String::strip)
            .flatMap(unit -> unit.startsWith("|") ? CELL_END.splitAsStream(unit) : Stream.of(unit))
            .flatMap(SENTENCE_END::splitAsStream);
    }

    private boolean isGenerated() {
        return GENERATED_PAGE.matcher(text).find();
    }

    /** Returns the number of lines that people write. */
    long written() {
        return isGenerated() ? 0 : GENERATED.matcher(text).replaceAll("").lines().count();
    }
}
