package steward.game;

/**
 * Messages of one player's pods, units or chips, split in the order in which a view shows them. A replay keeps them
 * joined by {@value #BETWEEN}, without saying whose is which: a message is given to the first that shows one.
 */
public final class ShownMessages {

    private static final String BETWEEN = " | ";

    private final int longest;
    private final int kept;
    private final String more;
    private String left;

    /**
     * @param joined  what was said, or {@code null}
     * @param longest how many characters of a message are shown at most
     * @param kept    how many of a longer one
     * @param more    what is shown behind a message that was cut
     */
    public ShownMessages(String joined, int longest, int kept, String more) {
        this.longest = longest;
        this.kept = kept;
        this.more = more;
        left = joined == null ? "" : joined;
    }

    /**
     * The message that is to be shown.
     *
     * @param shown what is shown there
     * @param last  true if no place follows: then all that is left belongs here
     */
    public String next(String shown, boolean last) {
        String text = shown.strip();
        boolean whole = left.equals(text) || !text.isEmpty() && left.startsWith(text + BETWEEN);
        int end = last ? left.length() : text.isEmpty() ? 0 : whole ? text.length() : left.indexOf(BETWEEN);
        String message = left.substring(0, end < 0 ? left.length() : end);
        left = left.substring(Math.min(left.length(), message.isEmpty() ? 0 : message.length() + BETWEEN.length()));
        return message.length() <= longest ? message : message.substring(0, kept) + more;
    }
}
