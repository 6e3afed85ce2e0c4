package steward.text;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Lines of one frame's text in a server's recording, which the site's viewer reads, counted from 0. Line 0 begins with
 * the number of the frame, perhaps with words around it. Errors name the frame and the line, what was found and what
 * was expected.
 */
public final class ViewLines {

    private static final int SHOWN = 60;

    /** A number as JSON and Java write it: no hexadecimal, no suffix, no name. */
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
    private static final Pattern FRAME_NUMBER = Pattern.compile("(?:[A-Z_]+)?\\s*([0-9]{1,9})(?:\\s.*)?");

    private final String source;
    private final int frame;
    private final String[] lines;

    /**
     * @param source name of the file, for errors
     * @param text   of the view, or {@code null} if the frame has none
     */
    public ViewLines(String source, int frame, String text) {
        this.source = source;
        this.frame = frame;
        lines = text == null || text.isBlank() ? new String[0] : text.stripTrailing().split("\r?\n", -1);
    }

    /** A text as it stands in an error: its beginning, in quotes. */
    public static String quote(String text) {
        return "\"" + TextFormat.beginning(text, SHOWN) + "\"";
    }

    /** The name of the file. */
    public String source() {
        return source;
    }

    /** A line; empty behind the last one. */
    public String line(int line) {
        return line < lines.length ? lines[line] : "";
    }

    /** The words of a line; none behind the last one. */
    public String[] words(int line) {
        return line(line).isBlank() ? new String[0] : lines[line].strip().split("\\s+");
    }

    /**
     * Checks that the view is that of its frame: where frames are missing, the numbers differ. A view without lines
     * passes.
     *
     * @throws IllegalArgumentException if it is that of another
     */
    public void checkNumber() {
        if (lines.length == 0) {
            return;
        }
        Matcher matcher = FRAME_NUMBER.matcher(lines[0].stripTrailing());
        if (!matcher.matches()) {
            throw wrong(0, "the number of the frame, " + frame);
        }
        if (Integer.parseInt(matcher.group(1)) != frame) {
            throw wrong(0, "the number of the frame, " + frame + ": frames are missing, or more than there were");
        }
    }

    /**
     * A word as a finite number.
     *
     * @param line for errors
     * @throws IllegalArgumentException if it is none
     */
    public double number(String word, int line) {
        double value = NUMBER.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
        if (Double.isFinite(value)) {
            return value;
        }
        throw wrongWord(word, line, "a finite number");
    }

    /**
     * A word as a whole number from 0.
     *
     * @param most the greatest that is allowed
     * @param line for errors
     * @throws IllegalArgumentException if it is none
     */
    public int whole(String word, int most, int line) {
        double value = number(word, line);
        if (value != Math.rint(value) || value < 0 || value > most) {
            throw wrongWord(word, line, "a whole number 0.." + most);
        }
        return (int) value;
    }

    /** The error about a word. */
    public IllegalArgumentException wrongWord(String word, int line, String expected) {
        return wrong(line, quote(word), expected);
    }

    /** The error about a whole line. */
    public IllegalArgumentException wrong(int line, String expected) {
        return wrong(line, line < lines.length ? quote(lines[line]) : "the end of the view", expected);
    }

    private IllegalArgumentException wrong(int line, String found, String expected) {
        return new IllegalArgumentException(source + ": frame " + frame + ", view line " + line + ": found " + found
            + ", expected " + expected);
    }
}
