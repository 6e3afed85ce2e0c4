package steward.game;

import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.text.ViewLines;

/** Reader of the seed of a game of the site's server: the line {@code seed=NUMBER}, 64 bits, of its referee's input. */
public final class ShownSeed {

    private static final Pattern LINE = Pattern.compile("(?m)^\\s*seed=(-?[0-9]{1,19})\\s*$");

    private ShownSeed() { }

    /**
     * Reads the seed; empty if there is none.
     *
     * @param input field {@code refereeInput} of a recording
     */
    public static OptionalLong of(String input) {
        Matcher matcher = LINE.matcher(input);
        try {
            return matcher.find() ? OptionalLong.of(Long.parseLong(matcher.group(1))) : OptionalLong.empty();
        } catch (NumberFormatException tooLarge) {
            return OptionalLong.empty();
        }
    }

    /**
     * Reads the seed as {@link #of} does.
     *
     * @param source name of the file, for errors
     * @throws IllegalArgumentException if there is none
     */
    public static long required(String input, String source) {
        return of(input).orElseThrow(() -> new IllegalArgumentException(source + ": refereeInput: found "
            + (input.isBlank() ? "nothing" : ViewLines.quote(input)) + ", expected a line seed=NUMBER"));
    }
}
