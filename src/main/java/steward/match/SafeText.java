package steward.match;

import java.nio.charset.StandardCharsets;
import steward.text.TextFormat;

/** Texts from players, escaped and shortened so that they are safe to print on a terminal and to store in a replay. */
public final class SafeText {

    /** Characters of a line that are quoted. */
    private static final int MOST = 120;
    /** The most bytes of UTF-8 per Java character, which bounds how much must be decoded. */
    private static final int BYTES_PER_CHARACTER = 4;
    private static final char REPLACEMENT = '\uFFFD';

    private SafeText() { }

    /** The beginning of a line, with escapes for characters that cannot be seen. */
    public static String line(byte[] bytes, int length) {
        String line = new String(bytes, 0, Math.min(length, BYTES_PER_CHARACTER * MOST), StandardCharsets.UTF_8);
        return TextFormat.beginning(TextFormat.escaped(line, ""), MOST);
    }

    /**
     * The fault of a player whose answer cannot be used. The fault may quote the answer, so it is made safe as well.
     *
     * @param wrong what is wrong with the answer
     */
    public static String fault(String wrong, byte[] answer, int length) {
        return wellFormed(TextFormat.escaped(wrong, "")) + "; received: " + line(answer, length);
    }

    /**
     * The text with U+FFFD in place of every unpaired surrogate: JSON can contain one, UTF-8 cannot.
     *
     * @return {@code null} for {@code null}
     */
    static String wellFormed(String text) {
        if (text == null || text.chars().noneMatch(c -> Character.isSurrogate((char) c))) {
            return text;
        }
        StringBuilder fit = new StringBuilder(text.length());
        text.codePoints().forEach(point -> {
            boolean half = point <= Character.MAX_VALUE && Character.isSurrogate((char) point);
            fit.appendCodePoint(half ? REPLACEMENT : point);
        });
        return fit.toString();
    }
}
