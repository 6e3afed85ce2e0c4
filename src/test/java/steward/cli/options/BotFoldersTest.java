package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Folders of bots: each {@code --in} is for the bot before it, however that bot's option is written. */
class BotFoldersTest {

    @Command
    private static final class Call {
        @Option(names = {"-b", "--bot"})
        private List<String> bots = new ArrayList<>();
        @Option(names = "-q")
        private boolean quiet;
        @Mixin
        private BotFolders folders = new BotFolders();
    }

    private static List<Path> folders(String... words) {
        Call call = new Call();
        new CommandLine(call).parseArgs(words);
        return call.folders.of("--bot");
    }

    @Test
    void aFolderIsForTheBotBeforeIt(@TempDir Path folder) throws IOException {
        Path own = Files.createDirectory(folder.resolve("own")).toRealPath();
        Path none = Path.of("");
        assertEquals(List.of(none, own), folders("--bot", "a", "--bot", "b", "--in", own.toString()));
        assertEquals(List.of(own, none), folders("--bot=a", "--in=" + own, "--bot=b"));
    }

    @Test
    void shortNamesNameBotsToo(@TempDir Path folder) throws IOException {
        Path own = Files.createDirectory(folder.resolve("own")).toRealPath();
        Path none = Path.of("");
        assertEquals(List.of(own, none), folders("-b", "a", "--in", own.toString(), "-b", "b"));
        assertEquals(List.of(none, own, none), folders("-q", "-ba", "-b=b", "--in", own.toString(), "--bot", "c"));
        assertEquals(List.of(own), folders("-qb", "a", "--in", own.toString()));
    }
}
