package steward.replay;

/** A file that cannot be used as a replay; the message says where, what was found and what was expected. */
public class ReplayException extends RuntimeException {

    public ReplayException(String message) {
        super(message);
    }
}
