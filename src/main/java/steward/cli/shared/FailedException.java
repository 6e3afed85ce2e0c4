package steward.cli.shared;

/** Exception for a call that was right but could not be carried out to its end; the message says why. */
public final class FailedException extends RuntimeException {

    public FailedException(String message) {
        super(message);
    }
}
