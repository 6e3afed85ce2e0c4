package steward.codingame.recording;

/** The server has sent other lines than our rules give; the message names the first. */
public final class DifferentGameException extends RuntimeException {

    DifferentGameException(String message) {
        super(message);
    }
}
