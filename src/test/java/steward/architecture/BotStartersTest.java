package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import java.io.OutputStream;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import steward.cli.Main;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.ProgramWatch;

/** Everything that starts bots is known, and what plays more than one game watches their programs. */
class BotStartersTest {

    /** Number of games that a caller of {@link Contest#play} plays. */
    private enum Games {
        /** One, or attempts at one. */
        ONE,
        /** Many, watched by a {@link ProgramWatch}. */
        WATCHED,
        /** Many; whoever calls it watches. */
        BY_ITS_CALLERS,
        /** Of programs that nobody changes: unpacked from a bundle, or the workshop's own. */
        OWN
    }

    private static final Map<String, Games> PLAYERS = new TreeMap<>(Map.ofEntries(
        Map.entry("steward.cli.check.BotCheck", Games.ONE),
        Map.entry("steward.cli.play.RunCommand", Games.ONE),
        Map.entry("steward.contest.CountedGame", Games.ONE),
        Map.entry("steward.contest.PairedPlay", Games.WATCHED),
        Map.entry("steward.contest.SeriesPlay", Games.WATCHED),
        Map.entry("steward.league.play.KeptGames", Games.BY_ITS_CALLERS),
        Map.entry("steward.machines.worker.BotTrial", Games.OWN),
        Map.entry("steward.machines.worker.JobPlay", Games.OWN)));

    private static Set<String> callersOf(Class<?> type, String method) {
        return HouseClasses.all().stream().filter(each -> !each.getPackageName().startsWith("steward.lab"))
            .filter(each -> each.getAccessesFromSelf().stream().anyMatch(access -> isOf(access, type, method))
                || each.getMethodReferencesFromSelf().stream().anyMatch(access -> isOf(access, type, method)))
            .map(each -> outermost(each).getName()).collect(Collectors.toCollection(TreeSet::new));
    }

    private static boolean isOf(JavaAccess<?> access, Class<?> type, String method) {
        return access.getTargetOwner().isEquivalentTo(type) && access.getName().equals(method);
    }

    private static JavaClass outermost(JavaClass type) {
        return type.getEnclosingClass().map(BotStartersTest::outermost).orElse(type);
    }

    private static boolean watches(String name) {
        return HouseClasses.all().get(name).getDirectDependenciesFromSelf().stream().anyMatch(each ->
            each.getTargetClass().isEquivalentTo(ProgramWatch.class)
                || each.getTargetClass().getName().equals("steward.league.play.RosterWatch"));
    }

    @Test
    void everythingThatPlaysIsKnown() {
        assertEquals(PLAYERS.keySet(), callersOf(Contest.class, "play"));
    }

    @Test
    void whatPlaysManyGamesWatchesThePrograms() {
        PLAYERS.forEach((player, games) -> assertEquals(games == Games.WATCHED, watches(player), player));
        Set<String> leagues = callersOf(HouseClasses.all().get("steward.league.play.GamePlay").reflect(), "play");
        assertEquals(Set.of("steward.league.play.LeagueRun"), leagues);
        leagues.forEach(each -> assertTrue(watches(each), each));
    }

    /** Sorts commands that take bots by whether they have an option, too. */
    private static void addWithBots(CommandLine command, String option, Set<String> with, Set<String> without) {
        boolean bots = command.getCommandSpec().options().stream().anyMatch(each -> each.longestName()
            .equals("--bot")) || command.getCommandSpec().positionalParameters().stream().anyMatch(parameter ->
                parameter.paramLabel().equals("BOT") || parameter.paramLabel().equals("COMMAND"));
        if (bots) {
            (command.getCommandSpec().findOption(option) == null ? without : with).add(command.getCommandName());
        }
        command.getSubcommands().values().forEach(each -> addWithBots(each, option, with, without));
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
        Set<String> with = new TreeSet<>();
        Set<String> without = new TreeSet<>();
        CommandLine program = Main.program(new Streams(OutputStream.nullOutputStream(),
            OutputStream.nullOutputStream(), false, false), null);
        addWithBots(program, option, with, without);
        assertEquals(having, String.join(" ", with));
        assertEquals(lacking, String.join(" ", without));
        program.getSubcommands().forEach((name, command) -> assertEquals(
            command.getCommandSpec().findOption("--time-factor") != null,
            command.getCommandSpec().findOption("--time-limit") != null, name));
    }
}
