package steward.live;

import java.nio.charset.StandardCharsets;

/** Stream of server-sent events that many viewers follow, each at its own pace from its own position. Thread-safe. */
interface LiveFeed {

    /** Last piece of a feed: nothing follows. */
    Piece END = new Piece("event: end\ndata:\n\n".getBytes(StandardCharsets.UTF_8), -1);

    /**
     * Returns the first piece at or behind a position.
     *
     * @param position 0 at first, then {@link Piece#next} of the piece before
     * @return {@code null} if there is none yet, {@link #END} if there will be none
     */
    Piece piece(long position);

    /** True if nothing but the end follows what there is. */
    boolean isComplete();

    /** Calls this whenever there may be a new piece; from any thread. */
    void onChange(Runnable listener);

    /**
     * Bytes of one or more events.
     *
     * @param bytes shared by all viewers
     * @param next  the position behind them
     */
    record Piece(byte[] bytes, long next) { }
}
