package steward.machines.check;

/** Exception for a reported game that cannot have happened. The message gives what was found and what was expected. */
public final class DisprovedException extends Exception {

    private final boolean computed;

    private DisprovedException(String message, boolean computed) {
        super(message);
        this.computed = computed;
    }

    /** A report that cannot be used, which may have an honest reason. */
    public DisprovedException(String message) {
        this(message, false);
    }

    /** A game of which the referee computes something else from the recorded commands. */
    public static DisprovedException computed(String message) {
        return new DisprovedException(message, true);
    }

    /** True if the referee computes something else. No honest worker of the same rules reports such a game. */
    public boolean isComputed() {
        return computed;
    }
}
