package steward.cli.shared;

/** Error of a call: its options do not go together, or one is out of range. A pointer to help follows the message. */
public final class CallException extends RuntimeException {

    public CallException(String message) {
        super(message);
    }
}
