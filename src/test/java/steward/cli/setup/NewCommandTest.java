package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.match.Protocol;
import tools.jackson.databind.JsonNode;

/** {@code steward new}. */
class NewCommandTest {

    @TempDir
    private Path folder;

    /** A scene with two discs, since no shipped scene of bodies has players. */
    private static final String PUSH = """
        { "name": "push", "game": "bodies", "players": 2, "field": { "width": 400, "height": 200, "walls": "box" },
          "bodies": { "listed": [ { "x": 100, "y": 100, "radius": 10, "owner": 0 },
            { "x": 300, "y": 101, "radius": 10, "owner": 1 } ] },
          "play": { "maximumTurns": 30, "maximumThrust": 2, "contactPoints": 3 },
          "time": { "firstAnswerMs": 1000, "answerMs": 50 },
          "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;

    static Stream<Arguments> everyStarter() {
        return Games.ids().stream().flatMap(game -> Stream.of(StarterLanguage.values())
            .flatMap(language -> Stream.of(Protocol.values()).map(spoken -> Arguments.of(game, language, spoken))));
    }

    /** Every language in every protocol, and every game. */
    static Stream<Arguments> diagonal() {
        List<String> games = Games.ids();
        StarterLanguage[] languages = StarterLanguage.values();
        return IntStream.range(0, 2 * languages.length).mapToObj(k -> Arguments.of(games.get(k % games.size()),
            languages[k % languages.length], Protocol.values()[k / languages.length]));
    }

    /** C++ is compiled without optimisation, which takes longer than the game. */
    @ParameterizedTest
    @MethodSource("diagonal")
    @Tag("process")
    void aStarterPlaysAWholeGameWithoutAFault(String game, StarterLanguage language, Protocol spoken)
            throws IOException, InterruptedException {
        assertItPlays(game, language, spoken,
            language.compile().stream().map(each -> each.replace("-O2", "-O0")).toList());
    }

    @ParameterizedTest
    @MethodSource("everyStarter")
    @Tag("process")
    @Tag("campaign")
    void aStarterThatIsCompiledAsItsReadmeSaysPlaysAWholeGame(String game, StarterLanguage language, Protocol spoken)
            throws IOException, InterruptedException {
        assertItPlays(game, language, spoken, language.compile());
    }

    /**
     * Plays against the bundled bot that the call names which {@code new} prints. A score above nothing is one that a
     * bot without valid commands does not have: checkpoints passed, water, goals, chips, contacts; in the search race a
     * time below 600.
     */
    private void assertItPlays(String game, StarterLanguage language, Protocol spoken, List<String> compile)
            throws IOException, InterruptedException {
        Path place = folder.resolve("a bot");
        Cli made = Cli.run("new", language.word(), place.toString(), "--game", game, "--protocol", spoken.word());
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        compile(compile, place);
        List<String> call = new ArrayList<>(List.of("match", "--seed", "7", "--json", "--time-factor", "30"));
        String printed = made.out().lines().reduce((one, other) -> other).orElseThrow().strip()
            .replace("SCENE.json", Files.writeString(folder.resolve("push.json"), PUSH).toString());
        List<String> words = CommandLine.split(printed);
        for (String word : words.subList(2, words.size())) {
            call.add(word.startsWith("me=") ? "me=" + called(language.bot(spoken), place) : word);
        }
        assertItScores(Cli.run(call.toArray(String[]::new)), game.equals("search-race"));
    }

    private static void assertItScores(Cli match, boolean less) {
        assertEquals(ExitStatus.DONE, match.status(), match.err());
        JsonNode me = match.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), match.out());
        double score = me.get("score").doubleValue();
        assertTrue(less ? score < 600 : score > 0, match.out());
    }

    private static void compile(List<String> compile, Path place) throws IOException, InterruptedException {
        for (String command : compile) {
            List<String> words = CommandLine.split(command);
            assumeTrue(ProgramFinder.find(words.get(0)) != null, "there is no " + words.get(0));
            assertEquals(0, new ProcessBuilder(words).directory(place.toFile()).inheritIO().start().waitFor());
        }
    }

    /** The bot, called from elsewhere. */
    private static String called(String bot, Path place) {
        String quoted = CommandLine.quote(List.of(place.toString()));
        String called = bot.replace("./bot", CommandLine.quote(List.of(place.resolve("bot").toString())))
            .replace(" bot.", " " + quoted + "/bot.").replace("java Bot", "java -cp " + quoted + " Bot");
        String program = CommandLine.split(called.replace("codingame:", "")).get(0);
        assumeTrue(program.contains("/") || ProgramFinder.find(program) != null, "there is no " + program);
        return called;
    }

    @Test
    @Tag("process")
    @Tag("campaign")
    void theBotThatSearchesRaces() throws IOException, InterruptedException {
        Path place = folder.resolve("a bot");
        Cli made = Cli.run("new", "cpp", place.toString(), "--simulator").done();
        String readme = Files.readString(place.resolve(NewCommand.README));
        List<String> compile = made.out().lines().filter(line -> line.startsWith("  g++")).map(String::strip).toList();
        assertTrue(readme.contains("Compile it: " + compile.get(0) + "\n"), readme);
        compile(compile, place);
        Process alone = new ProcessBuilder(place.resolve("bot").toString()).start();
        alone.getOutputStream().close();
        assertEquals(0, alone.waitFor(), "at the end of its input");
        assertItScores(Cli.run("match", "--bot", "me=" + called("codingame:./bot", place), "--bot", "builtin:racer",
            "--seed", "7", "--json", "--time-factor", "30"), false);
    }

    @ParameterizedTest
    @MethodSource("everyStarter")
    void itsReadmeAndWhatIsPrintedSayHowToRunIt(String game, StarterLanguage language, Protocol spoken)
            throws IOException {
        Cli made = Cli.run("new", language.word(), folder.toString(), "--game", game, "--protocol", spoken.word());
        assertEquals(new Cli(ExitStatus.DONE, made.out(), ""), made);
        String readme = Files.readString(folder.resolve(NewCommand.README));
        for (String text : List.of(readme, made.out())) {
            assertTrue(text.contains(CommandLine.quote(List.of("me=" + language.bot(spoken)))), text);
            language.compile().forEach(command -> assertTrue(text.contains(command), text));
        }
        List<String> source = Files.readAllLines(folder.resolve(language.source()));
        assertTrue(source.stream().noneMatch(line -> line.contains("{{") || line.endsWith(" ")), source::toString);
        assertTrue(source.stream().anyMatch(line -> line.contains("Change this")), source::toString);
        assertEquals(List.of(), source.stream().filter(line -> line.length() > 120).toList());
    }

    @Test
    void itSaysWhichProtocolItWritesAndTakesAnother() {
        String usual = Cli.run("new", "python", folder.resolve("usual").toString()).out();
        assertTrue(usual.contains("It speaks JSON."), usual);
        String other = Cli.run("new", "python", folder.resolve("other").toString(), "--protocol", "codingame").out();
        assertTrue(other.contains("It speaks CodinGame's lines.") && other.contains("codingame:python3 bot.py"), other);
        String java = Cli.run("new", "java", folder.resolve("java").toString()).out();
        assertTrue(java.contains("It speaks CodinGame's lines.") && java.contains("codingame:java Bot"), java);
    }

    @Test
    void aFolderWithFilesIsLeftAlone() throws IOException {
        Path mine = Files.writeString(folder.resolve("bot.py"), "precious");
        Cli cli = Cli.run("new", "python", folder.toString());
        assertEquals(new Cli(ExitStatus.UNUSABLE, "", "steward: " + folder
            + ": found a folder with files in it, expected a new or empty one\n"), cli);
        assertEquals("precious", Files.readString(mine));
        assertEquals("steward: " + mine + ": found a file, expected a new or empty folder\n",
            Cli.run("new", "python", mine.toString()).err());
    }
}
