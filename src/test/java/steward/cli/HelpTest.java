package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import steward.cli.streams.Streams;

/** The help of every command: it fits a terminal of 80 columns, and is phrased alike. */
@Execution(ExecutionMode.CONCURRENT)
class HelpTest {

    /** Options that are said to do something use the third person ("Writes"); these begin the others. */
    private static final Set<String> OTHER_BEGINNINGS = Set.of("The", "A", "Which", "Where", "What", "How", "Up",
        "Only", "With", "Few", "Instead:", "seed=N:", "In", "On", "Also", "Player", "Accepted");

    private static final int MOST_WORDS = 35;

    static List<String> commands() {
        return Main.commands();
    }

    /** Returns the options and parameters of one command. */
    static CommandSpec specOf(String command) {
        return Main.program(Streams.standard(), command).getSubcommands().get(command).getCommandSpec();
    }

    /** All commands, also those of 'league'. */
    static List<String> all() {
        return Stream.concat(commands().stream(), specOf("league").subcommands().keySet().stream()
            .map(name -> "league " + name)).toList();
    }

    /** Sentences of a text that are too long; lists of fields and what is indented are not sentences. */
    private static List<String> tooLong(List<String> lines) {
        List<String> found = new ArrayList<>();
        StringBuilder text = new StringBuilder();
        for (String line : lines) {
            text.append(line.isBlank() || line.startsWith("  ") ? "\n" : line + " ");
        }
        for (String sentence : text.toString().split("(?<=[.;!?])\\s|\n")) {
            if (sentence.split("\\s+").length > MOST_WORDS && !sentence.matches("(?:--json|[Ww]ith --).*:.*")) {
                found.add(sentence);
            }
        }
        return found;
    }

    private static CommandSpec spec(String command) {
        String[] words = command.split(" ");
        CommandSpec spec = specOf(words[0]);
        return words.length == 1 ? spec : spec.subcommands().get(words[1]).getCommandSpec();
    }

    @Test
    void sentencesAreShort() {
        Map<String, List<String>> wrong = new TreeMap<>();
        for (String command : all()) {
            CommandSpec spec = spec(command);
            List<String> found = new ArrayList<>(tooLong(List.of(spec.usageMessage().description())));
            found.addAll(tooLong(List.of(spec.usageMessage().footer())));
            spec.args().forEach(each -> found.addAll(tooLong(List.of(each.description()))));
            if (!found.isEmpty()) {
                wrong.put(command, found);
            }
        }
        assertEquals(Map.of(), wrong);
        String word = "word ";
        assertEquals(List.of(), tooLong(List.of(word.repeat(MOST_WORDS - 1) + "end.", "Next.")));
        assertEquals(1, tooLong(List.of("One.", word.repeat(MOST_WORDS), "end.")).size());
    }

    @ParameterizedTest
    @MethodSource("all")
    void everyLineFitsEightyColumns(String command) {
        Cli help = Cli.run((command + " --help").split(" ")).done();
        assertEquals(List.of(), help.out().lines().filter(line -> line.length() > 80).toList());
        assertTrue(help.out().contains("Usage: steward " + command), help.out());
        int example = help.out().indexOf("\nExample");
        assertTrue(example > 0 && help.out().indexOf("steward " + command, example) > 0, help.out());
    }

    @Test
    void theListOfCommandsFitsToo() {
        assertEquals(List.of(), Cli.run().out().lines().filter(line -> line.length() > 80).toList());
    }

    /** The short options of 'referee' are fixed by the tools that call it. */
    @ParameterizedTest
    @MethodSource("commands")
    @ValueSource(strings = {"league run", "league sprt", "league table", "league games", "league worker"})
    void longListsOfOptionsHaveHeadings(String command) {
        List<String> plain = Cli.run((command + " --help").split(" ")).out().lines()
            .takeWhile(line -> !line.endsWith(":"))
            .filter(line -> line.matches(" +-.*") && !line.matches(" +-[hV], .*")).toList();
        assertTrue(plain.size() <= 12 || command.equals("referee"), () -> String.join("\n", plain));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void optionsAreDescribedInTheThirdPerson(String command) {
        List<String> wrong = new ArrayList<>();
        for (OptionSpec option : specOf(command).options().stream().filter(each -> !each.hidden()).toList()) {
            String first = String.join(" ", option.description()).split(" ")[0].replaceAll("[,.]$", "");
            if (!first.isEmpty() && !first.endsWith("s") && !OTHER_BEGINNINGS.contains(first)) {
                wrong.add(option.longestName() + ": " + first);
            }
        }
        assertEquals(List.of(), wrong);
        String about = String.join(" ", specOf(command).usageMessage().description());
        assertTrue(about.split("[ ,]")[0].endsWith("s"), about);
    }

    /**
     * The folder of a bot and its deadlines. Without a folder are commands that other tools call with programs of
     * theirs, and those whose words are names of a league's bots; deadlines of a league stand with its bots, and feed
     * has none.
     */
    @ParameterizedTest
    @CsvSource({"--in, add check feed match seeds sprt tune, games help play prune",
        "--time-limit, add check match play seeds sprt tune, feed games help prune"})
    void whatTakesABotTakesWhatBelongsToOne(String option, String having, String lacking) {
        assertEquals(Map.of(true, having, false, lacking), all().stream().map(HelpTest::spec).filter(spec ->
            spec.findOption("--bot") != null || spec.positionalParameters().stream()
                .anyMatch(each -> each.paramLabel().matches("BOT|COMMAND")))
            .sorted(Comparator.comparing(CommandSpec::name))
            .collect(Collectors.partitioningBy(spec -> spec.findOption(option) != null,
                Collectors.mapping(CommandSpec::name, Collectors.joining(" ")))));
        assertEquals(List.of(), commands().stream().map(HelpTest::spec).filter(spec ->
            (spec.findOption("--time-factor") == null) != (spec.findOption("--time-limit") == null)).toList());
    }

    @Test
    void footersAreNotBrokenInTheMiddleOfALine() {
        CommandSpec whole = Main.program(Streams.standard(), null).getCommandSpec();
        assertEquals(List.of(), Stream.concat(Stream.of(whole), all().stream().map(HelpTest::spec))
            .flatMap(spec -> Stream.of(spec.usageMessage().footer()))
            .filter(line -> line.replace("%%", "%").length() > 80).toList());
    }

    @Test
    @Tag("slow")
    void helpIsACommandToo() {
        assertEquals(Cli.run("--help").out(), Cli.run("help").out());
        assertEquals(Cli.run("match", "--help").out(), Cli.run("help", "match").out());
        assertEquals(Cli.run("league", "run", "--help").out(), Cli.run("help", "league", "run").out());
        assertTrue(Cli.run("match", "--help").out().contains("\n  -b, --bot=BOT "));
        assertFalse(Cli.run("referee", "--help").out().contains("-s, --scene"), "its -s is another option");
        Cli sandbox = Cli.run("help", "sandbox").done();
        assertTrue(sandbox.out().contains("\n      --memory=SIZE "), sandbox.out());
        assertEquals(List.of(), sandbox.out().lines().filter(line -> line.length() > 80).toList());
        String tune = Cli.run("tune", "--help").out();
        assertTrue(tune.indexOf(" --against=") < tune.indexOf(" --accuracy="), "what has to be given stands first");
        assertTrue(tune.indexOf("The search:") < tune.indexOf(" -g, --games="), tune);
    }
}
