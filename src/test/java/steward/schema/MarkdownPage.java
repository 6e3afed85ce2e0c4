package steward.schema;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.architecture.SourceText;

/**
 * Parts of a page of Markdown that the tests of the manual look at: code, code within sentences, links and headings.
 *
 * @param path      of the page, from the top of the repository
 * @param code      lines of code blocks, those continued by a backslash joined; blocks of JSON, Java or Python left out
 * @param spans     code within sentences
 * @param links     where links and pictures lead
 * @param headings  as fragments of a link
 * @param sentences each with the line in which its paragraph, item or cell begins
 */
record MarkdownPage(String path, List<Piece> code, List<Piece> spans, List<Piece> links, List<String> headings,
                    List<Piece> sentences) {

    private static final Set<String> OTHER_LANGUAGES = Set.of("json", "java", "python");
    private static final Pattern FENCE = Pattern.compile("\\s*```(\\w*)\\s*");
    private static final Pattern INDENTED = Pattern.compile(" {4}.*");
    private static final Pattern SPAN = Pattern.compile("`([^`]+)`");
    private static final Pattern LINK = Pattern.compile("\\[[^\\]]*\\]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("#{1,6} +(.*)");

    /** Pages that were read before: many link to the same. */
    private static final Map<String, MarkdownPage> READ = new HashMap<>();

    /**
     * A piece of the page.
     *
     * @param line the number of its first line
     * @param text what stands there
     */
    record Piece(int line, String text) {
    }

    /** README, manual, and what is written for contributors. */
    static List<MarkdownPage> all() throws IOException {
        List<String> paths = new ArrayList<>(List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"));
        paths.addAll(SourceText.ofKind(".md", "docs").keySet());
        List<MarkdownPage> pages = new ArrayList<>();
        for (String path : paths) {
            pages.add(read(path));
        }
        return pages;
    }

    static synchronized MarkdownPage read(String path) throws IOException {
        MarkdownPage page = READ.get(path);
        if (page == null) {
            page = of(path, Files.readString(Path.of(path)));
            READ.put(path, page);
        }
        return page;
    }

    static MarkdownPage of(String path, String text) {
        List<Piece> code = new ArrayList<>();
        List<String> headings = new ArrayList<>();
        MarkdownProse sentences = new MarkdownProse();
        StringBuilder prose = new StringBuilder();
        String fence = null;
        boolean mayBeCode = true;
        String[] lines = text.split("\n", -1);
        for (int k = 0; k < lines.length; k++) {
            String line = lines[k];
            Matcher mark = FENCE.matcher(line);
            boolean isCode = fence != null || mayBeCode && INDENTED.matcher(line).matches();
            if (mark.matches()) {
                fence = fence == null ? mark.group(1) : null;
            } else if (isCode && !OTHER_LANGUAGES.contains(fence == null ? "" : fence)) {
                addCode(code, k + 1, line.strip());
            } else if (!isCode) {
                prose.append(line);
            }
            prose.append('\n');
            boolean isComment = line.startsWith("<!--");
            sentences.add(k + 1, isCode || isComment || mark.matches() ? "" : line.strip());
            mayBeCode = isCode || isComment || line.isBlank();
            Matcher heading = HEADING.matcher(line);
            if (!isCode && heading.matches()) {
                headings.add(fragment(heading.group(1)));
            }
        }
        String withoutSpans = SPAN.matcher(prose).replaceAll(span -> span.group().replaceAll("[^\n]", "_"));
        return new MarkdownPage(path, List.copyOf(code), pieces(SPAN, prose.toString()), pieces(LINK, withoutSpans),
            distinct(headings), sentences.sentences());
    }

    private static void addCode(List<Piece> code, int number, String line) {
        Piece last = code.isEmpty() ? null : code.get(code.size() - 1);
        if (last != null && last.text().endsWith("\\")) {
            String begun = last.text().substring(0, last.text().length() - 1);
            code.set(code.size() - 1, new Piece(last.line(), begun + line));
        } else {
            code.add(new Piece(number, line));
        }
    }

    private static List<Piece> pieces(Pattern pattern, String prose) {
        List<Piece> pieces = new ArrayList<>();
        Matcher found = pattern.matcher(prose);
        while (found.find()) {
            int line = 1 + (int) prose.substring(0, found.start()).chars().filter(c -> c == '\n').count();
            pieces.add(new Piece(line, found.group(1).replaceAll("\\s+", " ")));
        }
        return pieces;
    }

    /** As GitHub makes it: lower case, no punctuation, hyphens for blanks. */
    private static String fragment(String heading) {
        return LINK.matcher(heading).replaceAll(link -> link.group().replaceAll("\\[|\\].*", ""))
            .toLowerCase(Locale.ROOT).strip().replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-');
    }

    /** Headings that stand on a page twice get numbers. */
    private static List<String> distinct(List<String> headings) {
        Map<String, Integer> seen = new HashMap<>();
        List<String> fragments = new ArrayList<>();
        for (String heading : headings) {
            int before = seen.merge(heading, 1, Integer::sum) - 1;
            fragments.add(before == 0 ? heading : heading + "-" + before);
        }
        return List.copyOf(fragments);
    }
}
