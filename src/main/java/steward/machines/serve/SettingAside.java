package steward.machines.serve;

/** Callback that sets the games of a machine aside, suspends them, or lets them count again. */
public interface SettingAside {

    /** What becomes of them. */
    enum Fate {
        /** They never count, and are played again. */
        ASIDE,
        /** They do not count until somebody decides. */
        SUSPENDED,
        /** Suspended ones count again. */
        RESTORED
    }

    /**
     * Decides.
     *
     * @param machine how the texts begin that say where its games were played
     * @param why     is noted with each
     * @return how many games are concerned
     */
    int decide(Fate fate, String machine, String why) throws InterruptedException;
}
