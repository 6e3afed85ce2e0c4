package steward.machines.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.game.Pilot;
import steward.game.pokerchiprace.PokerChipRace;
import steward.guest.StandInProject;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.match.Protocol;
import steward.replay.ReplayReader;
import steward.replay.verify.Verification;

/** A game that is sent without what follows from its commands is the same game behind the wire. */
@Execution(ExecutionMode.CONCURRENT)
class TranscriptTest {

    private static final long SEED = 11;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race", "search-race", "mean-max", "fantastic-bits",
        "poker-chip-race"})
    @Tag("slow")
    void theReplayOfEveryGameComesBackByteForByte(String scene) throws Exception {
        for (Pilot.Aim aim : Pilot.Aim.values()) {
            PlayedGame game = PlayedGame.of(PlayedGame.piloted(scene, aim), SEED);
            assertArrayEquals(game.replay(), new TranscriptCheck(game.contest()).replay("a game", game.transcript(),
                game.expected()), scene + " " + aim);
            assertTrue(game.transcript().length * 2 < GzipText.compressed(game.replay()).length,
                () -> "found " + game.transcript().length + " bytes");
            compare(game);
        }
    }

    private static void compare(PlayedGame game) throws DisprovedException {
        CheckedGame found = game.check();
        assertEquals(game.facts(), found.facts(), "as the log of the game told it");
        assertEquals(game.result().turns(), found.turns());
        for (int player = 0; player < found.seats().size(); player++) {
            MatchResult.PlayerResult result = game.result().players().get(player);
            CheckedGame.Seat seat = found.seats().get(player);
            assertEquals(result.rank(), seat.rank());
            assertEquals(result.score(), seat.score());
            assertEquals(result.fault(), seat.fault());
            assertEquals(result.answers(), seat.answers());
            assertEquals(result.averageNanos(), seat.meanNanos());
            assertEquals(result.worstNanos(), seat.worstNanos());
            assertEquals(result.firstNanos(), seat.firstNanos());
        }
    }

    /** The scene "duel" draws nothing from the seed; the maps of "walled-race" are drawn from it. */
    @Test
    void equalGamesHaveEqualDigestsWhateverTheirSeeds() throws Exception {
        long one = PlayedGame.of(PlayedGame.piloted("duel", Pilot.Aim.WIN), 1).facts().transcript();
        assertEquals(one, PlayedGame.of(PlayedGame.piloted("duel", Pilot.Aim.WIN), 2).facts().transcript());
        assertNotEquals(one, PlayedGame.of(PlayedGame.piloted("duel", Pilot.Aim.GATHER), 1).facts().transcript());
        assertNotEquals(PlayedGame.of(PlayedGame.piloted("walled-race", Pilot.Aim.WIN), 1).facts().transcript(),
            PlayedGame.of(PlayedGame.piloted("walled-race", Pilot.Aim.WIN), 2).facts().transcript());
    }

    @ParameterizedTest
    @CsvSource({"mad-pod-racing, laps", "mean-max, water", "fantastic-bits, goals", "poker-chip-race, chips"})
    void theOwnValuesOfAGameHaveNames(String scene, String name) throws Exception {
        PlayedGame game = PlayedGame.of(PlayedGame.piloted(scene, Pilot.Aim.WIN), SEED);
        for (int player = 0; player < game.facts().values().size(); player++) {
            assertEquals(Set.of(name), game.facts().values(player).keySet());
        }
    }

    private PlayedGame talkative() throws Exception {
        ShellBots.shortDuel(folder, 6);
        TextShellBots bots = new TextShellBots(folder);
        return PlayedGame.of(Contest.of(Games.open(folder.resolve("short.json").toString()), List.of("one=codingame:"
            + bots.driver(), "two=codingame:" + bots.idler(3)), Protocol.JSON, 1).isolatedBy(() -> Isolation.OFF), 3);
    }

    @Test
    @Tag("process")
    void faultsAndWhatBotsWriteAndReportComeBackToo() throws Exception {
        PlayedGame game = talkative();
        String replay = new String(game.replay(), StandardCharsets.UTF_8);
        for (String field : List.of("faults", "stderr", "data")) {
            assertTrue(replay.contains('"' + field + '"'), replay);
        }
        assertEquals(replay, new String(new TranscriptCheck(game.contest()).replay("a game", game.transcript(),
            game.expected()), StandardCharsets.UTF_8));
        compare(game);
        assertTrue(game.check().seats().get(1).fault() != null);
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(game.replay()), "replay")) {
            assertTrue(Verification.of(reader, Games.types()).verified());
        }
    }

    /** The first player fails at once; workers before asked the second one all the same, and sent what it said. */
    @Test
    void whoWasNotAskedAfterTheDecidingFaultHasNoTime() throws Exception {
        PlayedGame game = PlayedGame.of(PlayedGame.piloted("poker-chip-race", Pilot.Aim.WIN).startedBy(
            (entrant, isolation, others) -> new InProcessPlayer(entrant.name(), TestBots.answering(line -> ""))), SEED);
        assertEquals(List.of(1, 0), game.check().seats().stream().map(CheckedGame.Seat::answers).toList());
        assertArrayEquals(game.replay(), new TranscriptCheck(game.contest()).replay("a game", game.transcript(),
            game.expected()));
        compare(game);
        String sent = new String(GzipText.bytes(game.transcript()), StandardCharsets.UTF_8);
        assertTrue(sent.contains("[null,null],\"faults\":[\""), sent);
        int own = ((PokerChipRace) game.contest().setup().create(SEED)).table().owned(1);
        String said = "[" + String.join(",", Collections.nCopies(own, "{\"wait\":true}")) + "]";
        byte[] older = GzipText.compressed(sent.replace("[null,null],\"faults\"", "[null," + said + "],\"faults\"")
            .replaceFirst("(\"answerNanos\":\\[[0-9]+)", "$1,5").getBytes(StandardCharsets.UTF_8));
        assertEquals(List.of(1, 1), new TranscriptCheck(game.contest()).check("a game", older, game.expected()).seats()
            .stream().map(CheckedGame.Seat::answers).toList());
    }

    @Test
    @Tag("process")
    void aMissedDeadlineIsBelievedWhereTheMeasuredTimeAllowsIt() throws Exception {
        PlayedGame game = PlayedGame.of(Contest.of(Games.open("duel"), List.of("one=codingame:sleep 5",
            "two=codingame:sleep 5"), Protocol.JSON, 0.1).isolatedBy(() -> Isolation.OFF), 3);
        CheckedGame outcome = game.check();
        assertTrue(outcome.seats().get(0).fault().startsWith("no answer within 100 ms"), outcome::toString);
        assertTrue(outcome.nanos() >= 100_000_000, outcome::toString);
        assertTrue(game.disproof("\"answerNanos\":[", "\"answerNanos\":[99999999,").contains("faults[0]: found 'no "
            + "answer within 100 ms (waited "), "an earlier time");
    }

    @Test
    @Tag("process")
    void aBotsOwnLimitDecidesWhatIsBelievedAndStandsInTheReplay() throws Exception {
        PlayedGame game = PlayedGame.of(Contest.of(Games.open("duel"), List.of("one=codingame:sleep 5",
            "two=codingame:sleep 5"), Protocol.JSON, 0.5).isolatedBy(() -> Isolation.OFF)
            .limitedBy(Map.of("one", new OwnLimits(60, 80), "two", new OwnLimits(90, 0))), 3);
        CheckedGame outcome = game.check();
        assertTrue(outcome.seats().get(0).fault().startsWith("no answer within 40 ms"), outcome::toString);
        assertTrue(game.disproof("\"answerNanos\":[", "\"answerNanos\":[39999999,").contains("after 39999 us, expected "
            + "a late answer only after 40000 us"), "an earlier time");
        String replay = new String(new TranscriptCheck(game.contest()).replay("a game", game.transcript(),
            game.expected()), StandardCharsets.UTF_8);
        String players = "\"time\":{\"firstAnswerMs\":80,\"answerMs\":60}},{\"name\":\"two\","
            + "\"bot\":\"two=codingame:sleep 5\",\"protocol\":\"codingame\","
            + "\"time\":{\"firstAnswerMs\":1000,\"answerMs\":90}}],\"timeFactor\":0.5";
        assertTrue(replay.contains(players), replay);
        assertTrue(new String(game.replay(), StandardCharsets.UTF_8).contains(players), "where it was played");
    }

    /** The limit is that of each question, and a referee that plays a transcript again does not stay. */
    @Test
    @Tag("process")
    void aGuestsDeadlinesAreThoseOfItsQuestionsAndItsRefereeEnds(@TempDir Path folder) throws Exception {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        Path referee = Files.copy(Path.of("src/test/resources/referees/standin.py"), folder.resolve("standin.py"));
        String bot = StandInProject.bot(folder, "one", "1");
        PlayedGame game = PlayedGame.of(Contest.of(Games.open(Files.writeString(folder.resolve("s.json"), """
            {"name": "s", "game": "guest", "players": 2, "referee": {"command": ["python3", "%s", "good"]}}"""
            .formatted(referee)).toString()), List.of(bot, "two=codingame:sleep 5"), Protocol.JSON, 0.1)
            .isolatedBy(() -> Isolation.OFF), 3);
        PlayedGame own = PlayedGame.of(game.contest().limitedBy(Map.of("two", new OwnLimits(9, 2000))), 3);
        assertTrue(own.check().seats().get(1).fault().startsWith("no answer within 200 ms"), "its own comes first");
        CheckedGame outcome = game.check();
        assertTrue(outcome.seats().get(1).fault().startsWith("no answer within 300 ms"), outcome::toString);
        assertEquals(10, outcome.seats().get(0).score());
        assertTrue(game.disproof("\"answerNanos\":[", "\"answerNanos\":[1000000,1000000,").contains("faults[1]: found "
            + "'no answer within 300 ms (waited "), "an earlier time");
        assertTrue(game.disproof("\n[", "\n[{},").contains("cannot be played again: turn "));
        List<ProcessHandle> left = ProcessHandle.allProcesses().filter(process -> process.info().commandLine()
            .orElse("").contains(referee.toString())).toList();
        for (ProcessHandle process : left) {
            process.onExit().get(10, TimeUnit.SECONDS);
        }
    }

    @Test
    void anotherGameIsDisproved() throws Exception {
        PlayedGame game = PlayedGame.of(PlayedGame.piloted("walled-race", Pilot.Aim.WIN), SEED);
        assertTrue(game.disproof("\"states\":\"", "\"states\":\"0")
            .startsWith("a game: differs when it is played again: found states of the hash 0"));
        assertTrue(game.disproof("\n[", "\n{\"commands\":[").contains("a game:"), "not JSON");
        assertTrue(game.disproof("\n[", "\n[{},").contains("cannot be played again: turn "));
        assertTrue(game.disproof("\n[", "\n[]\n[").contains("cannot be played again: turn "));
        assertTrue(game.disproof("\n{\"states\"", "\n[]\n{\"states\"").contains("goes on after turn "));
        assertTrue(game.disproof("\"averageNanos\":[", "\"averageNanos\":[-1,").contains("expected whole numbers"));
        assertTrue(game.disproof("{\"bots\":[", "{\"bots\":[null,").contains("bots"));
        assertTrue(game.disproof("{\"bots\":[", "{\"more\":1,\"bots\":[").contains("\"more\""));
        String other = assertThrows(DisprovedException.class, () -> new TranscriptCheck(game.contest()).check("a game",
            game.transcript(), new ExpectedGame(SEED + 1, game.expected().names(),
                game.expected().protocols(), Map.of()))).getMessage();
        assertTrue(other.startsWith("a game"), other);
        byte[] sent = GzipText.bytes(game.transcript());
        for (int length = 0; length < sent.length; length += 1 + sent.length / 50) {
            byte[] part = GzipText.compressed(Arrays.copyOf(sent, length));
            assertThrows(DisprovedException.class,
                () -> new TranscriptCheck(game.contest()).check("a game", part, game.expected()));
        }
    }

    /** The time that a fault takes once grew with the square of its length, and it is stored with the game. */
    @Test
    @Tag("process")
    void aFaultWithoutEndIsDisproved() throws Exception {
        assertTrue(talkative().disproof("\"faults\":[null,\"", "\"faults\":[null,\"" + " (waited ".repeat(40_000))
            .contains("faults[1]: found 36"));
    }

    /** A worker may send anything: it is refused with a message, or is a game in which all follows from commands. */
    @Test
    void brokenBytesAreRefusedWithAMessage() throws Exception {
        BrokenTranscripts transcripts = new BrokenTranscripts();
        assertFalse(transcripts.check(transcripts.sent(), false), "the original is refused");
        SplittableRandom random = new SplittableRandom(SEED);
        int refused = 0;
        for (int k = 0; k < 300; k++) {
            byte[] broken = transcripts.sent().clone();
            for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
                broken[random.nextInt(broken.length)] =
                    (byte) "{}[],:\"0123456789-.e\\ntrue".charAt(random.nextInt(25));
            }
            refused += transcripts.check(broken, k % 10 == 0) ? 1 : 0;
        }
        assertTrue(refused > 200, "found " + refused);
    }
}
