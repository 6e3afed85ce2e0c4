package steward.cli.shared;

/** The options of a call do not go together, or one is out of range; who is told is also told where help is. */
public final class CallException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    public CallException(String message) {
        super(message);
    }
}
