package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.contest.Contest.Entrant;
import steward.files.ElfFile;
import steward.game.Game;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TestScenes;

/**
 * Programs that are rebuilt, touched and missing while games are played. It takes long because a change is a version
 * once it has lain still.
 */
@Tag("slow")
@Timeout(120)
@Execution(ExecutionMode.CONCURRENT)
class ProgramWatchTest {

    @TempDir
    private Path folder;
    private final List<String> told = new ArrayList<>();
    private Contest contest;

    /** A program of each kind of file: a script, a binary, classes. */
    @BeforeEach
    void makeBots() throws IOException {
        for (String file : List.of("bot.py", "bot", "Bot.class", "Pod.class", "weights.txt")) {
            Files.writeString(folder.resolve(file), file + " 1");
        }
        folder.resolve("bot").toFile().setExecutable(true);
        contest = Contest.withoutBots(TestScenes.open("duel"), 1).between(List.of(entrant("sh bot.py"),
            entrant("other=./bot weights.txt"), entrant("third=java Bot")));
    }

    private Entrant entrant(String bot) {
        Entrant entrant = Contest.entrant(bot, folder, null, Protocol.JSON);
        assertEquals(null, entrant.problem());
        return entrant;
    }

    private ProgramWatch watch() {
        return ProgramWatch.of(contest, told::add);
    }

    @Test
    void whatIsTouchedOrMadeAnewAlikeIsTheSameProgram() throws Exception {
        ProgramWatch watch = watch();
        String mark = watch.mark();
        for (String file : List.of("bot.py", "bot", "Bot.class", "weights.txt")) {
            Path copy = Files.copy(folder.resolve(file), folder.resolve("copy"), StandardCopyOption.COPY_ATTRIBUTES);
            Files.move(copy, folder.resolve(file), StandardCopyOption.REPLACE_EXISTING);
        }
        assertFalse(watch.isSince(mark), "a game that was under way does not count");
        assertTrue(watch.await(() -> false));
        assertEquals(null, watch.changed());
        assertTrue(watch.isSince(watch.mark()));
    }

    @Test
    void anotherContentIsAnotherProgramWhoseFileIsNamed() throws Exception {
        for (String file : List.of("bot.py", "Pod.class")) {
            ProgramWatch watch = watch();
            Files.writeString(folder.resolve(file), "made anew");
            assertFalse(watch.await(() -> false));
            assertEquals(folder.resolve(file).toString(), watch.changed());
            assertFalse(watch.await(() -> false), "and stays so");
        }
    }

    @Test
    void whatIsMissingOrCannotBeStartedIsWaitedFor() throws Exception {
        ProgramWatch watch = watch();
        for (String file : List.of("weights.txt", "bot")) {
            byte[] content = Files.readAllBytes(folder.resolve(file));
            Files.delete(folder.resolve(file));
            awaitWord("there is no file " + folder.resolve(file) + "; it is waited for", watch);
            Files.write(folder.resolve(file), content);
        }
        awaitWord("is not executable", watch);
        assertTrue(folder.resolve("bot").toFile().setExecutable(true));
        assertTrue(watch.await(() -> false));
        assertEquals(3, told.size(), told.toString());
    }

    private void awaitWord(String word, ProgramWatch watch) throws InterruptedException {
        while (told.stream().noneMatch(line -> line.contains(word))) {
            assertEquals(ProgramWatch.State.WAITING, watch.look());
            Thread.sleep(10);
        }
    }

    @Test
    void whatIsStillBeingWrittenIsNoProgram() throws Exception {
        ProgramWatch watch = watch();
        for (int k = 0; k < 20; k++) {
            Files.writeString(folder.resolve("bot"), "part " + k);
            assertEquals(ProgramWatch.State.WAITING, watch.look());
            Thread.sleep(10);
        }
        assertEquals(null, watch.changed());
    }

    /** Game 3 is under way when the program is made anew: two count, in each way to play many games. */
    /** A binary of the system, cut anywhere: it lies still, and is no program until it is whole. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aBinaryThatIsCutOffIsNoProgramHoweverStillItLies() throws Exception {
        byte[] whole = Files.readAllBytes(Path.of("/bin/sh").toRealPath());
        assertFalse(ElfFile.isCutOff(Path.of("/bin/sh")));
        Path bot = folder.resolve("bot");
        for (int length : new int[] {4, 63, 64, 200, whole.length / 2}) {
            Files.write(bot, Arrays.copyOf(whole, length));
            assertTrue(ElfFile.isCutOff(bot), length + " bytes");
        }
        Files.writeString(bot, "bot 1");
        ProgramWatch watch = watch();
        Files.write(bot, Arrays.copyOf(whole, whole.length / 2));
        awaitWord("bot 'other': " + bot + " is cut off", watch);
        Files.write(bot, whole);
        assertFalse(watch.await(() -> false));
        assertEquals(bot.toString(), watch.changed());
    }

    @Test
    void aSeriesEndsWithTheGamesOfOneProgram() throws Exception {
        Contest two = contest.between(contest.entrants().subList(0, 2));
        int[] begun = new int[1];
        SeriesPlay series = new SeriesPlay(new Series(two, 1, 5, false, null, KeptReplays.NONE), false,
            (match, seed, rotation, recording, follower) -> result(match, follower, ++begun[0] == 3));
        series.play(1, () -> { });
        assertEquals(2, series.standings().games().size());
        assertEquals(folder.resolve("weights.txt").toString(), series.changed());
    }

    @Test
    void aGameDuringWhichAFileWasTouchedIsPlayedAnew() throws Exception {
        Contest two = contest.between(contest.entrants().subList(0, 2));
        List<Long> seeds = new ArrayList<>();
        SeriesPlay series = new SeriesPlay(new Series(two, 1, 3, false, null, KeptReplays.NONE), false,
            (match, seed, rotation, recording, follower) -> {
                seeds.add(seed);
                if (seeds.size() == 2) {
                    assertTrue(folder.resolve("bot.py").toFile().setLastModified(1_000_000));
                }
                return result(match, follower, false);
            });
        series.play(1, () -> { });
        assertEquals(List.of(1L, 2L, 2L, 3L), seeds);
        assertEquals(3, series.standings().games().size());
        assertEquals(null, series.changed());
    }

    private MatchResult result(Contest match, MatchListener follower, boolean changes) {
        Game game = match.setup().create(1);
        follower.start(game, match.setup().codec(game));
        try {
            if (changes) {
                Files.writeString(folder.resolve("weights.txt"), "other");
            }
        } catch (IOException problem) {
            throw new IllegalStateException(problem);
        }
        return new MatchResult(1, "over", List.of(new MatchResult.PlayerResult("a", 0, 1, null, null, 1, 1, 1, 1, 0),
            new MatchResult.PlayerResult("b", 1, 0, null, null, 1, 1, 1, 1, 0)));
    }
}
