package steward.cli.shared;

/** Thrown if the call was right but could not be carried out to its end; the message says why. */
public final class FailedException extends RuntimeException {

    public FailedException(String message) {
        super(message);
    }
}
