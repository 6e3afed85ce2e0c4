package steward.bot.isolation;

import steward.bot.hold.HoldPolicy;

/** Technique by which bots are held (stopped) while others are asked, at a level on this machine. */
public enum HoldMeans {

    /** The first process of the bot's namespace, which is the {@link NativeLauncher}, stops all others in it. */
    INIT("stopped by the first process of their sandbox"),
    /** The bot has a control group, which the kernel freezes. */
    CONTROL_GROUP("stopped by control groups"),
    /** A meter alone: nothing can stop the bot. */
    MEASURED("measured and not stopped: that needs a C compiler or a delegated control group"),
    /** Bots may think on. */
    NONE("not stopped");

    private final String text;

    HoldMeans(String text) {
        this.text = text;
    }

    /** Treatment of bots that compute while others are asked, such as {@code stopped by control groups}. */
    public String text() {
        return text;
    }

    /** Sentence on the bots that are stopped, such as {@code waiting bots are stopped by ...}; empty if none are. */
    public static String text(Isolation isolation) {
        HoldMeans means = of(isolation);
        return means == NONE ? "" : (isolation.holds() == HoldPolicy.ALWAYS ? "waiting bots are "
            : "bots that use a processor out of turn are ") + means.text;
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
