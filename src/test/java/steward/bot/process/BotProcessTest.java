package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.reflect.Field;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.command.ProgramFinder;

/** Bots that do as they should: what they are sent, and what comes back. */
@Tag("process")
class BotProcessTest {

    private static final String ECHO = "while read -r line; do echo \"got $line\"; done";

    @BeforeEach
    void shell() {
        ScriptedBots.assumeShell();
    }

    @Test
    void anEchoBotAnswersEveryTurn() {
        try (BotProcess bot = ScriptedBots.bot(ECHO)) {
            assertEquals("bot", bot.name());
            for (int turn = 0; turn < 100; turn++) {
                Answer answer = ScriptedBots.answer(bot, "turn " + turn + "\n", 1);
                assertEquals("got turn " + turn, answer.text());
                assertEquals(0, answer.extraLines());
                assertNull(answer.stderr());
                assertTrue(answer.nanos() > 0);
            }
        }
    }

    @Test
    void anAnswerWithinItsLimitIsAnAnswer() {
        try (BotProcess bot = ScriptedBots.bot(ECHO)) {
            for (int turn = 0; turn < 20; turn++) {
                Answer answer = new Answer();
                assertEquals(Player.Ending.ANSWERED, ScriptedBots.ask(bot, "x\n", 1, 60_000_000_000L, answer));
                assertEquals("got x", answer.text());
            }
        }
    }

    @Test
    void whatItIsToldArrivesBeforeTheTurn() {
        try (BotProcess bot = ScriptedBots.bot("read -r a; read -r b; read -r c; echo \"$a,$b,$c\"; " + ECHO)) {
            ScriptedBots.tell(bot, "setup one\n");
            ScriptedBots.tell(bot, "setup " + "two".repeat(200) + "\n");
            assertEquals("setup one,setup " + "two".repeat(200) + ",turn", ScriptedBots.reply(bot, "turn\n"));
            assertEquals("got next", ScriptedBots.reply(bot, "next\n"));
        }
    }

    @Test
    void theEndLineArrivesAndTheBotMayUseItsGrace() {
        ScriptedBots.assumeGroups();
        String script = "read -r a; echo $$; read -r end; [ \"$end\" = over ] && exec sleep 0.01; exec sleep 1000";
        BotProcess bot = new BotProcess("bot", List.of("sh", "-c", script), 60_000);
        long pid = Long.parseLong(ScriptedBots.reply(bot, "x\n"));
        long before = System.nanoTime();
        ScriptedBots.finish(bot, "over\n");
        assertTrue(System.nanoTime() - before < 60_000_000_000L, "it was not told to end");
        ScriptedBots.assertGone(pid);
        ScriptedBots.finish(bot, "over\n");
    }

    /** More than a pipe holds: it is killed without having been told all of it. */
    @Test
    void theEndOfABotThatDoesNotListen() {
        ScriptedBots.assumeGroups();
        BotProcess bot = ScriptedBots.bot("read -r a; echo $$; exec sleep 1000");
        long pid = Long.parseLong(ScriptedBots.reply(bot, "x\n"));
        ScriptedBots.finish(bot, "x".repeat(1 << 20) + "\n");
        ScriptedBots.assertGone(pid);
    }

    /** Whatever goes wrong while it is told the end: nothing is thrown, and it is killed. */
    @Test
    void theEndCannotBeSaid() throws ReflectiveOperationException {
        ScriptedBots.assumeGroups();
        BotProcess bot = ScriptedBots.bot("read -r a; echo $$; exec sleep 1000");
        long pid = Long.parseLong(ScriptedBots.reply(bot, "x\n"));
        Field input = BotProcess.class.getDeclaredField("input");
        input.setAccessible(true);
        input.set(bot, new OutputStream() {
            @Override
            public void write(int one) {
                throw new OutOfMemoryError("no room to write");
            }
        });
        ScriptedBots.finish(bot, "end\n");
        ScriptedBots.assertGone(pid);
    }

