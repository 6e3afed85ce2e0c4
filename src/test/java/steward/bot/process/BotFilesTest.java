package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.command.Program;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;

/** A bot's folder, and its files, which it cannot change where bots are kept apart. */
@Tag("process")
class BotFilesTest {

    private static final String SCRIPT = "read -r l; { %s; } >/dev/null 2>&1; echo done; read -r l\n";

    /** Ways to change a file {@code $0} or {@code weights}, each by its own bot. */
    private static final List<String> ATTACKS = List.of(
        "echo >>\"$0\"", "echo >weights", "rm -f \"$0\"; echo >\"$0\"", "cp \"$0\" other && mv -f other \"$0\"",
        "ln \"$0\" same && echo >>same", "ln -sf weights \"$0\"", "chmod 777 \"$0\"; echo >>\"$0\"",
        "mv weights gone; echo >weights", "mount -o remount,bind,rw \"$0\"; echo >>\"$0\"",
        "umount \"$0\"; echo >>\"$0\"");

    @TempDir
    private Path folder;

    private String run(SandboxLevel level, String script, List<Program> others) throws IOException {
        Path bot = Files.writeString(folder.resolve("bot.sh"), script);
        try (BotProcess process = new BotProcess("bot", new Launch(new Program(List.of("sh", bot.toString(), "weights"),
                folder, null), Isolation.at(level), others), 0)) {
            return ScriptedBots.reply(process, "go\n");
        }
    }

    private int changed(SandboxLevel level) throws IOException {
        int changed = 0;
        for (String attack : ATTACKS) {
            for (Path left : List.of(folder.resolve("same"), folder.resolve("other"), folder.resolve("gone"))) {
                Files.deleteIfExists(left);
            }
            Path weights = Files.writeString(folder.resolve("weights"), "1 2 3");
            Files.deleteIfExists(folder.resolve("bot.sh"));
            String script = String.format(SCRIPT, attack);
            assertEquals("done", run(level, script, List.of()), attack);
            boolean same = Files.isRegularFile(folder.resolve("bot.sh"))
                && Files.readString(folder.resolve("bot.sh")).equals(script)
                && Files.readString(weights).equals("1 2 3");
            changed += same ? 0 : 1;
        }
        return changed;
    }

    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void aBotCannotChangeTheFilesThatMakeItThisBot(SandboxLevel level) throws IOException {
        ScriptedBots.assumeWorks(level);
        assertEquals(0, changed(level));
    }

    @Test
    void atOffItCan() throws IOException {
        ScriptedBots.assumeShell();
        assertTrue(changed(SandboxLevel.OFF) >= ATTACKS.size() - 2, "all but the two that mount");
    }

    @Test
    void withoutACompilerItCannotEither() throws IOException {
        ScriptedBots.assumeWorks(SandboxLevel.LIGHT);
        IOException[] problem = new IOException[1];
        SandboxProperty.withoutProgram(() -> {
            try {
                assertEquals(0, changed(SandboxLevel.LIGHT));
            } catch (IOException failed) {
                problem[0] = failed;
            }
        });
        assertEquals(null, problem[0]);
    }

    @Test
    void norThoseOfItsOpponentAtLight() throws IOException {
        ScriptedBots.assumeWorks(SandboxLevel.LIGHT);
        Path rival = Files.writeString(Files.createDirectory(folder.resolve("it's")).resolve("rival.sh"), "read -r l");
        run(SandboxLevel.LIGHT, String.format(SCRIPT, "echo >>\"it's/rival.sh\""),
            List.of(Program.here(List.of("sh", rival.toString()))));
        assertEquals("read -r l", Files.readString(rival));
    }

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void itIsStartedInItsFolder(SandboxLevel level) throws IOException {
        ScriptedBots.assumeWorks(level);
        Files.writeString(folder.resolve("weights"), "1 2 3");
        assertEquals(folder.toRealPath() + " 1 2 3",
            run(level, "read -r l; echo \"$(pwd -P) $(cat weights)\"; read -r l\n", List.of()));
    }
}
