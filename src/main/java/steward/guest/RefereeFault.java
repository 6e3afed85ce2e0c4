package steward.guest;

import java.io.IOException;
import java.io.UncheckedIOException;

/** Failure of a referee. It ends the game without a result, and is never the fault of a bot. */
public final class RefereeFault extends UncheckedIOException {

    /** @param problem a clause whose subject is the referee */
    RefereeFault(String problem) {
        super("the referee " + problem, new IOException(problem));
    }
}
