package steward.files;

/** The call or an input cannot be used; the message tells the user what was found and what was expected. */
public final class InputException extends RuntimeException {

    public InputException(String message) {
        super(message);
    }
}
