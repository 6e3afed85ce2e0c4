package steward.machines.check;

/** A game that did not happen as it is said. The message says what was found and what was expected. */
public final class DisprovedException extends Exception {

    private static final long serialVersionUID = 1;

    /** A game that is disproved. */
    public DisprovedException(String message) {
        super(message);
    }
}
