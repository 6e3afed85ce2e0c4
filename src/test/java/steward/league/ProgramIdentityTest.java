package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.ShellBots;
import steward.contest.Contest;
import steward.match.Protocol;

/** The identity of a program: of its files and words, not of how a call names them. */
class ProgramIdentityTest {

    @TempDir
    private Path folder;

    private String identity(String bot) {
        return BotIdentity.ofProgram(Contest.entrant(bot, folder, null, Protocol.JSON));
    }

    @Test
    void aProgramHasOneIdentityUnderEverySpelling() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Path script = Files.writeString(folder.resolve("bot.sh"), "cat\n");
        Files.writeString(folder.resolve("copy.sh"), "cat\n");
        Files.writeString(folder.resolve("other.sh"), "cat -u\n");
        Files.createSymbolicLink(folder.resolve("link.sh"), script);
        String one = identity("sh bot.sh 3");
        for (String same : List.of("mine=sh bot.sh 3", "sh ./bot.sh 3", "/bin/sh bot.sh  3", "codingame:sh link.sh 3",
                "sh '" + script + "' 3", "sh copy.sh 3")) {
            assertEquals(one, identity(same), same);
        }
        for (String other : List.of("sh bot.sh 4", "sh other.sh 3", "sh bot.sh", "sh -c 'cat 3'", "builtin:racer")) {
            assertNotEquals(one, identity(other), other);
        }
        assertEquals(identity("sh -c 'cat'"), identity("/bin/sh -c cat"));
        assertNotEquals(identity("builtin:racer"), identity("builtin:regular"));
        assertEquals(identity("builtin:racer"), identity("mine=builtin:racer"));
    }

    /** A tournament lists every file that was handed in. */
    @Test
    void filesThatAreListedBesideThoseOfTheWordsDoNotMatter() throws IOException {
        Files.writeString(folder.resolve("bot.sh"), "cat\n");
        Files.writeString(folder.resolve("run"), "sh bot.sh\n");
        assertEquals(identity("sh bot.sh"), BotIdentity.ofProgram(Contest.entrant("sh bot.sh", folder,
            List.of("bot.sh", "run"), Protocol.JSON)));
    }
}
