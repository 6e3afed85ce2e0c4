package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code steward referee} as arena tools call it. */
class RefereeCommandTest {

    @TempDir
    private Path folder;
    private TextShellBots bots;

    @BeforeEach
    void makeBots() {
        bots = new TextShellBots(folder);
    }

    private static Cli referee(String one, String two, String... more) {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        List<String> arguments = new ArrayList<>(List.of("referee", "-p1", one, "-p2", two, "-scene", "duel",
            "--no-deadline"));
        arguments.addAll(List.of(more));
        Cli cli = Cli.run(arguments.toArray(String[]::new));
        assertTrue(cli.err().lines().allMatch(line -> line.matches(
            "steward: warning: -p[12] has failed in turn \\d+: .*|  .*")), cli.err());
        return new Cli(cli.status(), cli.out(), "");
    }

    /** The tool prints no word of what a bot did. */
    @Test
    @Tag("process")
    void whyABotFailedIsOnStderr() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Cli cli = Cli.run("referee", "-p1", bots.idler(0), "-p2", "sh -c 'exit 3'", "-scene", "duel", "--no-deadline",
            "-seed", "1");
        assertEquals("1\n-1\n", cli.out());
        assertEquals("""
            steward: warning: -p2 has failed in turn 1: exited with status 3 before answering
              it wrote nothing to its stderr
              hint: it was sent CodinGame's lines; does it speak JSON? then write json: before its command
            """, cli.err());
    }

    /** The tool takes a match without scores for a draw. */
    @Test
    @Tag("process")
    void aMatchWithoutAResultHasNegativeScores() {
        assumeTrue(Files.exists(Path.of("/dev/full")), "there is no /dev/full");
        Cli cli = Cli.run("referee", "-p1", bots.idler(0), "-p2", bots.idler(0), "-scene", "duel", "--no-deadline",
            "-r", "/dev/full");
        assertEquals(1, cli.status());
        assertEquals("-1\n-1\n", cli.out());
        assertTrue(cli.err().contains("could not be brought to a result: "), cli.err());
    }

    @Test
    @Tag("process")
    void theNumberOfBotsPicksTheNumberOfPlayersWhereTheGameAllowsSeveral() {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Cli cli = Cli.run("referee", "-scene", "poker-chip-race", "-p1", "true", "-p2", "true", "-p3", "true", "-p4",
            "true", "--no-deadline", "-seed", "1");
        assertEquals(0, cli.status(), cli.err());
        assertEquals("-1\n-1\n-1\n3\n", cli.out(), "the last is not asked any more");
        assertEquals(3, cli.err().lines().filter(line -> line.contains("has failed in")).count(), cli.err());
    }

    @Test
    @Tag("process")
    void scoresAreInTheOrderOfThePlayers() {
        assertEquals(new Cli(0, "1\n0\n", ""), referee(bots.driver(), bots.idler(0), "-d", "seed=7"));
        assertEquals(new Cli(0, "0\n1\n", ""), referee(bots.idler(0), bots.driver(), "-seed", "7"));
        assertEquals(new Cli(0, "0\n0\n", ""), referee(bots.idler(0), bots.idler(0), "-d", "a=1\nseed=7\nb=2"));
    }

    @Test
    @Tag("process")
    void whoFailsHasANegativeScore() {
        assertEquals(new Cli(0, "-1\n1\n", ""), referee(bots.idler(3), bots.driver(), "-d", "seed=1"));
        assertEquals(new Cli(0, "1\n-1\n", ""), referee(bots.idler(0), "true", "-d", "seed=1"));
        assertEquals(new Cli(0, "-1\n-1\n", ""), referee(bots.idler(2), bots.idler(2), "-d", "seed=1"));
    }

    @ParameterizedTest
    @Tag("process")
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "FOLDER/no/bot | bot 'codingame:FOLDER/no/bot': there is no file 'FOLDER/no/bot'",
        "builtin:nobody | bot 'builtin:nobody': there is no builtin bot 'nobody'",
        "'cat | bot ''cat', column 1: the single quote is never closed"})
    void aBotThatCannotBeStartedLoses(String command, String expected) throws IOException {
        String bot = command.replace("FOLDER", folder.toString());
        String reason = expected.replace("FOLDER", folder.toString());
        Path replay = folder.resolve("match.jsonl");
        Cli cli = Cli.run("referee", "-p1", bots.idler(0), "-p2", bot, "-p2name", "b", "-scene", "duel",
            "--no-deadline", "-seed", "1", "-r", replay.toString());
        assertEquals("1\n-1\n", cli.out());
        assertEquals(0, cli.status());
        assertTrue(cli.err().startsWith("steward: warning: -p2 has failed, because it cannot be started: " + reason)
            && cli.err().indexOf('\n') == cli.err().length() - 1, cli.err());
        assertTrue(Files.readString(replay).contains("\"name\":\"b\",\"fault\":\"could not be started: " + reason));
        assertEquals("verified: states of 1 of 1 turn and the result\n",
            Cli.run("replay", replay.toString(), "--verify").out());
    }

    /** As tools call it: with the same file names again and again, or with files that they have made. */
    @Test
    @Tag("process")
    void filesOfTheirOwnKindAreReplaced() throws IOException {
        Path log = folder.resolve("log.json");
        Path replay = folder.resolve("match.jsonl");
        String[] files = {"-seed", "5", "-l", log.toString(), "-r", replay.toString(), "-s"};
        assertEquals(0, referee(bots.driver(), bots.idler(0), files).status());
        assertEquals(0, referee(bots.driver(), bots.idler(0), files).status());
        Files.writeString(log, "{\"outputs\":{\"0\":[]},\"views\":[],\"errors\":{}}");
        Files.writeString(replay, "{\"type\":\"steward-replay\",\"format\":2,\"cut");
        assertEquals(0, referee(bots.driver(), bots.idler(0), files).status());
        assertTrue(Files.readString(log).startsWith("{\"errors\":{\"referee\":[null,"));
        assertEquals(0, referee(bots.idler(1), bots.idler(1), "-seed", "5", "-l", "/dev/null").status());
    }

    @Test
    @Tag("process")
    void otherFilesAreKept() throws IOException {
        for (String precious : List.of("int main() {}\n", "{\"errors\":[1,2]}", "[]", "{", "{\"type\":\"x\"}")) {
            Path file = Files.writeString(folder.resolve("precious"), precious);
            kept(file, "-l " + file + ": found a file of another kind", "-l", file.toString());
            kept(file, "-r " + file + ": found a file of another kind", "-r", file.toString());
        }
        Path log = folder.resolve("log.json");
        Path replay = folder.resolve("match.jsonl");
        referee(bots.idler(1), bots.idler(1), "-seed", "5", "-l", log.toString(), "-r", replay.toString());
        kept(log, "-r " + log, "-r", log.toString());
        kept(replay, "-l " + replay, "-l", replay.toString());
        Path page = Files.writeString(folder.resolve("match.html"), "<!DOCTYPE html>\n<title>mine</title>");
        kept(page, "-s: " + page + ": found a file of another kind", "-r", replay.toString(), "-s");
    }

    private void kept(Path file, String problem, String... files) throws IOException {
        String before = Files.readString(file);
        List<String> arguments = new ArrayList<>(List.of("referee", "-p1", bots.idler(1), "-p2", bots.idler(1),
            "-scene", "duel"));
        arguments.addAll(List.of(files));
        Cli cli = Cli.run(arguments.toArray(String[]::new));
        assertEquals(2, cli.status(), cli.out());
        assertEquals("-1\n-1\n", cli.out());
        assertTrue(cli.err().startsWith("steward: " + problem), cli.err());
        assertEquals(before, Files.readString(file));
    }

    @Test
    @Tag("process")
    void aDrawnSeedIsToldAfterTheScores() {
        String[] lines = referee(bots.idler(1), bots.idler(2)).out().split("\n");
        assertEquals(3, lines.length);
        assertTrue(lines[2].matches("seed=\\d+"), lines[2]);
    }

    @Test
    @Tag("process")
    void theFilesAgreeWithTheScores() throws IOException {
        Path log = Files.createFile(folder.resolve("log.json"));
        Path replay = folder.resolve("match.jsonl");
        Cli cli = referee(bots.driver(), bots.idler(0), "-seed", "5", "-l", log.toString(), "-r", replay.toString(),
            "-p2name", "Mr. Y", "-league", "3", "-s");

        assertEquals("1\n0\nreplay: " + replay + "\npage: " + folder.resolve("match.html") + "\n", cli.out());
        JsonNode json = JsonMapper.shared().readTree(Files.readString(log));
        assertEquals("{\"0\":1,\"1\":0}", json.get("scores").toString());
        assertEquals("[\"seed=5\"]", json.get("uinput").toString());
        assertEquals("Mr. Y", json.get("agents").get(1).get("name").asString());
        int turns = JsonMapper.shared().readTree(json.get("metadata").asString()).get("turns").intValue();
        assertEquals(turns + 1, json.get("outputs").get("1").size());
        assertTrue(json.get("errors").get("0").get(1).asString().startsWith("[PDATA] turns = 1\n"));
        assertEquals("verified: states of " + turns + " of " + turns + " turns and the result\n",
            Cli.run("replay", replay.toString(), "--verify").out());
        assertTrue(Files.readString(folder.resolve("match.html")).startsWith("<!DOCTYPE html>"));
    }

    @Test
    @Tag("process")
    void withoutAReplayOfItsOwnThePageHasATemporaryOne() throws IOException {
        String[] lines = referee(bots.idler(1), bots.idler(1), "-seed", "5", "-s").out().split("\n");
        assertEquals(4, lines.length);
        assertTrue(lines[2].startsWith("replay: ") && lines[3].startsWith("page: "));
        assertTrue(Files.deleteIfExists(Path.of(lines[2].substring(8))));
        assertTrue(Files.deleteIfExists(Path.of(lines[3].substring(6))));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "| found no -p1, expected -p1 to -p2: the scene \"duel\" is for 2 players",
        "-p1 cat | found no -p2, expected",
        "-scene search-race -p1 cat -p2 cat | found -p2, expected -p1 alone: the scene \"search-race\" "
            + "is for 1 player, "
            + "and there are no seats to change",
        "-p1 cat -p3 cat | found no -p2, expected -p1 to -p2: the scene \"duel\" is for 2 players",
        "-p1 cat -p2 cat -p3 cat | found -p3, expected -p1 to -p2: the scene \"duel\" is for 2 players",
        "-scene mean-max -p1 cat -p2 cat | found no -p3, expected -p1 to -p3",
        "-scene poker-chip-race -p1 cat -p2 cat -p3 cat -p4 cat -p5 cat | found -p3, expected -p1 to -p2",
        "-p1 cat -p2 cat -p9 cat | unknown option '-p9'",
        "-p1 cat -p2 cat -p3name X | found -p3name, expected -p3 with it",
        "-p1 cat -p2 cat -p2 cat | -p2: found twice, expected once",
        "-p1 cat -p2 cat -d seed | -d: found 'seed', expected key=value, such as seed=7",
        "-p1 cat -p2 cat -d seed=0x7 | expected a whole number of 64 bits after seed=",
        "-p1 cat -p2 cat -seed 1.5 | found '1.5', expected a whole number of 64 bits",
        "-p1 cat -p2 cat -seed 1 -d seed=2 | found two seeds, 1 and 2",
        "-p1 cat -p2 cat -d | -d: found nothing, expected KEY=VALUE",
        "-p1 cat -p2 cat -lvl gold | expected a whole number",
        "-p1 cat -p2 cat -league -1 | expected 0 or more",
        "-p1 cat -p2 cat -l FOLDER/no/x | there is no folder FOLDER/no",
        "-p1 cat -p2 cat -r FOLDER/no/x | there is no folder FOLDER/no",
        "-p1 cat -p2 cat -l FOLDER/x -r FOLDER/./x | expected two files",
        "-p1 cat -p2 cat -scene nowhere | nowhere: found no such file",
        "-p1 cat -p2 cat --time-factor 0 | expected a finite number above 0",
        "-p1 cat -p2 cat --time-factor 2 --no-deadline | exclude each other",
        "-p1 cat -p2 cat extra | 'extra': found more than"})
    void aWrongCallGivesEachBotThatItNamesMinusOne(String arguments, String problem) {
        List<String> words = new ArrayList<>(List.of("referee"));
        if (arguments == null || !arguments.contains("-scene")) {
            words.addAll(List.of("-scene", "duel"));
        }
        if (arguments != null) {
            Stream.of(arguments.split(" ")).map(word -> word.replace("FOLDER", folder.toString())).forEach(words::add);
        }
        Cli cli = Cli.run(words.toArray(String[]::new));
        assertEquals(2, cli.status());
        long bots = words.stream().filter(word -> word.matches("-p[1-8]")).distinct().count();
        assertEquals("-1\n".repeat((int) bots), cli.out());
        assertTrue(cli.err().contains(problem.replace("FOLDER", folder.toString())), cli.err());
    }
}
