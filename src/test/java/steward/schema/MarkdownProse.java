package steward.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** Sentences of a page of Markdown: of paragraphs, list items, headings and cells of tables. */
final class MarkdownProse {

    private static final Pattern BEGINS_UNIT = Pattern.compile("(?:#+|[-*>]|\\d+\\.) .*");
    private static final Pattern CELL_END = Pattern.compile("(?<!\\\\)\\|");
    private static final Pattern SENTENCE_END = Pattern.compile("(?<=[.!?])[)\"*]*\\s+");
    private static final Pattern WORD = Pattern.compile("\\S*[\\p{L}\\p{N}_]\\S*");

    private final List<MarkdownPage.Piece> sentences = new ArrayList<>();
    private final StringBuilder unit = new StringBuilder();
    private int begun;

    /** Adds the next line of a page without the blanks around it; of code, fences and comments an empty one. */
    void add(int number, String line) {
        if (line.isEmpty() || line.startsWith("|") || BEGINS_UNIT.matcher(line).matches()) {
            end();
        }
        if (line.isEmpty()) {
            return;
        }
        for (String text : line.startsWith("|") ? CELL_END.split(line) : new String[] {line}) {
            begun = unit.isEmpty() ? number : begun;
            unit.append(text.strip()).append(' ');
            if (line.startsWith("|")) {
                end();
            }
        }
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

    /** Returns all sentences, each with the line in which its paragraph, item or cell begins. */
    List<MarkdownPage.Piece> sentences() {
        end();
        return sentences;
    }

    /** Returns the number of words; signs that stand alone are none. */
    static long words(String sentence) {
        return WORD.matcher(sentence).results().count();
    }
}
