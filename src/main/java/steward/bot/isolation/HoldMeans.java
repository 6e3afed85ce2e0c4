package steward.bot.isolation;

import steward.bot.hold.HoldPolicy;

/** Technique by which bots are held (stopped) while others are asked, at a level on this machine. */
public enum HoldMeans {

    /** The first process of the bot's namespace, which is the {@link NativeLauncher}, stops all others in it. */
    INIT("held, by the first process of their namespace"),
    /** The bot has a control group, which the kernel freezes. */
    CONTROL_GROUP("held, by control groups"),
    /** A meter alone: nothing can stop the bot. */
    MEASURED("measured and not held: that needs a C compiler or a delegated control group"),
    /** Bots may think on. */
    NONE("not held");

    private final String text;

    HoldMeans(String text) {
        this.text = text;
    }

    /** Treatment of bots that compute while others are asked, such as {@code held, by control groups}. */
    public String text() {
        return text;
    }

    /** Treatment of which bots, such as {@code burners are held, by control groups}; empty if there is none. */
    public static String text(Isolation isolation) {
        HoldMeans means = of(isolation);
        return means == NONE ? "" : (isolation.holds() == HoldPolicy.ALWAYS ? "waiting bots are " : "burners are ")
            + means.text;
    }

    /** The means for bots that are started so. */
    public static HoldMeans of(Isolation isolation) {
        if (isolation.holds() == HoldPolicy.NEVER) {
            return NONE;
        }
        if (isolation.level() != SandboxLevel.OFF && NativeLauncher.program() != null) {
            return INIT;
        }
        // At light only the launcher keeps bots from writing to the groups of others.
        return isolation.level() != SandboxLevel.LIGHT && ControlGroup.problem() == null ? CONTROL_GROUP : MEASURED;
    }
}
