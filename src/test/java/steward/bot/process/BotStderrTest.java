package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.Answer;
import steward.bot.ErrorLine;
import steward.bot.command.ProgramFinder;

/** Text that a bot writes to its stderr belongs to the turn in which it was written, and never blocks it. */
@Tag("process")
class BotStderrTest {

    @BeforeEach
    void shell() {
        ScriptedBots.assumeShell();
    }

    @Test
    void everyTurnHasItsOwn() {
        String script = "while read -r n; do [ $((n % 3)) = 0 ] || echo \"note $n\" >&2; echo \"$n\"; done";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            for (int turn = 0; turn < 200; turn++) {
                Answer answer = ScriptedBots.answer(bot, turn + "\n", 1);
                assertEquals(String.valueOf(turn), answer.text());
                assertEquals(turn % 3 == 0 ? null : "note " + turn + "\n", answer.stderr());
            }
        }
    }

    /** A bot may be ended by another thread while it starts; the start then makes its file anew. */
    @Test
    void aFileThatAStartMakesAfterTheEndIsRemovedToo() throws IOException {
        StderrFile file = StderrFile.create();
        file.close();
        Files.createFile(file.file().toPath());
        file.unlink();
        assertFalse(file.file().exists());
    }

    @Test
    void tenMegabytesInOneTurnDoNotBlockAndAreBounded() {
        String script = "read -r l; head -c 10000000 /dev/zero | tr '\\0' e >&2; echo 1;"
            + " read -r l; echo two >&2; echo 2";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            assertEquals("e".repeat(16384) + "\n[9983616 more bytes dropped]\n",
                ScriptedBots.answer(bot, "a\n", 1).stderr());
            assertEquals("two\n", ScriptedBots.answer(bot, "b\n", 1).stderr());
        }
    }

    /** Lines with data are kept where others are dropped; one that was cut in two is kept whole, and counts once. */
    @Test
    void dataBeyondTheBoundIsKept() {
        String flood = "head -c 20000 /dev/zero | tr '\\0' e >&2; ";
        String script = "read -r l; " + flood + "echo '[PDATA] no = line' >&2; echo '[PDATA] score = 7' >&2; "
            + flood + "echo >&2; printf '[PDATA+] hits' >&2; echo 1;"
            + " read -r l; echo ' = 3' >&2; head -c 16376 /dev/zero | tr '\\0' e >&2; echo >&2;"
            + " echo '[PDATA+] hits = 12' >&2; echo 2";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            // Not kept: two floods, "[PDATA] no = line" behind the first, and the line end behind the second.
            assertEquals("\n[" + (2 * 20_000 + 18 + 1 - 16384)
                + " more bytes dropped]\n[PDATA] score = 7\n[PDATA+] hits",
                ScriptedBots.answer(bot, "a\n", 1).stderr().replaceFirst("^e{16384}", ""));
            assertEquals(" = 3\n\n[PDATA+] hits = 12\n",
                ScriptedBots.answer(bot, "b\n", 1).stderr().replaceFirst("\ne{16376}\n", "\n\n"));
        }
    }

    @Test
    void aLongFileIsCutAndGoesOn() {
        String script = "while read -r n; do head -c \"$n\" /dev/zero | tr '\\0' e >&2; echo \"$n\"; done";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            assertEquals("e".repeat(16384) + "\n[19983616 more bytes dropped]\n",
                ScriptedBots.answer(bot, "20000000\n", 1).stderr());
            assertEquals("eee", ScriptedBots.answer(bot, "3\n", 1).stderr());
            assertNull(ScriptedBots.answer(bot, "0\n", 1).stderr());
        }
    }

    @Test
    void charactersAreNotTornApart() {
        String script = "read -r l; head -c 16383 /dev/zero | tr '\\0' e >&2; printf '\\303\\251.' >&2; echo 1;"
            + "read -r l; printf '\\344\\270' >&2; echo 2; read -r l; printf '\\226' >&2; echo 3;"
            + "read -r l; printf 'a\\377b' >&2; echo 4; read -r l; printf '\\344' >&2; exit 0";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            assertEquals("e".repeat(16383) + "\n[3 more bytes dropped]\n", ScriptedBots.answer(bot, "a\n", 1).stderr());
            assertNull(ScriptedBots.answer(bot, "b\n", 1).stderr());
            assertEquals("\u4e16", ScriptedBots.answer(bot, "c\n", 1).stderr());
            assertEquals("a\ufffdb", ScriptedBots.answer(bot, "d\n", 1).stderr());
            assertEquals("\ufffd", ScriptedBots.fault(bot, "e\n", ScriptedBots.FOREVER).stderr());
        }
    }

    @Test
    void theLastWordsOfABotThatDiesAreThere() {
        for (int round = 0; round < 20; round++) {
            try (BotProcess bot = ScriptedBots.bot("read -r l; echo 1; read -r l; echo boom >&2; exit 3")) {
                assertNull(ScriptedBots.answer(bot, "a\n", 1).stderr());
                assertEquals("boom\n", ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).stderr());
            }
        }
    }

    /** A bot that talks a lot says in the end why it dies: 12 KiB from the beginning, whole lines of the last 4. */
    @Test
    void theEndOfALongLastMessageIsThere() {
        String script = "read -r l; head -c 50000 /dev/zero | tr '\\0' e >&2; echo >&2; echo '[PDATA] score = 7' >&2;"
            + " head -c 5000 /dev/zero | tr '\\0' f >&2; echo >&2; echo 'ValueError: bad' >&2; exit 1";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            // Dropped: all but 12288 of the 50001 bytes of the first line, and the line of 5001.
            assertEquals("\n[" + (50_001 - 12_288 + 5001)
                + " more bytes dropped]\n[PDATA] score = 7\nValueError: bad\n",
                ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).stderr().replaceFirst("^e{12288}", ""));
        }
        String line = "read -r l; head -c 50000 /dev/zero | tr '\\0' e >&2; printf '\\303\\251' >&2;"
            + " head -c 4095 /dev/zero | tr '\\0' f >&2; exit 1";
        try (BotProcess bot = ScriptedBots.bot(line)) {
            assertEquals("\n[" + (50_000 - 12_288 + 2) + " more bytes dropped]\n" + "f".repeat(4095),
                ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).stderr().replaceFirst("^e{12288}", ""));
        }
    }

    /** Frames of a deep recursion are longer than what is kept of the end. */
    @Test
    void theLineThatSaysWhyIsKeptInTheMiddleOfALongLastMessage() {
        String script = "read -r l; head -c 50000 /dev/zero | tr '\\0' e >&2; echo >&2; echo before >&2;"
            + " echo '[PDATA] score = 7' >&2; echo 'Exception in thread \"main\" Oops: caf\u00e9' >&2;"
            + " n=0; while [ $n -lt 500 ]; do printf '\\tat Bot.f(Bot.java:%s)\\n' $n; n=$((n + 1)); done >&2; exit 1";
        try (BotProcess bot = ScriptedBots.bot(script)) {
            String said = ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER).stderr();
            assertTrue(said.contains(" more bytes dropped]\n[PDATA] score = 7\nbefore\n"
                + "Exception in thread \"main\" Oops: caf\u00e9\n\tat Bot.f(Bot.java:0)\n"), said);
            assertEquals("Exception in thread \"main\" Oops: caf\u00e9", ErrorLine.of(said));
            assertTrue(said.length() < 24 * 1024 && said.endsWith("499)\n"), said);
        }
    }

    @Test
    void theLastWordsOfABotThatIsTooLateAreThere(@TempDir Path folder) {
        Path marker = folder.resolve("marker");
        String script = "read -r l; echo 1; echo thinking >&2; : > \"$0\"; read -r l; exec sleep 1000";
        try (BotProcess bot = new BotProcess("bot", List.of("sh", "-c", script, marker.toString()))) {
            Answer answer = ScriptedBots.answer(bot, "a\n", 1);
            String before = answer.stderr() == null ? "" : answer.stderr();
            ScriptedBots.await("the bot has not written", () -> Files.exists(marker));
            // Written after the answer: seen with the first turn or with the second, but once.
            String after = ScriptedBots.fault(bot, "b\n", 50_000_000).stderr();
            assertEquals("thinking\n", before + (after == null ? "" : after));
        }
    }

    @Test
    void aTracebackIsThere() {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3 on the PATH");
        String script = "import sys\nfor line in sys.stdin:\n  print(1 // (len(line) - 2), flush=True)";
        try (BotProcess bot = new BotProcess("py", List.of("python3", "-c", script))) {
            assertEquals("1", ScriptedBots.reply(bot, "ab\n"));
            Answer answer = ScriptedBots.fault(bot, "a\n", ScriptedBots.FOREVER);
            assertEquals("exited with status 1 before answering", answer.fault());
            assertTrue(answer.stderr().contains("ZeroDivisionError"), answer.stderr());
        }
    }

    @Test
    void aFileThatGrowsWhileTheBotThinksIsCut() throws IOException {
        StderrFile stderr = StderrFile.create();
        try (RandomAccessFile bot = new RandomAccessFile(stderr.file(), "rw")) {
            bot.write("head".getBytes(StandardCharsets.US_ASCII));
            assertEquals("head", stderr.collect(false));
            bot.setLength(StderrFile.CUT_UNREAD);
            stderr.bound();
            assertEquals(StderrFile.CUT_UNREAD, bot.length());
            bot.setLength(StderrFile.CUT_UNREAD + 1);
            stderr.bound();
            assertEquals(0, bot.length());
            bot.seek(0);
            bot.write("tail".getBytes(StandardCharsets.US_ASCII));
            assertEquals("tail\n[" + (StderrFile.CUT_UNREAD + 1 - 4) + " more bytes dropped]\n", stderr.collect(false));
            assertNull(stderr.collect(false));
        } finally {
            stderr.close();
        }
    }

    /** It went on filling a file without a name, unbounded, until somebody found out where the disk had gone. */
    @Test
    void aProcessThatHasLeftTheGroupDoesNotFillTheFileForEver() {
        ScriptedBots.assumeGroups();
        String script = "read -r l; left=$(setsid sh -c '(while :; do echo more >&2; sleep 0.01; done)"
            + " </dev/null >/dev/null & echo $!'); echo \"$left\"; read -r l; %s";
        for (String end : List.of("exit 1", "echo 2; read -r l")) {
            long left;
            try (BotProcess bot = ScriptedBots.bot(String.format(script, end))) {
                left = Long.parseLong(ScriptedBots.reply(bot, "a\n"));
                assertTrue(ScriptedBots.isRunning(left));
                if (end.startsWith("exit")) {
                    assertEquals("exited with status 1 before answering",
                        ScriptedBots.fault(bot, "b\n", ScriptedBots.FOREVER).fault());
                    ScriptedBots.assertGone(left);
                }
            }
            ScriptedBots.assertGone(left);
        }
    }

    @Test
    void theFileIsPrivateAndItsNameIsGoneWithTheStart() throws IOException {
        StderrFile stderr = StderrFile.create();
        try {
            assumeTrue(Files.getFileStore(stderr.file().toPath()).supportsFileAttributeView("posix"), "no POSIX modes");
            assertEquals("rw-------", PosixFilePermissions.toString(
                Files.getPosixFilePermissions(stderr.file().toPath())));
            stderr.unlink();
            assertTrue(Files.notExists(stderr.file().toPath()));
            assertNull(stderr.collect(true));
        } finally {
            stderr.close();
        }
    }
}
