package steward.game;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One text with one word changed: tests give each of them to a comparison, which has to find the change.
 *
 * @param text the whole text
 * @param was  the word that was there
 * @param line the number of its line, from 0
 * @param word its number in the line, between blanks, from 0
 */
public record ChangedWords(String text, String was, int line, int word) {

    /** Returns a text for each word that matches a pattern. @param other what stands in its place */
    public static List<ChangedWords> of(String text, Pattern pattern, UnaryOperator<String> other) {
        List<ChangedWords> all = new ArrayList<>();
        Matcher word = pattern.matcher(text);
        while (word.find()) {
            String before = text.substring(0, word.start());
            String inLine = before.substring(before.lastIndexOf('\n') + 1);
            all.add(new ChangedWords(before + other.apply(word.group()) + text.substring(word.end()), word.group(),
                (int) before.chars().filter(c -> c == '\n').count(),
                (inLine + "x").strip().split("\\s+").length - 1));
        }
        return all;
    }

    /** Returns a word with another last digit, or with one more letter. */
    public static String otherEnd(String word) {
        char last = word.charAt(word.length() - 1);
        return Character.isDigit(last) ? word.substring(0, word.length() - 1) + (last - '0' + 5) % 10 : word + "x";
    }

    /** Returns how a line about changed words begins. */
    public static String told(String what, int changed, Object missed) {
        return what + ": " + changed + " numbers and words changed one at a time, not found: " + missed;
    }
}
