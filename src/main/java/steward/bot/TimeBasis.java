package steward.bot;

import java.util.List;
import java.util.Locale;

/** Clock by which a player's time limits are measured. */
public enum TimeBasis {

    /** The time that passes from the frame to the answer, as on the site. */
    WALL,

    /**
     * The CPU time that the player's processes use for an answer, all threads summed. By the wall clock the answer may
     * take {@value #BACKSTOP} times the limit. For players that are not processes it is the same as {@link #WALL}.
     */
    CPU,

    /**
     * The time that passes, without that in which the player waited for a processor that programs outside of it used:
     * of a game that is played again on a busy machine. By the wall clock the answer may take {@value #BACKSTOP} times
     * the limit. Where the kernel does not show such waiting it is the same as {@link #WALL}. No word of a call.
     */
    UNSTARVED;

    /** Bases that a call can ask for. */
    public static final List<TimeBasis> CHOICES = List.of(WALL, CPU);

    /** Bound of the wall clock in limits, where the limit is not one of the wall clock. */
    public static final int BACKSTOP = 10;

    /** Returns the word as it is written in a call. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
