package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.cli.Main;
import steward.cli.streams.Streams;

/** Platforms of commands: every command has a row in the page. */
class CommandPlatformsTest {

    /** Needs of a command, which decide where it works. */
    private enum Need {
        /** Nothing else. */
        JAVA("Java alone", "as on Linux", "as on Linux"),
        /** Starts bots or JVMs. */
        BOTS("starts bots", "no sandbox, no `--time cpu`", "no sandbox, no `--time cpu`, no process groups"),
        /** Runs programs that come with POSIX systems. */
        POSIX("a POSIX shell", "as on Linux", "does not work"),
        /** Asks the system who is at the other end of a socket, and with which limits. */
        LINUX_ONLY("a Unix socket, `/proc`", "does not work: `steward-play` and `steward-referee` start plainly",
            "does not work");

        private final String uses;
        private final String macos;
        private final String windows;

        Need(String uses, String macos, String windows) {
            this.uses = uses;
            this.macos = macos;
            this.windows = windows;
        }
    }

    /** @throws IllegalArgumentException if nothing is said of the command */
    private static Need of(String command) {
        return switch (command) {
            case "run", "replay", "scene", "explain", "simulate", "import", "key", "tradeoff", "new",
                "doctor", "help" -> Need.JAVA;
            case "match", "feed", "demo", "league", "worker", "sprt", "tune", "seeds", "check", "tournament", "referee",
                "play", "adopt" -> Need.BOTS;
            case "bench", "completion" -> Need.POSIX;
            case "resident" -> Need.LINUX_ONLY;
            default -> throw new IllegalArgumentException("no platforms are told for " + command);
        };
    }

    /** The table of all commands in Markdown. */
    private static String table(List<String> commands) {
        StringBuilder table = new StringBuilder(
            "| command | uses | Linux, WSL 2 | macOS, *untried* | Windows, *untried* |\n|---|---|---|---|---|\n");
        for (String command : commands) {
            Need need = of(command);
            table.append("| `").append(command).append("` | ").append(need.uses).append(" | works | ")
                .append(need.macos).append(" | ").append(need.windows).append(" |\n");
        }
        return table.toString();
    }

    /** The table is printed by a failure: put it into the page. */
    @Test
    void thePageHasARowForEachCommand() throws IOException {
        Streams nowhere = new Streams(OutputStream.nullOutputStream(), OutputStream.nullOutputStream(), false, false);
        List<String> commands = List.copyOf(Main.program(nowhere, null).getSubcommands().keySet());
        assertTrue(commands.contains("match"), commands.toString());
        String table = table(commands);
        assertTrue(Files.readString(Path.of("docs/platforms.md")).contains(table),
            () -> "expected in the page:\n" + table);
        assertThrows(IllegalArgumentException.class, () -> table(List.of("teleport")));
    }

    @Test
    void doctorSaysWhereNothingWasTried() {
        assertTrue(Checkup.platform("linux-aarch64").works());
        assertFalse(Checkup.platform("macos-aarch64").works());
        assertEquals("windows-x86_64: untried; what should work of each command is in docs/platforms.md",
            Checkup.platform("windows-x86_64").detail());
    }

    /** With wildcards for the class path, since the launcher for other systems names all jars. */
    @Test
    void theLauncherForWindowsTakesAllJarsAndPassesTheStatusOn() throws IOException {
        String launcher = Files.readString(Path.of("src/launcher/steward.bat"));
        assertTrue(launcher.contains("\\lib\\*;") && launcher.contains("\\lib\\machines\\*\" " + Main.class.getName()
            + " %*\r\nexit /b %ERRORLEVEL%\r\n"), launcher);
        assertEquals(launcher.chars().filter(c -> c == '\n').count(), launcher.chars().filter(c -> c == '\r').count());
    }
}
