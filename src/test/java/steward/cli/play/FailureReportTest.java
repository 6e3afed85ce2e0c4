package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;
import steward.cli.Cli;
import steward.cli.ShellBots;
import tools.jackson.databind.JsonNode;

/** Why a bot failed is said where people look: below the result, in one line with {@code --quiet}, and in JSON. */
@Tag("process")
@Timeout(60)
class FailureReportTest {

    private static final String ANSWER = "echo '{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}'; ";

    @TempDir
    private Path folder;

    @BeforeEach
    void shell() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
    }

    /** A match against a bot that is a shell script. */
    private Cli match(String prefix, String script, String... more) throws IOException {
        String bot = "me=" + prefix + "sh "
            + CommandLine.quote(List.of(Files.writeString(folder.resolve("me.sh"), script).toString()));
        return Cli.run(Stream.concat(Stream.of("match", "--scene", "duel", "--seed", "7", "--bot", bot, "--bot",
            new ShellBots(folder).driver("other", ShellBots.CHECKPOINT)), Stream.of(more)).toArray(String[]::new));
    }

    /** Twelve lines in two turns: the last ten, of both. */
    @Test
    void theLastLinesOfStderrAndTheTurnAreBelowTheReason() throws IOException {
        String script = "read -r setup; read -r turn; echo one >&2; echo two >&2; echo three >&2; " + ANSWER
            + "read -r turn; printf '%s\\n' 4 5 6 7 8 9 10 11 '' 'Value\033Error: a dog' >&2; exit 1";
        String out = match("", script, "--no-deadline").out();
        assertTrue(out.contains("""
            me failed in turn 2: exited with status 1 before answering
              its stderr says: Value\\u001BError: a dog
              the last 10 lines of its stderr:
                three
                4
                5
                6
                7
                8
                9
                10
                11
                Value\\u001BError: a dog
            """), out);
    }

    /** Its ten last lines are frames. */
    private static final String TRACE = "echo early >&2; echo 'Exception in thread \"main\" Oops: no dog' >&2; "
        + "for n in 1 2 3 4 5 6 7 8 9 10 11 12; do printf '\\tat Bot.f(Bot.java:%s)\\n' $n >&2; done; exit 1";
    private static final String SAYS = "its stderr says: Exception in thread \"main\" Oops: no dog\n";

    @Test
    void theLineThatSaysWhyIsFoundBehindFramesAndStandsFirst() throws IOException {
        String out = match("", TRACE, "--no-deadline").out();
        assertTrue(out.contains("  " + SAYS + "  with the lines behind it:\n    Exception in thread \"main\" Oops: "
            + "no dog\n    \tat Bot.f(Bot.java:1)\n") && out.contains("Bot.java:9)\n") && !out.contains("Bot.java:10)"),
            out);
        assertTrue(match("", TRACE, "--no-deadline", "--quiet").out().endsWith(
            "before answering (Exception in thread \"main\" Oops: no dog)\n"));
        Cli check = Cli.run("check", "--scene", "duel", "sh " + folder.resolve("me.sh"));
        assertTrue(check.out().replaceAll("\\s+", " ").contains("says why: Exception in thread \"main\" Oops:")
            && check.out().contains(SAYS), check.out());
        JsonNode failure = Cli.run("check", "--scene", "duel", "sh " + folder.resolve("me.sh"), "--json").json()
            .get("failure");
        assertEquals("Exception in thread \"main\" Oops: no dog", failure.get("error").stringValue());
        assertEquals(10, failure.get("stderr").size());
    }

    /** An arena tool shows the standard error of its referee, or keeps what it prints. */
    @Test
    void refereeAndPlaySayItToo() throws IOException {
        String bot = "sh " + Files.writeString(folder.resolve("me.sh"), TRACE);
        Cli referee = Cli.run("referee", "-p1", bot, "-p2", "builtin:racer", "-d", "seed=7");
        assertTrue(referee.err().contains("-p1 has failed in turn 1: exited with status 1 before answering\n  " + SAYS)
            && referee.err().contains("Bot.java:9)"), referee.err());
        assertEquals(2, referee.out().lines().count(), referee.out());
        Cli play = Cli.run("play", "--json-league", bot, "builtin:racer", "--seed", "7");
        assertTrue(play.err().contains(SAYS), play.err());
        assertEquals("exited with status 1 before answering (Exception in thread \"main\" Oops: no dog)",
            play.json().get("faults").get(0).stringValue());
        assertTrue(play.json().get("faults").get(1).isNull(), play.out());
        Cli hinted = Cli.run("play", "--json-league", "sh -c 'exit 127'", "builtin:racer", "--seed", "7");
        assertTrue(hinted.err().contains("it wrote nothing to its stderr\n  hint: a program was not found"),
            hinted.err());
    }

    /** As in a series: that both fail in one turn says nothing about who plays better. */
    @Test
    void twoCrashedBotsAreNoDrawOfMerit() {
        String[] call = {"match", "--scene", "duel", "--seed", "7", "--bot", "false", "--bot", "b=false"};
        String headline = "no winner and no draw of merit: both bots failed, 1 turn (duel, seed 7)";
        assertEquals(headline, Cli.run(call).out().lines().findFirst().orElse(""));
        JsonNode json = Cli.run(Stream.concat(Stream.of(call), Stream.of("--json")).toArray(String[]::new)).json();
        assertTrue(json.get("winner").isNull() && json.get("allFailed").booleanValue(), json.toString());
    }

    @Test
    void quietSaysItOnTheOneLine() throws IOException {
        assertEquals("other wins: the other player is out, 1 turn (duel, seed 7); me failed in turn 1: exited with "
            + "status 1 before answering (ValueError: a dog)\n",
            match("", "echo some >&2; echo '  ValueError: a dog' >&2; exit 1", "--no-deadline", "--quiet").out());
    }

    @Test
    void jsonHasTurnLinesAndHints() throws IOException {
        JsonNode players = match("", "echo 'ValueError: a dog' >&2; exit 1", "--no-deadline", "--json", "--sandbox",
            "off").json().get("players");
        assertEquals("{\"turn\":1,\"error\":\"ValueError: a dog\",\"stderr\":[\"ValueError: a dog\"],"
            + "\"hints\":[\"it was sent JSON; is it a CodinGame bot? then write codingame: before its command\"],"
            + "\"time\":null}",
            players.get(0).get("failure").toString());
        assertTrue(players.get(1).get("failure").isNull());
    }

    @Test
    void aTracebackThatHasNothingToDoWithItsInputIsNoReasonToAskForTheProtocol() throws IOException {
        String traceback = "echo 'Traceback (most recent call last):' >&2; echo '  File \"b.py\", line 3' >&2; echo '";
        String other = match("", traceback + "ZeroDivisionError: division by zero' >&2; exit 1", "--no-deadline").out();
        assertTrue(other.contains("ZeroDivisionError") && !other.contains("codingame:"), other);
        String input = match("", traceback + "ValueError: invalid literal for int()' >&2; exit 1", "--no-deadline")
            .out();
        assertTrue(input.contains("is it a CodinGame bot?"), input);
        String reads = match("", "echo '    pod = frame[\"pods\"][9]' >&2; " + traceback
            + "IndexError: list index out of range' >&2; exit 1", "--no-deadline").out();
        assertTrue(reads.contains("IndexError") && !reads.contains("codingame:"), "it speaks JSON: " + reads);
        String number = match("codingame:", "echo '    if frame[\"type\"] == \"end\": break' >&2; " + traceback
            + "TypeError: 1 object is not subscriptable' >&2; exit 1", "--no-deadline").out();
        assertTrue(number.contains("does it speak JSON? then write json: "), "it was sent a number: " + number);
    }

    @Test
    void aBotThatNeverFlushesIsAskedWhetherItDoes() throws IOException {
        String out = match("", "sleep 30", "--time-factor", "0.2").out();
        assertTrue(out.contains("me failed in turn 1: no answer within 200 ms"), out);
        assertTrue(out.contains("\n  hint: nothing ever came on its stdout; does it flush after every answer, "
            + "and start in time?\n"), out);
        String late = match("", "read -r setup; read -r turn; " + ANSWER + "sleep 30", "--time-factor", "0.5").out();
        assertTrue(late.contains("me failed in turn 2: no answer within ") && !late.contains("hint:"), late);
    }

    @Test
    void aBotThatAnswersInTheOtherProtocolIsToldHowToSaySo() throws IOException {
        String out = match("", "read -r setup; echo 1000 2000 100; sleep 30", "--no-deadline").out();
        assertTrue(out.contains("hint: it was sent JSON; is it a CodinGame bot? then write codingame: before"), out);
        String json = match("codingame:", "read -r setup; " + ANSWER + "sleep 30", "--no-deadline").out();
        assertTrue(json.contains("hint: it was sent CodinGame's lines; does it speak JSON? then write json: "), json);
    }

    @Test
    void aProgramThatIsNotThereOrCannotBeExecutedIsToldApart() throws IOException {
        String missing = match("", "exec " + folder + "/no/program").out();
        assertTrue(missing.contains("(127: a command was not found)"), missing);
        assertTrue(missing.contains(folder + "/no/program"), missing);
        assertTrue(missing.contains("hint: a program was not found: "), missing);
        Path plain = Files.writeString(folder.resolve("plain"), "x");
        String forbidden = match("", "exec " + plain).out();
        assertTrue(forbidden.contains("hint: a program could not be executed: "), forbidden);
    }
}