    @Test
    void spareThreadsKeepNoJvmAlive() throws InterruptedException {
        BlockingQueue<Thread> threads = new LinkedBlockingQueue<>();
        DaemonThreadPool.run(() -> threads.add(Thread.currentThread()));
        assertTrue(threads.take().isDaemon());
    }

    /**
     * The first of two bots exits only after the second was sent the end: all are sent the end before any is awaited.
     */
    @Test
    void severalBotsGoAtTheSameTime(@TempDir Path folder) throws IOException {
        ScriptedBots.assumeGroups();
        Path heard = folder.resolve("heard");
        String script = "read -r a; echo ok; read -r end; until [ -s '" + heard + "' ]; do sleep 0.01; done;"
            + " echo bye >&2";
        BotProcess one = new BotProcess("one", List.of("sh", "-c", script), 60_000);
        BotProcess other = new BotProcess("other", List.of("sh", "-c",
            "read -r a; echo ok; read -r end; echo \"$end\" > '" + heard + "'"), 60_000);
        ScriptedBots.reply(one, "x\n");
        ScriptedBots.reply(other, "x\n");
        byte[] end = "over\n".getBytes(StandardCharsets.UTF_8);
        one.sendLastLines(end, end.length);
        other.sendLastLines(end, end.length);
        end[0] = '?';                                  // it was copied
        one.finish(end, end.length);
        other.finish(end, end.length);

        assertEquals("bye\n", one.finalStderr());
        assertEquals("over\n", Files.readString(heard));
    }

    /** Frames and the answers to them, of so many lines. */
    static Stream<Arguments> conversations() {
        String x = "x".repeat(65535);
        String text = "{\"\u00e9\":\"\u4e16\ud83d\ude80\"}";
        return Stream.of(
            arguments("several lines", "while read -r l; do echo \"$l 1\"; echo \"$l 2\"; done",
                List.of("a\n", "a 1\na 2", "b\n", "b 1\nb 2")),
            arguments("carriage returns at line ends are not part of the answer",
                "read -r l; printf 'one\\r\\nt\\rwo\\r\\r\\n\\r\\n'", List.of("a\n", "one\nt\rwo\r\n")),
            arguments("answers before the questions", "exec <&-; printf 'one\\ntwo\\n'; exec sleep 1000",
                List.of("a\n", "one", "b\n", "two")),
            arguments("the longest line", ECHO.replace("got ", "x"),
                List.of(x + "\n", "x" + x, x + "\r\n", "x" + x)),
            arguments("bytes as they are", "exec cat", List.of(text + "\n", text)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("conversations")
    void answersAreThoseOfTheBot(String what, String script, List<String> said) {
        try (BotProcess bot = ScriptedBots.bot(script)) {
            for (int k = 0; k < said.size(); k += 2) {
                String expected = said.get(k + 1);
                int lines = expected.split("\n", -1).length;
                assertEquals(expected, ScriptedBots.answer(bot, said.get(k), lines).text());
            }
        }
    }

    @Test
    void furtherLinesAreKeptForTheNextTurnAndCounted() {
        String script = "read -r l; printf 'one\\ntwo\\nthree\\nfo'; read -r l; echo ur; read -r l";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            Answer first = ScriptedBots.answer(bot, "a\n", 1);
            assertEquals("one", first.text());
            assertEquals(2, first.extraLines());
            Answer second = ScriptedBots.answer(bot, "b\n", 2);
            assertEquals("two\nthree", second.text());
            assertEquals(0, second.extraLines());
            assertEquals("four", ScriptedBots.reply(bot, "c\n"));
        }
    }

    /** The process has often exited, and its pipe been put away, before its answer is read. */
    @Test
    void anAnswerBeforeTheExitCountsAndTheExitIsTheNextTurns() {
        for (int round = 0; round < 40; round++) {
            try (BotProcess bot = ScriptedBots.bot("read -r l; echo answer; exit 3")) {
                assertEquals("answer", ScriptedBots.reply(bot, "a\n"));
                assertEquals("exited with status 3 before answering",
                    ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).fault());
            }
        }
    }

    @Test
    void anAnswerLeftInThePipeByAProcessThatHasExitedIsRead() {
        ScriptedBots.assumeGroups();
        String lines = "line ".repeat(60).trim();
        String script = "echo $$; i=0; while [ $i -lt 100 ]; do echo \"$i " + lines + "\"; i=$((i+1)); done; exit 4";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            ScriptedBots.assertGone(Long.parseLong(ScriptedBots.reply(bot, "a\n")));
            for (int turn = 0; turn < 100; turn++) {
                assertEquals(turn + " " + lines, ScriptedBots.reply(bot, "b\n"));
            }
            assertEquals("exited with status 4 before answering",
                ScriptedBots.fault(bot, "c\n", ScriptedBots.FOREVER).fault());
        }
    }

