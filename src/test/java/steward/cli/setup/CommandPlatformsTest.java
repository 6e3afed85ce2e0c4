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

    /** The table is printed by a failure: put it into the page. */
    @Test
    void thePageHasARowForEachCommand() throws IOException {
        Streams nowhere = new Streams(OutputStream.nullOutputStream(), OutputStream.nullOutputStream(), false, false);
        List<String> commands = List.copyOf(Main.program(nowhere, null).getSubcommands().keySet());
        assertTrue(commands.contains("match"), commands.toString());
        String table = CommandPlatforms.table(commands);
        assertTrue(Files.readString(Path.of("docs/platforms.md")).contains(table),
            () -> "expected in the page:\n" + table);
        assertThrows(IllegalArgumentException.class, () -> CommandPlatforms.table(List.of("teleport")));
    }

    @Test
    void doctorSaysWhereNothingWasTried() {
        assertTrue(CommandPlatforms.item("linux-aarch64").works());
        assertFalse(CommandPlatforms.item("macos-aarch64").works());
        assertEquals("windows-x86_64: untried; what should work of each command is in docs/platforms.md",
            CommandPlatforms.item("windows-x86_64").detail());
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
