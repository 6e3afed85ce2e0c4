package steward.cli.streams;

/**
 * Colours for a terminal, by the escape sequences of ECMA-48 (select graphic rendition). Text stays plain elsewhere, if
 * the environment variable {@code NO_COLOR} is set and not empty (no-color.org), or if the terminal is a {@code dumb}
 * one.
 */
public final class Colour {

    /** Leaves everything as it is. */
    public static final Colour NONE = new Colour(false);

    private static final String BOLD = "1";
    private static final String FAINT = "2";
    private static final String RED = "31";
    private static final String GREEN = "32";
    private static final String YELLOW = "33";

    private final boolean on;

    private Colour(boolean on) {
        this.on = on;
    }

    /** For an output of this process. */
    public static Colour of(boolean terminal) {
        return of(terminal, System.getenv("NO_COLOR"), System.getenv("TERM"));
    }

    /**
     * @param noColor value of {@code NO_COLOR}, or {@code null}
     * @param term    value of {@code TERM}, or {@code null}
     */
    static Colour of(boolean terminal, String noColor, String term) {
        return terminal && (noColor == null || noColor.isEmpty()) && !"dumb".equals(term) ? new Colour(true) : NONE;
    }

    /** Colours the most important text: the winner. */
    public String strong(String text) {
        return in(BOLD, text);
    }

    /** Dims the least important text: the omitted. */
    public String faint(String text) {
        return in(FAINT, text);
    }

    /** Colours text about things as they should be. */
    public String good(String text) {
        return in(GREEN, text);
    }

    /** Colours text about a failure. */
    public String bad(String text) {
        return in(RED, text);
    }

    /** Colours text about a possible fault. */
    public String warning(String text) {
        return in(YELLOW, text);
    }

    private String in(String rendition, String text) {
        return on ? "\u001b[" + rendition + "m" + text + "\u001b[0m" : text;
    }
}
