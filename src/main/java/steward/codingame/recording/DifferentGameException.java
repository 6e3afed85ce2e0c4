package steward.codingame.recording;

/** Thrown if the server sent other lines than our rules give; the message has the first of them. */
public final class DifferentGameException extends RuntimeException {

    DifferentGameException(String message) {
        super(message);
    }
}
