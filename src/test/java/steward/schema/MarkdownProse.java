package steward.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Sentences of a page of Markdown: of paragraphs, list items, headings and cells of tables, without code blocks. */
final class MarkdownProse {

    private static final Pattern BEGINS_UNIT = Pattern.compile("(?:#+|[-*>]|\\d+\\.) .*");
    private static final Pattern CELL_END = Pattern.compile("(?<!\\\\)\\|");
    private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])[)\"*]*\\s+");
    private static final Pattern WORD = Pattern.compile("\\S*[\\p{L}\\p{N}_]\\S*");

    private final List<MarkdownPage.Piece> sentences = new ArrayList<>();
    private final StringBuilder unit = new StringBuilder();
    private int begun;

    private MarkdownProse() {
    }

    /** Returns all sentences of a page, each with the line in which its paragraph, item or cell begins. */
    static List<MarkdownPage.Piece> sentences(String text) {
        MarkdownProse prose = new MarkdownProse();
        boolean fenced = false;
        boolean mayBeCode = true;
        String[] lines = text.split("\n", -1);
        for (int k = 0; k < lines.length; k++) {
            String line = lines[k].strip();
            boolean fence = line.startsWith("```");
            boolean comment = line.startsWith("<!--");
            boolean code = fenced || fence || mayBeCode && lines[k].startsWith("    ");
            fenced ^= fence;
            mayBeCode = code || comment || line.isEmpty();
            if (mayBeCode || line.startsWith("|") || BEGINS_UNIT.matcher(line).matches()) {
                prose.end();
            }
            if (line.startsWith("|") && !code) {
                for (String cell : CELL_END.split(line)) {
                    prose.add(k + 1, cell.strip());
                    prose.end();
                }
            } else if (!mayBeCode) {
                prose.add(k + 1, line);
            }
        }
        prose.end();
        return prose.sentences;
    }

    private void add(int line, String text) {
        begun = unit.isEmpty() ? line : begun;
        unit.append(text).append(' ');
    }

    /** Divides the paragraph, item or cell that has been read; code within it is one word, a link the words shown. */
    private void end() {
        String words = unit.toString().replaceAll("`[^`]*`", "code").replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
            .replaceAll("<[^>]*>", " ");
        for (String sentence : SENTENCE_END.split(words.strip())) {
            sentences.add(new MarkdownPage.Piece(begun, sentence));
        }
        unit.setLength(0);
    }

    /** Returns the number of words; signs that stand alone are none. */
    static long words(String sentence) {
        return WORD.matcher(sentence).results().count();
    }
}
