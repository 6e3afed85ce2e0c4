package steward.codingame.recording;

/** Exception for a server that sent other lines than our rules give; the message has the first of them. */
public final class DifferentGameException extends RuntimeException {

    DifferentGameException(String message) {
        super(message);
    }
}
