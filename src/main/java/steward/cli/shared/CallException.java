package steward.cli.shared;

/**
 * Exception for a wrong call: options that exclude each other, or a value out of range. A pointer to help follows the
 * message.
 */
public final class CallException extends RuntimeException {

    public CallException(String message) {
        super(message);
    }
}
