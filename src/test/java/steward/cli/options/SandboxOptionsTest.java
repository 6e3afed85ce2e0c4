package steward.cli.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.command.CommandLine;
import steward.bot.isolation.ResourceLimits;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.Cli;
import steward.cli.ShellBots;
import tools.jackson.databind.JsonNode;

/** {@code --sandbox} and what goes with it, as a user calls it. */
@Tag("process")
class SandboxOptionsTest {

    @TempDir
    private Path folder;

    private static void assumeWorks(SandboxLevel level) {
        String problem = SandboxSupport.problem(level);
        assumeTrue(problem == null, "skipped: level " + level.word() + " does not work here: " + problem);
    }

    private Cli match(String bot, String... more) {
        return Cli.run(List.of("match", "--scene", "duel", "--seed", "7", "--no-deadline",
            "--json",
            "--bot", bot, "--bot", new ShellBots(folder).driver("other", ShellBots.NOWHERE)), more);
    }

    /** A bot that says something on stderr and fails. */
    private String failing(String script) throws IOException {
        Path file = Files.writeString(folder.resolve("me.sh"), script + "; exit 1");
        return "me=sh " + CommandLine.quote(List.of(file.toString()));
    }

    private static String stderr(JsonNode match) {
        JsonNode lines = match.get("players").get(0).get("failure").get("stderr");
        List<String> all = new ArrayList<>();
        lines.forEach(line -> all.add(line.stringValue()));
        return String.join("\n", all);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        /        | expected the files or folders that the bot needs
        /dev     | expected a path outside /dev and /proc
        /proc/1  | expected a path outside /dev and /proc
        """)
    void whatStrictCannotShowIsRefused(String path, String message) {
        assumeWorks(SandboxLevel.STRICT);
        Cli.run("match", "--scene", "duel", "--bot", "sh", "--bot", "sh", "--sandbox", "strict", "--visible", path)
            .assertRefused("--visible: found '" + path + "', " + message);
    }

    @ParameterizedTest
    @CsvSource({"16777216, 16M", "1125899906842624, 1024T", "1536, 1536", "2048, 2K", "1023, 1023", "0, 0",
        "1572864, 1536K"})
    void sizesAreToldAsTheyAreWritten(long bytes, String text) {
        assertEquals(text, SandboxOptions.sizeText(bytes));
    }

    /** Nothing but what was measured tells the level: the lines of two replays are equal without it. */
    @Test
    void theLevelIsInTheResultAndInTheTimesOfTheReplayOnly() throws IOException {
        List<List<String>> replays = new ArrayList<>();
        for (SandboxLevel level : SandboxLevel.values()) {
            if (SandboxSupport.problem(level) != null) {
                continue;
            }
            Path file = folder.resolve(level.word() + ".jsonl");
            Cli cli = match(new ShellBots(folder).driver("me", ShellBots.CHECKPOINT), "--sandbox", level.word(),
                "--out",
                file.toString());
            assertEquals(level.word(), cli.json().get("sandbox").stringValue());
            List<String> lines = Files.readAllLines(file);
            assertTrue(lines.get(0).endsWith(",\"times\":{\"sandbox\":\"" + level.word() + "\"}}"), lines.get(0));
            replays.add(lines.stream().map(line -> line.replaceAll(",\"times\":\\{[^}]*\\}\\}$", "}")).toList());
            assertEquals(0, Cli.run("replay", file.toString(), "--verify").status());
        }
        replays.forEach(replay -> assertEquals(replays.get(0), replay));
    }

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void aSeriesSaysItToo(SandboxLevel level) {
        assumeWorks(level);
        JsonNode series = match(new ShellBots(folder).driver("me", ShellBots.CHECKPOINT), "--games", "2", "--sandbox",
            level.word()).json();
        assertEquals(level.word(), series.get("sandbox").stringValue());
    }

    @Test
    void aBotThatFailsAtOnceForWantOfAPathIsToldOfItsSandbox() throws IOException {
        String bot = failing("echo 'cannot write /usr/x: Read-only file system' >&2");
        for (SandboxLevel level : List.of(SandboxLevel.LIGHT, SandboxLevel.STRICT)) {
            assumeWorks(level);
            String hints = match(bot, "--sandbox",
                level.word()).json().get("players").get(0).get("failure").get("hints")
                .toString();
            assertTrue(hints.contains(level == SandboxLevel.LIGHT ? "does it run with --sandbox off?"
                : "--visible FOLDER lets it read more"), hints);
        }
        String off = match(bot, "--sandbox", "off").json().get("players").get(0).get("failure").get("hints").toString();
        assertFalse(off.contains("sandbox"), off);
        for (String other : List.of("at Socket.ondata (node:internal/streams/readable:561:12)", "no luck",
            "FileNotFoundError: No such file or directory: /no/such/file", "KeyError: HOME")) {
            String hints = match(failing("echo '" + other + "' >&2")).json().get("players").get(0).get("failure")
                .get("hints").toString();
            assertFalse(hints.contains("sandbox"), hints);
        }
    }

    /** The program's folder, the read-only rest, the private folder for temporary files; what is shown besides. */
    @Test
    void strictShowsItsOwnFilesAndNoOthers() throws IOException {
        assumeWorks(SandboxLevel.STRICT);
        Path other = Files.createDirectory(folder.resolve("elsewhere"));
        Files.writeString(other.resolve("secret"), "secret");
        String mark = folder.getFileName() + ".x";
        failing("ls " + folder + " >&2; cat " + other.resolve("secret") + " >/dev/null 2>&1 || echo none >&2; for f in "
            + "/tmp/" + mark + " /usr/" + mark + " " + folder.resolve(mark) + "; do echo x >$f; done 2>/dev/null;"
            + " ls /tmp >&2");
        Path mine = Files.createDirectory(folder.resolve("mine"));
        Files.move(folder.resolve("me.sh"), mine.resolve("me.sh"));
        String hidden = stderr(match("me=sh " + mine.resolve("me.sh"), "--sandbox", "strict").json());
        assertTrue(hidden.startsWith("mine\nnone\n") && hidden.contains(mark), hidden);
        for (String place : List.of("/tmp", "/usr", folder.toString())) {
            assertFalse(Files.exists(Path.of(place, mark)), "written into " + place);
        }
        String shown = stderr(match("me=sh " + mine.resolve("me.sh"), "--sandbox", "strict", "--visible",
            other.toString()).json());
        assertTrue(shown.startsWith("elsewhere\nmine\n") && !shown.contains("none"), shown);
    }

    /** {@code ulimit} says what holds inside: files may be in memory. A process that needs more memory ends. */
    @ParameterizedTest
    @EnumSource(value = SandboxLevel.class, names = {"LIGHT", "STRICT"})
    void limitsHold(SandboxLevel level) throws IOException {
        assumeWorks(level);
        String script = "ulimit -f >&2; ulimit -n >&2; "
            + "dd if=/dev/zero of=/dev/null bs=200M count=1 2>&1 | grep -c -E 'exhausted|allocate' >&2";
        String said = stderr(match(failing(script), "--sandbox", level.word(), "--memory", "64M", "--file-size", "1G",
            "--open-files", "99").json());
        assertEquals(ResourceLimits.LEAST_FILE_SIZE / 512 + "\n99\n1", said);
    }

    @ParameterizedTest
    @EnumSource(SandboxLevel.class)
    void theEnvironmentIsWhatIsAskedFor(SandboxLevel level) throws IOException {
        assumeWorks(level);
        String bot = failing("env | cut -d= -f1 | sort | tr '\\n' ' ' >&2");
        String clean = " " + stderr(match(bot, "--sandbox", level.word(), "--clean-env").json()) + " ";
        for (String name : clean.strip().split(" ")) {
            assertTrue(name.matches("PATH|HOME|USER|LOGNAME|SHELL|LANG|LANGUAGE|TZ|TERM|TMPDIR|JAVA_HOME|LC_.*|PWD|_"
                + "|OLDPWD|SHLVL"), name);
        }
        assertTrue(clean.contains(" PATH "), clean);
    }

    /** The loopback device is the only one, and it is down unless it is asked for; bwrap has it up always. */
    @Test
    void networkBringsUpTheLoopbackDevice() throws IOException {
        assumeWorks(SandboxLevel.LIGHT);
        String bot = failing("cut -d: -f1 /proc/net/dev | tail -n +3 | tr -d ' \\n' >&2; echo >&2;"
            + " cat /proc/net/if_inet6 /proc/net/fib_trie | wc -l >&2");
        String down = stderr(match(bot, "--sandbox", "light").json());
        String up = stderr(match(bot, "--sandbox", "light", "--network").json());
        assertTrue(down.startsWith("lo\n") && up.startsWith("lo\n"), down + up);
        assertFalse(down.equals(up), "it makes no difference: " + up);
    }

    /** Found by the example in docs/security.md: the builtin opponent could not start. */
    @Test
    void aBuiltinBotPlaysUnderALimitOfMemory() {
        assumeWorks(SandboxLevel.LIGHT);
        JsonNode json = match("builtin:racer", "--sandbox", "light", "--memory", "512M").json();
        assertTrue(json.get("players").get(0).get("fault").isNull(), json.toString());
    }
}
