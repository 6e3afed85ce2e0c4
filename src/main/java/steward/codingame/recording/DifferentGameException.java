package steward.codingame.recording;

/** The server has sent other lines than our rules give; the message names the first. */
public final class DifferentGameException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    DifferentGameException(String message) {
        super(message);
    }
}
