package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.function.Executable;

/** Calls that are refused for what they are given. */
public final class Refusal {

    private Refusal() {
    }

    /** Checks that a call is refused with a message. */
    public static void refused(String message, Executable call) {
        assertEquals(message, message(call));
    }

    /** Checks that a call is refused with a message that has a part. */
    public static void refusedFor(String part, Executable call) {
        String message = message(call);
        assertTrue(message.contains(part), message);
    }

    private static String message(Executable call) {
        return assertThrows(IllegalArgumentException.class, call).getMessage();
    }
}
