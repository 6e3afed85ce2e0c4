package steward.cli.shared;

/** The call was right, but it could not be carried out to its end; the message says why. */
public final class FailedException extends RuntimeException {

    public FailedException(String message) {
        super(message);
    }
}
