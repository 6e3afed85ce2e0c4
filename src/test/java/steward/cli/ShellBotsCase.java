package steward.cli;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Tests with bots that are shell scripts, each in a folder of its own. */
public abstract class ShellBotsCase {

    @TempDir
    protected Path folder;

    protected ShellBots bots;

    @BeforeEach
    final void makeBots() {
        bots = new ShellBots(folder);
    }
}
