package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.Main;
import steward.cli.ProcessTest;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;

/** {@code steward feed} with bots that are shell scripts. */
@Tag("process")
@Timeout(60)
class FeedCommandTest {

    /** Arguments: thrust, the turn in which it is another (0: never), what to do there. */
    private static final String BOT = """
        t=0
        while IFS= read -r line; do
          case $line in *'"type":"turn"'*) ;; *) continue ;; esac
          t=$((t + 1)); thrust=$1
          [ $t != "$2" ] || eval "$3"
          echo "{\\"pods\\":[{\\"x\\":10500,\\"y\\":3500,\\"thrust\\":$thrust}]}"
        done
        """;
    private static final int TURNS = 51;

    @TempDir
    private Path folder;
    private Path replay;
    private String script;

    /** A match of 51 turns: "near" always says the same, "far" is out at its end. */
    @BeforeEach
    void match() throws IOException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        script = Files.writeString(folder.resolve("bot.sh"), BOT).toString();
        replay = folder.resolve("x.jsonl");
        ShellBots bots = new ShellBots(folder);
        Cli match = Cli.run("match", "--scene", "duel", "--no-deadline", "--seed", "7", "--out", replay.toString(),
            "--bot", bots.driver("near", ShellBots.CHECKPOINT), "--bot", bots.driver("far", ShellBots.NOWHERE));
        assertEquals(ExitStatus.DONE, match.status(), match.err());
    }

    private Cli feed(String options, String... command) {
        return feedTyped("", options, command);
    }

    /** @param typed the input of the program */
    private Cli feedTyped(String typed, String options, String... command) {
        return feed(new ByteArrayInputStream(typed.getBytes(StandardCharsets.UTF_8)), options, command);
    }

    private Cli feed(InputStream in, String options, String... command) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        String[] words = ("feed " + replay + (options.contains("--player") ? " " : " --player 0 ") + options).strip()
            .split(" +");
        String[] call = Arrays.copyOf(words, words.length + 1 + command.length);
        call[words.length] = "--";
        System.arraycopy(command, 0, call, words.length + 1, command.length);
        int status = Main.run(new Streams(in, false, out, err, false, false), call);
        return new Cli(status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    private String[] bot(String... arguments) {
        String[] words = {"sh", script, arguments[0], arguments.length > 1 ? arguments[1] : "0",
            arguments.length > 2 ? arguments[2] : ""};
        return words;
    }

    @Test
    void theSameAnswersAreTheSame() {
        Cli cli = feed("", bot("100"));
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        List<String> lines = cli.out().lines().toList();
        assertTrue(lines.get(0).matches("process \\d+ is player 0 of .*x\\.jsonl, speaks json: sh .*bot\\.sh 100 0 ''"),
            cli.out());
        assertEquals("turn    1  same", lines.get(1));
        assertEquals("51 turns compared: 51 the same, 0 different", lines.get(TURNS + 1));
        assertEquals(TURNS + 2, lines.size());
    }

    @Test
    void whatDiffersIsTold() {
        Cli cli = feed("--quiet", bot("100", "7", "thrust=50"));
        assertEquals(ExitStatus.FAILED, cli.status());
        assertEquals(List.of("turn    7  differs: command[0].thrust recorded 100, now 50",
            "51 turns compared: 50 the same, 1 different (turn 7)"), cli.out().lines().skip(1).toList());
        Cli all = feed("--quiet", bot("50"));
        assertTrue(all.out().endsWith("0 the same, 51 different (turns 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, ...)\n"));
    }

    @Test
    void aBotThatEndsIsToldWithItsStatus() {
        Cli cli = feed("", bot("100", "3", "exit 4"));
        assertEquals(ExitStatus.FAILED, cli.status());
        assertTrue(cli.out().contains("turn    3  differs: recorded a command, now exited with status 4 before "
            + "answering\n3 turns compared: 2 the same, 1 different (turn 3)\n"), cli.out());
    }

    @Test
    void itStopsAndWaitsForEnter() {
        Cli enter = feedTyped("\n", "--until 9", bot("100"));
        assertEquals(ExitStatus.DONE, enter.status());
        assertTrue(enter.out().contains("9 turns compared: 9 the same, 0 different\nstopped after turn 9; process "),
            enter.out());
    }

    @Test
    void aBotThatEndsWhileItIsHeldNeedsNoEnter() throws IOException {
        try (PipedOutputStream nobody = new PipedOutputStream(); PipedInputStream in = new PipedInputStream(nobody)) {
            Cli cli = feed(in, "--until 9", bot("100", "9",
                "echo '{\"pods\":[{\"x\":10500,\"y\":3500,\"thrust\":100}]}'; exit 0"));
            assertEquals(ExitStatus.DONE, cli.status(), cli.out());
            assertTrue(cli.out().contains("stopped after turn 9; process "), cli.out());
        }
    }

    @Test
    void itPausesBeforeATurn() {
        Cli cli = feedTyped("\n", "--pause=3", bot("100"));
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        List<String> lines = cli.out().lines().toList();
        assertEquals("turn    2  same", lines.get(2));
        assertTrue(lines.get(3).matches("waiting before turn 3: attach to process \\d+, then press Enter"), cli.out());
        assertTrue(feedTyped("\n", "--quiet --pause", bot("100")).out().contains("waiting before turn 1: "));
    }

    /** Many bots read in an endless loop: they would go on answering for ever. */
    @Test
    @Tag("campaign")
    void aBotThatDoesNotSeeTheEndIsEnded() throws IOException, InterruptedException {
        Path pid = folder.resolve("pid");
        Cli cli = feed("--quiet", "sh", "-c", "echo $$ >" + pid + "; read -r setup; while :; do read -r line; "
            + "echo '{\"pods\":[{\"x\":10500,\"y\":3500,\"thrust\":100}]}'; done");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertFalse(ProcessHandle.of(Long.parseLong(Files.readString(pid).strip())).map(ProcessHandle::isAlive)
            .orElse(false));
    }

    /** A loop around a read that fails, as beginners write it, said so thousands of times behind the verdict. */
    @Test
    void theVerdictIsTheLastWordAndABotThatSpinsAtTheEndSaysNoMore() throws IOException, InterruptedException {
        String spins = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", "-c",
            "sh " + script + " 100; echo loose >&2; while :; do echo end of file >&2; done");
        assertEquals("51 turns compared: 51 the same, 0 different\nstatus 0\n",
            ProcessTest.shell(spins).replaceFirst("process.*\n", ""));
        String ends = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", "-c",
            "sh " + script + " 100; echo bye >&2");
        assertEquals("bye\n51 turns compared: 51 the same, 0 different\nstatus 0\n",
            ProcessTest.shell(ends).replaceFirst("process.*\n", ""));
    }

    @Test
    void aBotThatSpeaksLinesIsFedLines() {
        Cli cli = feed("--protocol codingame", "sh", "-c",
            "while read -r own; do read -r other; echo 10500 3500 100; done");
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().contains(", speaks codingame: sh -c ") && cli.out().contains("51 the same"), cli.out());
    }

    @Test
    void stderrOfTheBotIsOurs() throws IOException, InterruptedException {
        String call = ProcessTest.steward("feed", replay.toString(), "--player", "0", "--quiet", "--", "sh", script,
            "100", "5", "echo so far >&2");
        assertTrue(ProcessTest.shell(call + " >/dev/null").equals("so far\nstatus 0\n"));
    }

    @Test
    void theBotPlaysOnAndWhatItPlaysVerifies() {
        Path file = folder.resolve("new.jsonl");
        Cli cli = feed("--from-turn 20 --replace --out " + file, bot("100", "30", "thrust=90"));
        assertEquals(ExitStatus.DONE, cli.status(), cli.err());
        assertTrue(cli.out().contains("turn   19  same\nturn   20  played, same\n"), cli.out());
        assertTrue(cli.out().contains("turn   30  played, differs: command[0].thrust recorded 100, now 90\n"
            + "turn   31  played\n"), cli.out());
        assertTrue(cli.out().contains("19 turns compared: 19 the same, 0 different\n32 turns played by the bot\n"
            + "bot.sh wins: the other player is out, 51 turns (duel, seed 7)\n"), cli.out());
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
        Cli early = feed("--from-turn 20 --replace --overwrite --quiet --out " + file, bot("100", "3", "exit 1"));
        assertEquals(ExitStatus.FAILED, early.status());
        assertTrue(early.out().contains("no result after 2 turns: the bot has ended before turn 20; ahead then: "),
            early.out());
        assertEquals("verified up to the cut: states of 2 of 2 turns\n",
            Cli.run("replay", file.toString(), "--verify").out());
    }

    /** Which player, as its number or its name; a name that is another's is told from it by the number. */
    @Test
    void theBotPlaysUnderItsOwnName() throws IOException {
        Path file = folder.resolve("new.jsonl");
        String call = "--player near --from-turn 20 --replace --quiet --overwrite --out " + file;
        String[] words = bot("100");
        words[0] = "mine=json:sh";
        assertEquals(ExitStatus.DONE, feed(call, words).status());
        assertTrue(Files.readString(file).contains("\"players\":[{\"name\":\"mine\",\"bot\":\"mine=sh "), "header");
        words[0] = "far=sh";
        assertEquals(ExitStatus.DONE, feed(call, words).status());
        assertTrue(Files.readString(file).contains("\"players\":[{\"name\":\"far-0\",\"bot\":\"far=sh "), "header");
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            Cli.run("replay", file.toString(), "--verify").out());
    }

    /** A player that spoke CodinGame's lines, and a bundled bot, which speaks JSON. */
    @Test
    void aPrefixSaysWhatTheBotSpeaks() {
        Path lines = folder.resolve("lines.jsonl");
        String reader = "while read -r own; do read -r other; echo 10500 3500 100; done";
        Cli match = Cli.run("match", "--scene", "duel", "--no-deadline", "--seed", "7", "--out", lines.toString(),
            "--bot", "lines=codingame:sh -c '" + reader + "'", "--bot", "builtin:racer");
        assertEquals(ExitStatus.DONE, match.status(), match.err());
        Cli builtin = Cli.run("feed", lines.toString(), "--player", "lines", "--", "builtin:racer");
        assertEquals(ExitStatus.FAILED, builtin.status(), builtin.err());
        assertTrue(builtin.out().lines().findFirst().orElseThrow().endsWith(", speaks json: builtin:racer"),
            builtin.out());
        assertTrue(builtin.out().contains("\nturn    1  differs: command[0]."), builtin.out());
        Cli same = Cli.run("feed", lines.toString(), "--player", "lines", "--quiet", "--", "sh", "-c", reader);
        assertEquals(ExitStatus.DONE, same.status(), same.out());
        Cli other = Cli.run("feed", lines.toString(), "--player", "1", "--quiet", "--", "codingame:sh", "-c", reader);
        assertTrue(other.out().contains(", speaks codingame: sh -c '") && other.out().contains("differs"),
            other.out());
        Cli whole = Cli.run("feed", lines.toString(), "--player", "1", "--quiet", "--", "codingame:sh -c '" + reader
            + "'");
        assertEquals(other.out().lines().skip(1).toList(), whole.out().lines().skip(1).toList());
    }

    @Test
    void programsReadOneObject() {
        Cli same = feed("--json", bot("100"));
        assertEquals("{\"player\":0,\"name\":\"near\",\"bot\":\"sh " + script + " 100 0 ''\",\"protocol\":\"json\","
            + "\"compared\":51,\"same\":51,\"differing\":[],\"played\":null}\n", same.out());
        assertEquals("", same.err());
        Cli other = feed("--json", bot("100", "7", "thrust=50"));
        assertEquals(ExitStatus.FAILED, other.status());
        assertEquals("[{\"turn\":7,\"recordedFault\":null,\"fault\":null,\"fields\":[{\"field\":\"command[0].thrust\","
            + "\"recorded\":\"100\",\"now\":\"50\"}]}]", other.json().get("differing").toString());
        Cli played = feed("--json --from-turn 20 --replace --out " + folder.resolve("new.jsonl"), bot("100"));
        assertEquals("{\"turns\":32,\"turnsInAll\":51,\"ending\":\"all others are out\",\"noResultBecause\":null,"
            + "\"ahead\":[\"bot.sh\"],\"replay\":\"" + folder.resolve("new.jsonl") + "\"}",
            played.json().get("played").toString());
    }

    @Test
    void aReplayComesAndGoesByPipes() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        try (InputStream in = Files.newInputStream(replay)) {
            int status = Main.run(new Streams(in, false, out, err, false, false), "feed", "-", "--player", "near",
                "--from-turn", "20", "--replace", "--quiet", "--out", "-", "--", "sh", script, "100", "0", "");
            assertEquals(ExitStatus.DONE, status, err.toString(StandardCharsets.UTF_8));
        }
        assertTrue(err.toString(StandardCharsets.UTF_8).contains("32 turns played by the bot\n"));
        ByteArrayOutputStream verified = new ByteArrayOutputStream();
        Main.run(new Streams(new ByteArrayInputStream(out.toByteArray()), false, verified, err, false, false),
            "replay", "-", "--verify");
        assertEquals("verified: states of 51 of 51 turns and the result\n",
            verified.toString(StandardCharsets.UTF_8));
    }

    @Test
    void waitingIsToldOnATerminal() throws InterruptedException {
        ByteArrayOutputStream terminal = new ByteArrayOutputStream();
        PrintStream printed = new PrintStream(terminal, true, StandardCharsets.UTF_8);
        try (WaitingNotice notice = new WaitingNotice(printed, "json", 50)) {
            notice.asked(1);
            notice.answered();
            notice.asked(2);
            while (terminal.size() == 0) {
                Thread.sleep(10);
            }
            notice.answered();
        }
        assertEquals("waiting for the bot's answer to turn 2 (it is sent json)\n",
            terminal.toString(StandardCharsets.UTF_8));
        try (WaitingNotice nowhere = new WaitingNotice(null, "json", 0)) {
            nowhere.asked(1);
            nowhere.answered();
        }
    }

    private void refused(String message, String options, String... command) {
        feed(options, command).assertRefused(message);
    }

    @Test
    void wrongCallsAreRefusedBeforeTheBotIsStarted() throws IOException {
        Path started = folder.resolve("started");
        String[] bot = {"sh", "-c", "touch " + started};
        Path precious = Files.writeString(folder.resolve("precious"), "precious");
        refused("expected the command of a bot", "");
        Cli player = Cli.run("feed", replay.toString(), "--player", "2", "--", "sh");
        assertEquals("steward: --player: found 2, expected 0 to 1 in " + replay + ", or a name: near, far\n",
            player.err());
        assertEquals(ExitStatus.UNUSABLE, player.status());
        refused("there is no program 'no-such-program'", "", "no-such-program");
        refused("--until: found 52, expected 1 to 51", "--until 52", bot);
        refused("--until: found 0, expected 1 to 51", "--until 0", bot);
        refused("--pause: found 99, expected 1 to 51", "--pause=99", bot);
        refused("--from-turn: found 52, expected 1 to 51", "--from-turn 52 --replace --out y", bot);
        refused("--replace: expected --from-turn and --out", "--replace --out y", bot);
        refused("--from-turn is for --replace", "--from-turn 3", bot);
        refused("--out is for --replace", "--out y", bot);
        refused("--overwrite: expected --out", "--overwrite", bot);
        refused("--until and --replace exclude", "--until 3 --from-turn 3 --replace --out y", bot);
        refused("--protocol: found 'x', expected json or codingame", "--protocol x", bot);
        refused("expected json or none: 'builtin:racer' speaks json", "--protocol codingame", "builtin:racer");
        refused("there is no builtin bot 'race'", "", "builtin:race");
        refused("there is no command", "", "json:");
        refused("--json is printed to the standard output", "--json --from-turn 3 --replace --out -", bot);
        refused("--pause is for attaching", "--pause", "gdb", "./a.out");
        refused("found the replay itself", "--from-turn 3 --replace --overwrite --out " + replay, bot);
        refused("exists already, and is kept", "--from-turn 3 --replace --out " + precious, bot);
        refused("there is no folder", "--from-turn 3 --replace --out " + folder + "/none/y", bot);
        assertFalse(Files.exists(started));
        assertEquals("precious", Files.readString(precious));
    }

    @Test
    void filesThatCannotBeFedAreRefused() throws IOException {
        byte[] whole = Files.readAllBytes(replay);
        String text = new String(whole, StandardCharsets.UTF_8);
        String[] bot = bot("100");
        for (String wrong : List.of("", "hello\n", text.replaceFirst("\"format\":3", "\"format\":999"),
            text.substring(0, 100), text.replaceFirst("\"game\":\"pod-race\",\"seed\"", "\"game\":\"x\",\"seed\""))) {
            Files.writeString(replay, wrong);
            refused(replay.toString(), "", bot);
        }
        Files.delete(replay);
        refused("found no such file, expected a replay", "", bot);
    }
}
