package steward.bot.command;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Command line that is split into words by the quoting rules of the POSIX shell; words are also joined back into one
 * line. There is no shell: nothing is expanded, and {@code $}, {@code *}, {@code |}, {@code >} and {@code #} are
 * ordinary characters.
 *
 * <ul>
 * <li>Words are separated by spaces, tabs and newlines.
 * <li>Between single quotes everything stands for itself.
 * <li>Between double quotes a backslash protects {@code "}, {@code \}, {@code $} and {@code `}, and stands for itself
 * before anything else.
 * <li>Outside quotes a backslash protects the next character.
 * <li>A backslash at the end of a line, outside single quotes, joins it to the next line.
 * </ul>
 */
public final class CommandLine {

    private final String text;
    private final List<String> words = new ArrayList<>();
    private final StringBuilder word = new StringBuilder();
    private boolean inWord;
    private int at;

    private CommandLine(String text) {
        this.text = text;
    }

    /**
     * The words of a command line; none when it is empty or blank.
     *
     * @throws IllegalArgumentException when a quote is not closed, nothing follows a backslash, or there is a NUL
     *     character; the message names the column, counted from 1 in characters
     */
    public static List<String> split(String text) {
        return new CommandLine(text).split();
    }

    /** One line that {@link #split} takes apart into the same words; readable, and fit to paste into a shell. */
    public static String quote(List<String> words) {
        return words.stream().map(CommandLine::quote).collect(Collectors.joining(" "));
    }

    private static String quote(String word) {
        boolean plain = !word.isEmpty() && word.chars().allMatch(CommandLine::isPlain);
        return plain ? word : "'" + word.replace("'", "'\\''") + "'";
    }

    private static boolean isPlain(int c) {
        return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z' || c >= '0' && c <= '9' || "_-./:=,+@%".indexOf(c) >= 0;
    }

    private List<String> split() {
        int nul = text.indexOf('\0');
        if (nul >= 0) {
            throw error(nul, "a NUL character cannot be part of a command");
        }
        while (at < text.length()) {
            char c = text.charAt(at++);
            switch (c) {
                case ' ', '\t', '\n' -> endWord();
                case '\'' -> singleQuoted();
                case '"' -> doubleQuoted();
                case '\\' -> protectedCharacter();
                default -> add(c);
            }
        }
        endWord();
        return List.copyOf(words);
    }

    private void add(char c) {
        word.append(c);
        inWord = true;
    }

    private void endWord() {
        if (inWord) {
            words.add(word.toString());
            word.setLength(0);
            inWord = false;
        }
    }

    private void protectedCharacter() {
        if (at == text.length()) {
            throw error(at - 1, "nothing follows the backslash");
        }
        char c = text.charAt(at++);
        if (c != '\n') {
            add(c);
        }
    }

    private void singleQuoted() {
        int close = text.indexOf('\'', at);
        if (close < 0) {
            throw error(at - 1, "the single quote is never closed");
        }
        word.append(text, at, close);
        inWord = true;
        at = close + 1;
    }

    private void doubleQuoted() {
        int open = at - 1;
        inWord = true;
        while (at < text.length()) {
            char c = text.charAt(at++);
            if (c == '"') {
                return;
            }
            if (c != '\\' || at == text.length()) {
                word.append(c);
                continue;
            }
            char next = text.charAt(at++);
            if (next == '\n') {
                continue;
            }
            if ("\"\\$`".indexOf(next) < 0) {
                word.append('\\');
            }
            word.append(next);
        }
        throw error(open, "the double quote is never closed");
    }

    private IllegalArgumentException error(int index, String problem) {
        return new IllegalArgumentException("column " + (text.codePointCount(0, index) + 1) + ": " + problem);
    }
}
