package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import tools.jackson.databind.JsonNode;

/** {@code steward new}. */
class NewCommandTest {

    @TempDir
    private Path folder;

    /** The first forty turns; the starter in C++ is compiled without optimisation. */
    @ParameterizedTest
    @EnumSource(names = {"PYTHON", "CPP"})
    @Tag("process")
    void aStarterRacesAtOnceWithoutAFault(Starter starter) throws IOException, InterruptedException {
        String scene = Files.readString(Path.of("config/scenes/mad-pod-racing.json"));
        Path brief = Files.writeString(folder.resolve("brief.json"), scene.replaceFirst("\"maximumTurns\": \\d+",
            "\"maximumTurns\": 40"));
        assertItRaces(starter, starter.compile().stream().map(each -> each.replaceAll("-O[23]", "-O0")).toList(),
            brief.toString(), 1);
    }

    /** A whole race of each, compiled as its README says. */
    @ParameterizedTest
    @EnumSource
    @Tag("process")
    @Tag("campaign")
    void aStarterThatIsCompiledAsItsReadmeSaysRaces(Starter starter) throws IOException, InterruptedException {
        assertItRaces(starter, starter.compile(), "mad-pod-racing", 3);
    }

    /** A bot that races passes checkpoints, which is what a score counts. */
    private void assertItRaces(Starter starter, List<String> compile, String scene, int score)
            throws IOException, InterruptedException {
        Path place = folder.resolve("a bot");
        Cli made = make(starter, place);
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        for (String command : compile) {
            List<String> words = CommandLine.split(command);
            assumeTrue(ProgramFinder.find(words.get(0)) != null, "there is no " + words.get(0));
            assertEquals(0, new ProcessBuilder(words).directory(place.toFile()).inheritIO().start().waitFor());
        }
        String called = starter.bot().replace("./bot", CommandLine.quote(List.of(place.resolve("bot").toString())))
            .replace("bot.", CommandLine.quote(List.of(place.toString())) + "/bot.")
            .replace("java Bot", "java -cp " + CommandLine.quote(List.of(place.toString())) + " Bot");
        String program = CommandLine.split(called.replace("codingame:", "")).get(0);
        assumeTrue(program.contains("/") || ProgramFinder.find(program) != null, "there is no " + program);

        Cli cli = Cli.run("match", "--scene", scene, "--bot", "me=" + called, "--bot", "builtin:racer", "--seed", "7",
            "--json", "--time-factor", "30");

        JsonNode me = cli.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), cli.out());
        assertNotNull(me.get("score"));
        assertTrue(me.get("score").doubleValue() >= score, cli.out());
        assertTrue(made.out().contains("steward match --bot '") || made.out().contains("--bot me="), made.out());
    }

    private static Cli make(Starter starter, Path place) {
        return starter.searches() ? Cli.run("new", starter.word(), place.toString(), "--simulator")
            : Cli.run("new", starter.word(), place.toString(), "--protocol", starter.protocol().word());
    }

    @ParameterizedTest
    @EnumSource
    void itsReadmeSaysHowToRunIt(Starter starter) throws IOException {
        make(starter, folder);
        String readme = Files.readString(folder.resolve(Starter.README));
        assertTrue(readme.contains("me=" + starter.bot()), readme);
        starter.compile().forEach(command -> assertTrue(readme.contains(command), readme));
    }

    @Test
    @Tag("process")
    void theStarterOfTheSearchRaceFinishes() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        Path place = folder.resolve("a bot");
        Cli made = Cli.run("new", "python", place.toString(), "--game", "search-race");
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        assertTrue(made.out().endsWith("  steward match --scene search-race --bot 'me=python3 bot.py'\n"), made.out());
        assertTrue(Files.readString(place.resolve(Starter.README)).contains("me=python3 bot.py"));
        Cli cli = Cli.run("match", "--scene", "search-race", "--bot",
            "me=python3 " + CommandLine.quote(List.of(place.resolve("bot.py").toString())), "--seed", "7", "--json",
            "--time-factor", "30");
        JsonNode me = cli.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), cli.out());
        assertTrue(me.get("score").doubleValue() < 600, cli.out());
    }

    @Test
    @Tag("process")
    void theStarterOfMeanMaxHarvests() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        Path place = folder.resolve("looters");
        Cli made = Cli.run("new", "python", place.toString(), "--game", "mean-max");
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        Cli cli = Cli.run("match", "--scene", "mean-max", "--bot",
            "me=python3 " + CommandLine.quote(List.of(place.resolve("bot.py").toString())), "--bot", "builtin:gatherer",
            "--bot", "builtin:gatherer", "--seed", "7", "--json", "--time-factor", "30");
        JsonNode me = cli.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), cli.out());
        assertTrue(me.get("score").doubleValue() > 0, cli.out());
    }

    @Test
    @Tag("process")
    void theStarterOfFantasticBitsScores() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        Path place = folder.resolve("wizards");
        Cli made = Cli.run("new", "python", place.toString(), "--game", "fantastic-bits");
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        Cli cli = Cli.run("match", "--scene", "fantastic-bits", "--bot",
            "me=python3 " + CommandLine.quote(List.of(place.resolve("bot.py").toString())), "--bot", "builtin:chaser",
            "--seed", "7", "--json", "--time-factor", "30");
        JsonNode me = cli.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), cli.out());
        assertTrue(me.get("score").doubleValue() > 0, cli.out());
    }

    @Test
    @Tag("process")
    void theStarterOfThePokerChipRacePlays() throws IOException {
        assumeTrue(ProgramFinder.find("python3") != null, "there is no python3");
        Path place = folder.resolve("chips");
        Cli made = Cli.run("new", "python", place.toString(), "--game", "poker-chip-race");
        assertEquals(ExitStatus.DONE, made.status(), made.err());
        Cli cli = Cli.run("match", "--scene", "poker-chip-race", "--bot",
            "me=python3 " + CommandLine.quote(List.of(place.resolve("bot.py").toString())), "--bot", "builtin:nibbler",
            "--seed", "7", "--json", "--time-factor", "30");
        JsonNode me = cli.json().get("players").get(0);
        assertTrue(me.get("fault").isNull(), cli.out());
        assertTrue(me.get("score").doubleValue() >= 0, cli.out());
    }

    @Test
    void whatARefusalNamesIsNotRefused() {
        assertEquals("steward: --game: found 'bodies', expected one of pod-race, search-race, mean-max, "
            + "fantastic-bits, poker-chip-race\n",
            Cli.run("new", "python", folder.toString(), "--game", "bodies").err());
        assertEquals("steward: LANGUAGE: found 'rust', expected one of python for search-race\n",
            Cli.run("new", "rust", folder.toString(), "--game", "search-race").err());
        for (String game : NewCommand.GameIds.all()) {
            for (String language : Starter.languages(game)) {
                Cli made = Cli.run("new", language, folder.resolve(game + language).toString(), "--game", game);
                assertEquals(ExitStatus.DONE, made.status(), made.err());
            }
        }
    }

    @Test
    void itSaysWhichProtocolItWritesAndTakesAnother() {
        String usual = Cli.run("new", "python", folder.resolve("usual").toString()).out();
        assertTrue(usual.contains("It speaks JSON."), usual);
        String other = Cli.run("new", "python", folder.resolve("other").toString(), "--protocol", "codingame").out();
        assertTrue(other.contains("It speaks CodinGame's lines.") && other.contains("codingame:python3 bot.py"), other);
        assertEquals("steward: --protocol: found 'json', expected codingame, which the bot in java speaks\n",
            Cli.run("new", "java", folder.resolve("none").toString(), "--protocol", "json").err());
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

    @Test
    void anUnknownLanguageNamesTheNearest() {
        assertEquals("steward: LANGUAGE: found 'pyhton', expected one of python, java, cpp, js; did you mean "
            + "'python'?\n",
            Cli.run("new", "pyhton", folder.toString()).err());
    }

    @Test
    void theStarterOfThisRepositoryIsTheSame() throws IOException {
        assertArrayEquals(Files.readAllBytes(Path.of("src/bots/python/starter.py")),
            Starter.PYTHON.read("pod-race", "bot.py"));
    }
}
