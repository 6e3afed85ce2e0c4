package steward.cli.shared;

/** The options of a call do not go together, or one is out of range; the message is followed by a pointer to help. */
public final class CallException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    public CallException(String message) {
        super(message);
    }
}
