package steward.machines.worker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.match.Protocol;

/** Trials of bots on a worker's machine. */
@Tag("process")
class BotTrialTest {

    /** The referee asks the last player first: player 0 is not asked in the first turn. */
    @Test
    void aBotIsTriedByTheFirstQuestionOfAGuest(@TempDir Path folder) throws Exception {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        Path referee = Files.writeString(folder.resolve("last.py"), Files.readString(
            Path.of("src/test/resources/referees/standin.py")).replace("in range(players):\n        if",
            "in reversed(range(players)):\n        if"));
        Contest contest = Contest.withoutBots(Games.open(Files.writeString(folder.resolve("s.json"), """
            {"name": "s", "game": "guest", "players": 2, "referee": {"command": ["python3", "%s", "good"]}}"""
            .formatted(referee)).toString()), 1).isolatedBy(() -> Isolation.OFF);
        assertEquals("exited with status 3 before answering", BotTrial.problem(contest, bot("read x; exit 3")));
        assertNull(BotTrial.problem(contest, bot("while read x; do echo 1; done")));
    }

    private static Entrant bot(String script) {
        return new Entrant("bot", "sh", Protocol.CODINGAME, List.of("sh", "-c", script));
    }
}