    @Test
    void aMegabyteOfLinesIsAnsweredLineByLine() {
        try (BotProcess bot = ScriptedBots.bot("read -r l; yes 0123456789 | head -n 100000; exec sleep 1000")) {
            for (int turn = 0; turn < 100; turn++) {
                assertEquals("0123456789\n".repeat(999) + "0123456789",
                    ScriptedBots.answer(bot, turn == 0 ? "a\n" : "", 1000).text());
            }
        }
    }

    @Test
    void aBotInPythonAnswers() {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3 on the PATH");
        String script = "import sys\nfor line in sys.stdin:\n  print(line.strip().upper(), flush=True)";
        try (BotProcess bot = new BotProcess("py", List.of("python3", "-c", script))) {
            assertEquals("HELLO", ScriptedBots.reply(bot, "hello\n"));
            assertEquals("AGAIN", ScriptedBots.reply(bot, "again\n"));
        }
    }

    @Test
    void askingAllocatesNothing() {
        assumeTrue(ManagementFactory.getThreadMXBean() instanceof com.sun.management.ThreadMXBean,
            "this JVM does not count allocations");
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        byte[] frame = "x".repeat(300).concat("\n").getBytes(StandardCharsets.US_ASCII);
        Answer answer = new Answer();
        int turns = 2000;
        try (BotProcess bot = ScriptedBots.bot("exec cat")) {
            for (int turn = 0; turn < 100; turn++) {
                bot.ask(frame, frame.length, 1, 60_000_000_000L, answer);
            }
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int turn = 0; turn < turns; turn++) {
                bot.ask(frame, frame.length, 1, 60_000_000_000L, answer);
            }
            long bytes = threads.getCurrentThreadAllocatedBytes() - before;
            assertTrue(bytes < turns, bytes + " bytes in " + turns + " turns");
        }
        assertEquals(300, answer.length());
    }

    @Test
    void aBotThatWasNeverAskedIsNeverStarted() {
        BotProcess bot = new BotProcess("bot", List.of("a bot that is never started"));
        ScriptedBots.tell(bot, "setup\n");
        bot.close();
        bot.close();
        assertEquals("asked again after its end", ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).fault());
    }

    @Test
    void anotherThreadMayBreakItOff() throws InterruptedException {
        ScriptedBots.assumeGroups();
        for (int round = 0; round < 10; round++) {
            BotProcess bot = ScriptedBots.bot("read -r l; echo $$; exec sleep 1000");
            long pid = round % 2 == 0 ? Long.parseLong(ScriptedBots.reply(bot, "a\n")) : -1;
            Thread breaker = new Thread(bot::close);
            breaker.start();
            Answer answer = new Answer();
            Player.Ending ending = ScriptedBots.ask(bot, "b\n", pid < 0 ? 2 : 1, ScriptedBots.FOREVER, answer);
            assertEquals(Player.Ending.FAULT, ending);
            breaker.join();
            if (pid >= 0) {
                ScriptedBots.assertGone(pid);
            } else if (answer.length() > 0) {
                ScriptedBots.assertGone(Long.parseLong(answer.text().trim()));
            }
        }
    }

    @Test
    void argumentsAreChecked() {
        assertThrows(IllegalArgumentException.class, () -> new BotProcess("bot", List.of()));
        assertThrows(IllegalArgumentException.class, () -> new BotProcess("bot", List.of("sh"), -1));
    }
}
