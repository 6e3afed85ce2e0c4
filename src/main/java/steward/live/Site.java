package steward.live;

/** Pages of a server, and the feed that its front page follows. */
interface Site {

    /** Address of the feed, relative to the front page. */
    String FEED = "feed";

    /** The page at {@code /}. */
    byte[] front();

    LiveFeed feed();

    /**
     * Makes another page; may take its time.
     *
     * @param path without its first slash
     * @return {@code null} if there is none
     */
    byte[] page(String path);

    /** True if the other pages are files for a sandboxed frame, which has no origin. */
    default boolean isOpen() {
        return false;
    }

    /** Called when a page that was made has been sent to the last byte. */
    default void sent(byte[] page) { }
}
