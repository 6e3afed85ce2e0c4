package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.process.BotProcess;
import steward.game.GameSetup;
import steward.match.Protocol;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;

/**
 * Bots that speak CodinGame's lines and misbehave in the third turn, what it makes of their match, and whether its
 * replay verifies. Against the upper league's two pods a turn is 4 lines, and the setup of the map with 3 checkpoints
 * is 5.
 */
@Tag("process")
@Timeout(40)
class MisbehavingBotsTest {

    private static final long MS = 1_000_000;
    /** Time enough for a shell on a loaded machine, and little enough for a test that waits for it to pass. */
    private static final TimeControl SHORT = new TimeControl(5_000 * MS, 300 * MS);
    private static final String READ = "read a; read b; read c; read d; ";
    private static final String GOOD = "printf '9000 4000 50 hi\\n9000 5000 50\\n'; ";
    private static final String SETUP = "read a; read b; read a; read b; read c; ";
    /** Two turns as they should be; then the third is read. */
    private static final String BEFORE = SETUP + READ + GOOD + READ + GOOD + READ;
    private static final String HALF = "no answer within 300 ms \\(waited \\d+ ms\\): 1 of 2 lines came; .*";
    private static final String REST = "while " + READ + "[ -n \"$d\" ]; do " + GOOD + "done";

    /** The official scene on a map of ours with three checkpoints. */
    private static final GameSetup SCENE = TestScenes.changed("mad-pod-racing", "\"maps\": \"official\"",
        "\"maps\": [ { \"checkpoints\": [ { \"x\": 3000, \"y\": 4500 }, { \"x\": 9000, \"y\": 4500 },"
        + " { \"x\": 9000, \"y\": 8000 } ] } ]");

    @BeforeEach
    void shell() {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "skipped: there is no /bin/sh");
    }

    private static Seat bot(String script) {
        return new Seat(new BotProcess("bad", List.of("/bin/sh", "-c", script)), Protocol.CODINGAME);
    }

    /** Shell text of a bot's third turn, and the fault that it leads to. */
    static Stream<Arguments> faults() {
        return Stream.of(
            Arguments.of("kill -SEGV $$; sleep 60", TimeControl.UNLIMITED,
                "killed by signal 11 \\(SIGSEGV\\) before answering"),
            Arguments.of("echo 9000 4000 50; sleep 60", SHORT, HALF),
            Arguments.of("printf '9000 4000 50\\n9000 40'; sleep 60", SHORT, HALF),
            Arguments.of("echo 9000 4000 50; exit 3", TimeControl.UNLIMITED, "exited with status 3 before answering"),
            Arguments.of("printf '9000 4000 50\\nno idea\\n'; sleep 60", TimeControl.UNLIMITED,
                "line 2 of 2: X: found \"no\", expected a finite number; received: 9000 4000 50\\\\nno idea"),
            Arguments.of("exec >&-; sleep 60", TimeControl.UNLIMITED, "closed its output before answering"),
            Arguments.of("head -c 1000000 /dev/zero | tr '\\0' 7; echo; sleep 60", TimeControl.UNLIMITED,
                "line longer than 65536 bytes"));
    }

    /** The bot fails in the third turn, the other one wins; the replay keeps the fault and verifies. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("faults")
    void whoFailsInTheThirdTurnLoses(String script, TimeControl time, String fault) {
        TextMatches match = TextMatches.play(SCENE, 1, time, bot(BEFORE + script), TextMatches.racer());
        assertEquals(3, match.result().turns(), match.player(0).fault());
        assertTrue(match.player(0).fault().matches(fault), match.player(0).fault());
        assertNull(match.player(1).fault());
        assertEquals(1, match.result().winner());
        assertNull(match.verify().difference());
        assertEquals(3, match.verify().turns());
        assertTrue(match.replayText().contains("\"messages\":[\"hi\",null]"), "the turns before are there");
    }

    /** Lines that are not asked for stay in the pipe and serve as the next answers, as on the real server. */
    @Test
    void aMegabyteOfLinesInOneTurn() {
        String lines = "yes '9000 4500 100 more' | head -n 50000; ";
        TextMatches match = TextMatches.play(SCENE, 1, TimeControl.UNLIMITED, bot(BEFORE + lines + "sleep 60"),
            TextMatches.racer());
        assertNull(match.player(0).fault());
        assertTrue(match.result().turns() > 100, () -> match.result().toString());
        assertTrue(match.player(0).earlyTurns() > match.result().turns() - 10, () -> match.result().toString());
        assertTrue(match.replayText().contains("\"messages\":[\"more | more\",null]"));
        assertTrue(match.replayText().contains("\"earlyTurns\":[" + match.player(0).earlyTurns() + ","));
        assertNull(match.verify().difference());
    }

    /** The whole second answer comes with the first, before the bot has read a turn. */
    @Test
    void answersBeforeItIsAsked() {
        String early = SETUP + "printf '1 1 5 a\\n1 1 5\\n2 2 6 b\\n2 2 6\\n'; " + READ + READ + REST;
        TextMatches match = TextMatches.play(SCENE, 1, TimeControl.UNLIMITED, bot(early), TextMatches.racer());
        assertNull(match.player(0).fault());
        assertTrue(match.player(0).earlyTurns() >= 1, () -> match.result().toString());
        List<String> replay = match.replayText().lines().toList();
        assertTrue(replay.get(1).contains("{\"x\":1,\"y\":1,\"thrust\":5}"), replay.get(1));
        assertTrue(replay.get(1).contains("\"messages\":[\"a\",null]"), replay.get(1));
        assertTrue(replay.get(2).contains("{\"x\":2,\"y\":2,\"thrust\":6}"), replay.get(2));
        assertTrue(replay.get(2).contains("\"messages\":[\"b\",null]"), replay.get(2));
        assertTrue(replay.get(3).contains("\"messages\":[\"hi\",null]"), replay.get(3));
        assertNull(match.verify().difference());
    }

    /** Answers from memory and reads nothing: the pipe takes 64 KiB, then our write blocks until the deadline. */
    @Test
    void neverReadsWhileWeSend() {
        GameSetup patient = TestScenes.changed("mad-pod-racing", "\"turnsWithoutCheckpoint\": 100",
            "\"turnsWithoutCheckpoint\": 5000");
        GameSetup endless = TestScenes.TYPES.open(patient.scene().json()
            .replace("\"maximumTurns\":500", "\"maximumTurns\":5000"), "endless");
        String deaf = "yes '9000 4500 10' | head -n 20000; sleep 60";
        Seat idle = TextMatches.lines("idle", lines -> "1 1 0\n1 1 0");
        TextMatches match = TextMatches.play(endless, 1, SHORT, bot(deaf), idle);
        assertTrue(match.player(0).fault().matches("did not read its input within 300 ms \\(waited \\d+ ms\\): .*"),
            match.player(0).fault());
        // A turn's 4 lines have some 80 bytes: 64 KiB last for 600 to 1000 of them.
        assertTrue(match.result().turns() > 500 && match.result().turns() < 1500, match.result().toString());
        assertEquals(1, match.result().winner());
        assertNull(match.verify().difference());
    }
}
