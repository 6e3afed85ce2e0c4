package steward.bot.hold;

import java.util.Locale;

/** Policy for which bots are held (stopped) while others are asked. */
public enum HoldPolicy {

    /** Bots that {@link WaitingMeter#burns}, from then on. */
    BURNERS,
    /** All bots, from their first answer on. */
    ALWAYS,
    /** None: bots may think on. */
    NEVER;

    /** Returns the word as it is written in a call. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
