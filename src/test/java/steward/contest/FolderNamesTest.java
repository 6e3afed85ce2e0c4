package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.match.Protocol;
import steward.match.TestScenes;

/** Names of bots that are told apart by their folders; each alone is named as by 'check' and 'league add'. */
class FolderNamesTest {

    @TempDir
    private Path folder;

    private List<String> names(String... bots) throws IOException {
        return names(Collections.nCopies(bots.length, folder), bots);
    }

    private List<String> names(List<Path> folders, String... bots) throws IOException {
        for (String file : List.of("v1/bot.py", "v2/bot.py", "a/src/main.js", "b/src/main.js", "v 3/bot.py", "bot",
            "venv/bin/python", "venv/bin/python3.11")) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.writeString(folder.resolve(file), "");
            folder.resolve(file).toFile().setExecutable(true);
        }
        List<String> all = new ArrayList<>(List.of(bots));
        Contest contest = Contest.ofSeries(TestScenes.duel(all.size()), all, folders, Protocol.JSON, 1);
        return contest.entrants().stream().map(Contest.Entrant::name).toList();
    }

    @Test
    void theNearestFoldersThatDifferAreNamed() throws IOException {
        assertEquals(List.of("v1-bot.py", "v2-bot.py"), names("sh v1/bot.py", "sh v2/bot.py"));
        assertEquals(List.of("v1-bot.py", "v2-bot.py"), names("./v1/bot.py", "sh v2/bot.py"));
        assertEquals(List.of("a-main.js", "b-main.js"), names("sh a/src/main.js", "sh b/src/main.js"));
        assertEquals(List.of("v1-bot.py", "v-3-bot.py"), names("sh v1/bot.py", "sh 'v 3/bot.py'"));
        assertEquals(List.of("v1-bot.py", "v2-bot.py"), names(List.of(folder.resolve("v1"), folder.resolve("v2")),
            "sh bot.py", "sh bot.py"));
    }

    @Test
    void oneProgramTwiceHasNumbers() throws IOException {
        assertEquals(List.of("bot-0", "bot-1"), names("./bot 1", "./bot 2"));
        assertEquals(List.of("x-0", "x-1"), names("x=sh v1/bot.py", "x=sh v2/bot.py"));
        assertEquals(List.of("racer-0", "racer-1"), names("builtin:racer", "builtin:racer"));
    }

    @Test
    void anInterpreterIsNoName() throws IOException {
        assertEquals(List.of("v1-bot.py", "v2-bot.py"), names("venv/bin/python v1/bot.py",
            folder + "/venv/bin/python3.11 -u v2/bot.py"));
        assertEquals("bot.py", Contest.entrant("venv/bin/python -u v1/bot.py", folder, null, Protocol.JSON).name());
        assertEquals("bot", Contest.entrant("./bot v1/bot.py", folder, null, Protocol.JSON).name());
    }
}
