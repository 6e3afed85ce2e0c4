package steward.bot.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The files that make a program what it is, in each language. */
class ProgramTest {

    @TempDir
    private Path folder;

    @BeforeEach
    void makeFiles() throws IOException {
        for (String file : List.of("bot", "bot.py", "bot.js", "bot.jar", "lib.jar", "weights.txt", "run.log", "seen.db",
            "Bot.class", "Bot$Pod.class", "Pod.class", "Bot.java", "notes.txt", "classes/Bot.class",
            "classes/org/me/Main.class", "classes/org/me/search/Tree.class", "classes/org/other/Away.class",
            "v1/w.py", "it's a/bot.py")) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.writeString(folder.resolve(file), file);
        }
    }

    private String files(String command) {
        return String.join(" ", new Program(CommandLine.split(command), folder, null).files().stream()
            .map(Path::toString).toList());
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '"', value = {
        "python3 bot.py, bot.py",
        "python3 -u v1/w.py weights.txt --depth 3, v1/w.py weights.txt",
        "node bot.js, bot.js",
        "./bot, ./bot",
        "./bot weights.txt --log notes.txt run.log --trace-out seen.db, ./bot weights.txt",
        "env OMP_NUM_THREADS=1 ./bot, ./bot",
        "java -jar bot.jar, bot.jar",
        "java Bot.java, Bot.java",
        "java Bot, Bot$Pod.class Bot.class Pod.class",
        "java -Xmx1g -cp classes Bot weights.txt, weights.txt classes/Bot.class",
        "java -cp lib.jar:classes org.me.Main, lib.jar classes/org/me/Main.class classes/org/me/search/Tree.class "
            + "classes/org/other/Away.class",
        "\"python3 \"\"it's a/bot.py\"\"\", it's a/bot.py",
        "python3 -m bots, \"\"",
        "sh -c 'python3 bot.py', \"\""})
    void theFilesThatACommandNamesMakeItThisProgram(String command, String expected) {
        assertEquals(expected, files(command));
    }

    @Test
    void listedFilesReplaceThose() {
        Program program = new Program(List.of("python3", "bot.py"), folder, List.of("weights.txt", "/etc/passwd"));
        assertEquals(List.of(folder.resolve("weights.txt"), Path.of("/etc/passwd")), program.paths());
    }

    @Test
    void theStampChangesWithEachFileAndWithNoOther() throws IOException {
        Program program = new Program(List.of("java", "Bot"), folder, null);
        String before = program.stamp();
        Files.writeString(folder.resolve("notes.txt"), "new notes");
        assertEquals(before, program.stamp());
        Files.writeString(folder.resolve("Pod.class"), "new class");
        assertNotEquals(before, program.stamp());
    }
}
