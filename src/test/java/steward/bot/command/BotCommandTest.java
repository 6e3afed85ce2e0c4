package steward.bot.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.BotCommand.Prefix;
import steward.bot.process.ScriptedBots;

/** How a bot is named on the command line, and what is said when it cannot be started. */
class BotCommandTest {

    private static final Path HERE = Path.of("");

    private static void reads(String text, String name, Prefix prefix, String... words) {
        BotCommand command = BotCommand.parse(text);
        assertEquals(new BotCommand(name, prefix, List.of(words)), command, text);
        assertEquals(command, BotCommand.parse(command.toString()), () -> "written as " + command);
    }

    private static String failure(String text) {
        return assertThrows(IllegalArgumentException.class, () -> BotCommand.parse(text).resolve(HERE)).getMessage();
    }

    @Test
    void nameAndPrefixAreOptional() {
        reads("./racer", null, Prefix.JSON, "./racer");
        reads("json:./racer", null, Prefix.JSON, "./racer");
        reads("builtin:racer", null, Prefix.BUILTIN, "racer");
        reads("codingame:python3 b.py", null, Prefix.CODINGAME, "python3", "b.py");
        reads("blue=python3 'my bot.py' -v", "blue", Prefix.JSON, "python3", "my bot.py", "-v");
        reads("a.b_c-9=builtin:racer --calm", "a.b_c-9", Prefix.BUILTIN, "racer", "--calm");
        reads("blue=json:'python3 b.py'", "blue", Prefix.JSON, "python3 b.py");
    }

    @Test
    void wordsThatAShellHasSplitMayBeginWithNameAndPrefix() {
        assertEquals(new BotCommand(null, Prefix.CODINGAME, List.of("sh", "-c", "a b")),
            BotCommand.of(List.of("sh", "-c", "a b"), Prefix.CODINGAME));
        assertEquals(new BotCommand("blue", Prefix.JSON, List.of("my bot", "c=d")),
            BotCommand.of(List.of("blue=json:my bot", "c=d"), Prefix.CODINGAME));
        assertEquals(new BotCommand(null, Prefix.BUILTIN, List.of("racer")),
            BotCommand.of(List.of("builtin:", "racer"), Prefix.JSON));
        assertEquals("bot 'json:': there is no command; expected " + BotCommand.FORM, assertThrows(
            IllegalArgumentException.class, () -> BotCommand.of(List.of("json:"), Prefix.JSON)).getMessage());
    }

    @Test
    void anEqualsSignAfterABlankOrQuoteIsPartOfTheCommand() {
        reads("racer a=b", null, Prefix.JSON, "racer", "a=b");
        reads("'x'=y", null, Prefix.JSON, "x=y");
        reads("=y", null, Prefix.JSON, "=y");
        reads("x/y=z", null, Prefix.JSON, "x/y=z");
        reads("a=b=c", "a", Prefix.JSON, "b=c");
        reads("json:a=b", null, Prefix.JSON, "a=b");
        reads("json:json:a", null, Prefix.JSON, "json:a");
    }

    @Test
    void anEmptyCommandIsAnError() {
        assertEquals("bot '': there is no command; expected [NAME=][builtin:|json:|codingame:]COMMAND", failure(""));
        assertEquals("bot 'blue=json: ': there is no command after 'blue=json:';"
            + " expected [NAME=][builtin:|json:|codingame:]COMMAND", failure("blue=json: "));
        assertEquals("bot '': the command is an empty word; expected a program", failure("''"));
    }

    @Test
    void aNameWithOtherCharactersIsNoPartOfAProgram() {
        assertEquals("bot 'x\u202ey=builtin:racer': found the name 'x\u202ey', expected one of letters, digits, dots, "
            + "underscores and hyphens", failure("x\u202ey=builtin:racer"));
        reads("sh -c x=json:a", null, Prefix.JSON, "sh", "-c", "x=json:a");
    }

    @Test
    void anOpenQuoteIsReportedByItsColumnInTheWholeText() {
        assertEquals("bot 'blue=json:a 'b', column 13: the single quote is never closed", failure("blue=json:a 'b"));
    }

    @Test
    void aBotIsDisplayedByItsNameOrItsProgram(@TempDir Path folder) throws IOException {
        Path script = Files.createFile(folder.resolve("b.py"));
        assertEquals("blue", BotCommand.parse("blue=./a.out").displayName(HERE));
        assertEquals("a.out", BotCommand.parse("bin/a.out map.json").displayName(HERE));
        assertEquals("racer", BotCommand.parse("builtin:racer").displayName(HERE));
        assertEquals("b.py", BotCommand.parse("python3 -u " + script).displayName(HERE));
        assertEquals("python3", BotCommand.parse("python3 -m nothing.of.this.name").displayName(HERE));
    }

    @Test
    void aCommandThatIsThereResolvesToItsWords() {
        ScriptedBots.assumeShell();
        assertEquals(List.of("sh", "-c", "echo 1"), BotCommand.parse("x=sh -c 'echo 1'").resolve(HERE));
        assertEquals(List.of("sh"), BotCommand.parse("codingame:sh").resolve(HERE));
    }

    @Test
    void aCommandThatIsNotThereIsAnErrorAtOnce(@TempDir Path folder) {
        assertEquals("bot 'no-such-bot -v': there is no program 'no-such-bot' on the PATH", failure("no-such-bot -v"));
        assertEquals("bot 'python3 b.py': there is no program 'python3 b.py' on the PATH;"
            + " its quotes make it one word: without them it is a command and its arguments",
            failure("'python3 b.py'"));
        String absent = folder + "/no/bot";
        assertEquals("bot '" + absent + "': there is no file '" + absent + "'", failure(absent));
        assertEquals("bot './no-such-bot': there is no file './no-such-bot' in " + Path.of("").toAbsolutePath(),
            failure("./no-such-bot"));
        assertEquals("bot 'jason:bot': there is no program 'jason:bot' on the PATH;"
            + " the known prefixes are builtin: json: codingame:", failure("jason:bot"));
    }

