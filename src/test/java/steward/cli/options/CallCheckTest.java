package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import steward.cli.shared.CallException;
import steward.files.InputException;

/** Options out of range or at odds with each other are refused, by the same words in every command. */
class CallCheckTest {

    private final CallCheck check = CallCheck.brief();

    private static void refused(String message, Executable call) {
        assertEquals(message, assertThrows(InputException.class, call).getMessage());
    }

    @Test
    void bothEndsOfARangeAreInIt() {
        assertDoesNotThrow(() -> check.range("--port", 0, 0, 9));
        assertDoesNotThrow(() -> check.range("--port", 9, 0, 9));
        assertDoesNotThrow(() -> check.range("--port", null, 0, 9));
        refused("--port: found -1, expected 0 to 9", () -> check.range("--port", -1, 0, 9));
        refused("--port: found 10, expected 0 to 9", () -> check.range("--port", 10L, 0, 9));
    }

    @Test
    void gamesHaveTheSameBoundsEverywhere() {
        assertDoesNotThrow(() -> check.games(1_000_000));
        refused("--games: found 0, expected 1 to 1000000", () -> check.games(0));
    }

    @Test
    void oneOfTwoExclusiveOptionsIsFine() {
        assertDoesNotThrow(() -> check.exclusive("--a", true, "--b", false));
        assertDoesNotThrow(() -> check.exclusive("--a", false, "--b", true));
        refused("--a and --b exclude each other", () -> check.exclusive("--a", true, "--b", true));
    }

    @Test
    void namesChooseInTheOrderOfWhatThereIs() {
        List<String> all = List.of("masses", "speeds", "corners");
        assertEquals(all, check.chosen("--case", List.of(), all, Function.identity()));
        assertEquals(List.of("masses", "corners"),
            check.chosen("--case", List.of("corners", "masses"), all, Function.identity()));
        refused("--case: found 'mases', expected one of masses, speeds, corners; did you mean 'masses'?",
            () -> check.chosen("--case", List.of("mases"), all, Function.identity()));
    }

    @Test
    void aCommandWithHelpPointsToIt() {
        assertEquals("wrong", assertThrows(CallException.class, () -> CallCheck.withHelp().that(false, "wrong"))
            .getMessage());
    }
}
