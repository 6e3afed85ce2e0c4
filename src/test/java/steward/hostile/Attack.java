package steward.hostile;

/**
 * A hostile bot's attack, and its expected effect.
 *
 * @param what     in a few words, as the table names it
 * @param program  {@code sh} or {@code c}: which of the programs in {@code src/test/hostile} does it
 * @param word     its first argument
 * @param verdict  a pattern for the fault of the bot where the attack is held; {@code none} for no fault
 * @param off      what becomes of it without a sandbox; in a sandbox every attack is held
 * @param referee  whether it may end the referee, which then has a JVM of its own
 * @param factor   of the time limits: 1 for what is about time, otherwise generous
 * @param shortRun whether the usual tests play it too
 * @param limited  whether its memory is limited where there is a sandbox
 */
record Attack(String what, String program, String word, String verdict, Effect off, boolean referee, int factor,
              boolean shortRun, boolean limited) {

    /** Effect of an attack. */
    enum Effect {
        /** It harms only the bot itself: nothing is left, and the opponent and the match are unharmed. */
        HELD,
        /** Processes of the bot are left when the match is over. */
        ESCAPES,
        /** The opponent or the match is harmed, or something is seen that was not meant to be. */
        SUCCEEDS;

        String word() {
            return name().toLowerCase(java.util.Locale.ROOT);
        }
    }

    private static final int GENEROUS = 20;
    /** For those that look through all processes of a machine. */
    private static final int LONG = 200;

    /** One that is held everywhere. */
    static Attack held(String what, String program, String word, String verdict) {
        return new Attack(what, program, word, verdict, Effect.HELD, false, GENEROUS, false, false);
    }

    Attack off(Effect effect) {
        return new Attack(what, program, word, verdict, effect, referee, factor, shortRun, limited);
    }

    /** On a referee with a JVM of its own. */
    Attack onReferee() {
        return new Attack(what, program, word, verdict, off, true, LONG, shortRun, limited);
    }

    /** With the time limits as they are. */
    Attack inTime() {
        return new Attack(what, program, word, verdict, off, referee, 1, shortRun, limited);
    }

    /** With limits that hold on a machine with other work, too: taking memory is slow there. */
    Attack slow() {
        return new Attack(what, program, word, verdict, off, referee, LONG, shortRun, limited);
    }

    /** With a limit of its memory. */
    Attack limitedMemory() {
        return new Attack(what, program, word, verdict, off, referee, factor, shortRun, true);
    }

    /** In the usual tests too. */
    Attack often() {
        return new Attack(what, program, word, verdict, off, referee, factor, true, limited);
    }
}