    @Test
    void directoriesAndPlainFilesAreNoPrograms(@TempDir Path folder) throws IOException {
        Path plain = Files.createFile(folder.resolve("bot.py"));
        assertEquals("bot '" + folder + "': '" + folder + "' is a directory; expected an executable program",
            failure(folder.toString()));
        assertEquals("bot '" + plain + "': '" + plain + "' is not executable; make it so with chmod +x,"
            + " or name its interpreter before it", failure(plain.toString()));
        Path source = Files.createFile(folder.resolve("bot.cpp"));
        assertEquals("bot '" + source + "': '" + source + "' is not executable; compile it, and name the program",
            failure(source.toString()));
        assertTrue(plain.toFile().setExecutable(true));
        assumeTrue(Files.isExecutable(plain), "files in the temporary directory cannot be executable");
        assertEquals(List.of(plain.toString()), BotCommand.parse(plain.toString()).resolve(HERE));
    }

    @Test
    void builtinBotsStartTheJvmThatIsRunningWithOptionsThatCanBeReplaced() {
        String before = System.clearProperty(BuiltinBots.JVM_OPTIONS);
        try {
            BuiltinBots builtins = new BuiltinBots("racer = pod a.b.Racer --mild 'x y'");
            List<String> command = BotCommand.parse("builtin:racer --fast").resolve(builtins, HERE);
            assertEquals(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xshare:auto", "-XX:-UsePerfData", "-cp",
                System.getProperty("java.class.path"), "a.b.Racer", "--mild", "x y", "--fast"), command);

            System.setProperty(BuiltinBots.JVM_OPTIONS, "-Xmx64m '-Dx=a b'");
            assertEquals(List.of("-Xmx64m", "-Dx=a b", "-cp"), builtins.command("racer", List.of()).subList(1, 4));
            System.setProperty(BuiltinBots.JVM_OPTIONS, "'");
            Exception e = assertThrows(IllegalArgumentException.class, () -> builtins.command("racer", List.of()));
            assertEquals("system property steward.bot.jvm, column 1: the single quote is never closed", e.getMessage());
        } finally {
            System.clearProperty(BuiltinBots.JVM_OPTIONS);
            if (before != null) {
                System.setProperty(BuiltinBots.JVM_OPTIONS, before);
            }
        }
    }

    @Test
    void anUnknownBuiltinBotIsAnErrorThatKnowsBetter() {
        BuiltinBots builtins = new BuiltinBots("# bots\nracer = pod R\nblocker = ball B\nplain = pod P\n");
        assertEquals(List.of("racer", "blocker", "plain"), builtins.names());
        assertEquals(List.of("racer", "plain"), builtins.of("pod"));
        Exception near = assertThrows(IllegalArgumentException.class,
            () -> BotCommand.parse("builtin:Racr").resolve(builtins, HERE));
        assertEquals("bot 'builtin:Racr': there is no builtin bot 'Racr'; did you mean 'racer'?"
            + " There are: racer, plain (pod); blocker (ball)", near.getMessage());
        Exception far = assertThrows(IllegalArgumentException.class, () -> builtins.command("zzz", List.of()));
        assertEquals("there is no builtin bot 'zzz'; there are: racer, plain (pod); blocker (ball)", far.getMessage());
        Exception none = assertThrows(IllegalArgumentException.class,
            () -> new BuiltinBots("").command("racer", List.of()));
        assertEquals("there is no builtin bot 'racer': this installation has none"
            + " (no steward/bots/builtin.properties on the class path)", none.getMessage());
    }

    @Test
    void neighboursThatChangedPlacesAreOneSlip() {
        BuiltinBots builtins = new BuiltinBots("racer = pod a.Racer");
        assertEquals("there is no builtin bot 'arcer'; did you mean 'racer'? There are: racer (pod)",
            assertThrows(IllegalArgumentException.class, () -> builtins.command("arcer", List.of())).getMessage());
        assertEquals("there is no builtin bot 'aecer'; there are: racer (pod)",
            assertThrows(IllegalArgumentException.class, () -> builtins.command("aecer", List.of())).getMessage());
    }

    @Test
    void noNameIsNull() {
        assertNull(BotCommand.parse("x").name());
        assertThrows(IllegalArgumentException.class, () -> new BotCommand("x", Prefix.JSON, List.of()));
    }

    @Test
    void aNameIsBounded() {
        reads("n".repeat(100) + "=builtin:racer", "n".repeat(100), Prefix.BUILTIN, "racer");
        assertEquals("bot '" + "n".repeat(20) + "...': found a name of 101 characters, expected at most 100",
            failure("n".repeat(101) + "=builtin:racer"));
    }

    /** Words behind a prefix are the program: found by the fuzz, whose command was refused when written anew. */
    @Test
    void aProgramBehindAPrefixMayLookLikeAName() {
        BotCommand command = BotCommand.parse("json:name=codingame:x");
        assertEquals(List.of("name=codingame:x"), command.words());
        assertEquals(command.words(), BotCommand.parse(command.toString()).words());
    }

    /** Found by the fuzz: a program that is quoted when it is written may look like a name that is none. */
    @Test
    void aProgramThatLooksLikeAWrongNameIsWrittenSoThatItIsReadAgain() {
        BotCommand command = BotCommand.parse(" name=codingame:python} x");
        assertEquals(List.of("name=codingame:python}", "x"), command.words());
        assertEquals(command, BotCommand.parse(command.toString()));
    }
}
