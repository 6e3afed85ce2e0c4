package steward.text;

import java.io.IOException;
import java.io.Reader;

/**
 * Reader of lines from an input that may be endless: a line that is too long is abandoned before it fills the memory.
 */
public final class BoundedLine {

    private BoundedLine() { }

    /**
     * Reads up to the next line feed.
     *
     * @param most how many characters are wanted of a line, at least 1
     * @return the line without its line feed, or its first {@code most + 1} characters if it is longer, or {@code null}
     *         at the end of the input
     */
    public static String read(Reader in, int most) throws IOException {
        int character = in.read();
        if (character < 0) {
            return null;
        }
        StringBuilder line = new StringBuilder();
        for (; character >= 0 && character != '\n'; character = in.read()) {
            line.append((char) character);
            if (line.length() > most) {
                break;
            }
        }
        return line.toString();
    }
}
