package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.isolation.Launch;

/** A debugger and the bot that it runs, each with an input and an output of its own. */
@Timeout(30)
class DebuggerTest {

    /** Stand-in for gdb with its option: starts the program behind the wrapper, by a shell. */
    private static final String STAND_IN = """
        #!/bin/sh
        [ "$1" = -iex ] || exit 9
        wrapper=${2#set exec-wrapper }
        shift 2
        echo said by the debugger
        sh -c "exec $wrapper $*"
        """;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"gdb, true", "/usr/bin/gdb, true", "x86_64-linux-gnu-gdb, true", "gdb-multiarch, true",
        "./arm-none-eabi-gdb, true", "gdbserver, false", "./mygdb.sh, false", "lldb, false", "gdb/bot, false",
        "python3, false"})
    void isKnownByItsName(String program, boolean isDebugger) {
        assertEquals(isDebugger, Debugger.is(List.of(program, "gdb")));
    }

    @Test
    @Tag("process")
    void theBotHasThePipesAndTheDebuggerHasNot() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "there is no /bin/sh");
        Path gdb = Files.writeString(folder.resolve("gdb"), STAND_IN);
        assertTrue(gdb.toFile().setExecutable(true));
        Path bot = Files.writeString(folder.resolve("bot.sh"), "read -r line; echo \"heard $line\"");
        // A session of its own has no terminal: what the debugger says goes to stderr then.
        List<String> words = new ArrayList<>(Launch.ownSession());
        assumeTrue(!words.isEmpty(), "there is no setsid");
        words.addAll(Debugger.onTerminal(List.of(gdb.toString(), "sh", bot.toString())));
        Process process = new ProcessBuilder(words).start();
        process.getOutputStream().write("hello\n".getBytes(StandardCharsets.UTF_8));
        process.getOutputStream().close();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertNotNull(process.onExit().get());
        assertEquals("heard hello\n", out, err);
        assertEquals("said by the debugger\n", err);
    }
}
