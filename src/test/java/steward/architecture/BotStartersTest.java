package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine.Model.CommandSpec;
import steward.cli.Main;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.ProgramWatch;

/** Everything that starts bots is known, and what plays more than one game watches their programs. */
class BotStartersTest {

    /**
     * Callers of {@link Contest#play}, and how many games they play: one, or attempts at one; many, watched by a
     * {@link ProgramWatch}; many, watched by whoever calls them; many of programs that nobody changes, since they are
     * unpacked from a bundle or the workshop's own.
     */
    private static final Map<String, String> PLAYERS = new TreeMap<>(Map.of(
        "steward.cli.check.BotCheck", "one",
        "steward.cli.play.RunCommand", "one",
        "steward.contest.CountedGame", "one",
        "steward.contest.PairedPlay", "watched",
        "steward.contest.SeriesPlay", "watched",
        "steward.league.play.KeptGames", "by its callers",
        "steward.machines.worker.BotTrial", "own",
        "steward.machines.worker.JobPlay", "own"));

    private static Stream<House.Touch> touching(String... names) {
        return House.TOUCHES.stream().filter(touch -> List.of(names).contains(touch.name()));
    }

    private static Set<String> callersOf(String member) {
        return touching(member).map(touch -> House.outermost(touch.origin()))
            .filter(type -> !type.getPackageName().startsWith("steward.lab")).map(JavaClass::getName)
            .collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void everythingThatPlaysIsKnown() {
        assertEquals(PLAYERS.keySet(), callersOf("steward.contest.Contest#play"));
    }

    @Test
    void whatPlaysManyGamesWatchesThePrograms() {
        Set<String> watching = touching(ProgramWatch.class.getName(), "steward.league.play.RosterWatch")
            .map(touch -> touch.origin().getName()).collect(Collectors.toSet());
        PLAYERS.forEach((player, games) ->
            assertEquals(games.equals("watched"), watching.contains(player), player));
        assertEquals(Set.of("steward.league.play.LeagueRun"), callersOf("steward.league.play.GamePlay#play"));
        assertTrue(watching.contains("steward.league.play.LeagueRun"));
    }

    private static Stream<CommandSpec> commands(CommandSpec command) {
        return Stream.concat(Stream.of(command), command.subcommands().values().stream()
            .flatMap(each -> commands(each.getCommandSpec())));
    }

    private static boolean takesBots(CommandSpec command) {
        return command.findOption("--bot") != null || command.positionalParameters().stream()
            .anyMatch(parameter -> Set.of("BOT", "COMMAND").contains(parameter.paramLabel()));
    }

    /**
     * The folder of a bot and its deadlines. Without a folder are commands that other tools call with programs of
     * theirs, and those whose words are names of a league's bots; deadlines of a league stand with its bots, and feed
     * has none.
     */
    @ParameterizedTest
    @CsvSource({"--in, add check feed match seeds sprt tune, games help play prune",
        "--time-limit, add check match play seeds sprt tune, feed games help prune"})
    void everyCommandThatTakesABotTakesWhatBelongsToOne(String option, String having, String lacking) {
        CommandSpec program = Main.program(Streams.standard(), null).getCommandSpec();
        Map<Boolean, String> names = commands(program).filter(BotStartersTest::takesBots)
            .sorted(Comparator.comparing(CommandSpec::name))
            .collect(Collectors.partitioningBy(command -> command.findOption(option) != null,
                Collectors.mapping(CommandSpec::name, Collectors.joining(" "))));
        assertEquals(Map.of(true, having, false, lacking), names);
        program.subcommands().forEach((name, command) -> assertEquals(
            command.getCommandSpec().findOption("--time-factor") != null,
            command.getCommandSpec().findOption("--time-limit") != null, name));
    }
}
