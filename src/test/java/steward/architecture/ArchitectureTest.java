package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Holds the arrows of the design. Every rule is also tried on a small house in which it is broken on purpose, so that
 * none can pass by never looking.
 */
@Execution(ExecutionMode.CONCURRENT)
class ArchitectureTest {

    private static JavaClasses main;
    private static JavaClasses planted;

    /** Every rule, and the planted classes that it must find: all of them and no others. */
    enum Rule {
        ARROWS(House::arrows, "KnowsBots", "KnowsPods", "Keeps", "Forgotten", "Borrows", "Fish"),
        PARTICULAR_GAMES(House::fewRoomsKnowParticularGames, "KnowsPods", "DrawsPods"),
        LISTED_GAMES(House::onlyTheListKnowsTheOtherGames, "KnowsFish"),
        OTHER_GAMES(House::gamesDoNotKnowEachOther, "Borrows"),
        CONTESTS(House::contestsKnowNoTerminal, "Prints"),
        STREAMS(House::onlyTheStreamsKnowTheProcess, "Prints", "Exits", "Hooks"),
        LEAGUES(House::leaguesKnowGamesThroughContests, "Pushes"),
        SQLITE(House::onlyTheStoreKnowsSqlite, "Pushes"),
        ARTEMIS(House::onlyTheBrokerKnowsArtemis, "Queues"),
        MACHINES(House::machinesKnowNoPhysicsAndNoRatings, "Jobs"),
        SERIALIZATION(House::machinesDoNotDeserialize, "Jobs"),
        BOTS(House::botsKnowNoRules, "Rules"),
        LABS(House::labsKnowNoBots, "Asks"),
        PROCESSES(House::onlyBotsAreProcesses, "Starts"),
        PHYSICS(House::physicsKnowsNoFilesAndNoJson, "Reads", "Parses"),
        CLOCKS(House::noClockInAGame, "Times", "Dates"),
        RANDOM(House::noRandomNumbersOfTheJdk, "Rolls"),
        ANGLES(House::anglesAreStrict, "Turns"),
        HASHES(House::noHashOrder, "Hashes"),
        PARALLEL(House::noParallelSums, "Sums"),
        STATICS(House::staticsDoNotChange, "Keeper");

        private final Function<House, ArchRule> rule;
        private final List<String> broken;

        Rule(Function<House, ArchRule> rule, String... broken) {
            this.rule = rule;
            this.broken = List.of(broken);
        }

        private List<String> violations(String root, JavaClasses classes) {
            return rule.apply(new House(root)).evaluate(classes).getFailureReport().getDetails();
        }
    }

    /** Each line is a class and what stands in it; all that breaks a rule is listed there. */
    private static final String PLANTED = """
        attic.Forgotten
        bot.Rules               ROOT.game.Keeper game;
        cli.Exits               void end() { System.exit(1); }
        cli.Hooks               void add(Thread hook) { Runtime.getRuntime().addShutdownHook(hook); }
        cli.KnowsFish           ROOT.game.pond.Fish fish;
        cli.Lists               ROOT.game.podrace.Pod pod;
        cli.Starts              ProcessBuilder program() { return new ProcessBuilder("true"); }
        cli.shared.Games        ROOT.game.pond.Fish fish;
        contest.Prints          void tell(String result) { System.out.println(result); }
        game.Dates              java.time.Instant now() { return java.time.Instant.now(); }
        game.Keeper             static int count;
        game.KnowsPods          ROOT.game.podrace.Pod pod;
        game.Rolls              double roll(java.util.Random random) { return random.nextDouble() + Math.random(); }
        game.podrace.Pod
        game.podrace.Turns      double turn(double y, double x) { return Math.atan2(y, x); }
        game.pond.Borrows       ROOT.game.podrace.Pod pod;
        game.pond.Fish
        lab.trial.Asks          ROOT.bot.Rules bot;
        league.Pushes           ROOT.physics.Quiet physics; java.sql.Connection connection;
        machines.check.Jobs     ROOT.physics.Quiet physics; java.io.ObjectInputStream in;
        machines.check.Queues   org.apache.activemq.artemis.api.core.client.ClientSession session;
        match.Keeps             ROOT.replay.Tape tape;
        numerics.Sums           double sum(double[] all) { return java.util.Arrays.stream(all).parallel().sum(); }
        physics.Hashes          Object map() { return new java.util.HashMap<String, String>(); }
        physics.KnowsBots       ROOT.bot.Rules upward;
        physics.Parses          tools.jackson.core.json.JsonFactory json;
        physics.Quiet
        physics.Reads           boolean read(java.io.File file) { return file.exists(); }
        replay.DrawsPods        ROOT.game.podrace.Pod pod;
        replay.Tape
        scene.Times             long now() { return System.nanoTime(); }
        """;
    private static final String ROOT = "planted";

    @BeforeAll
    static void importClasses(@TempDir Path folder) throws IOException {
        main = HouseClasses.all();
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assumeTrue(compiler != null, "skipped: this Java has no compiler");
        List<String> call = new ArrayList<>(List.of("-proc:none", "-d", folder.toString(), "-cp",
            System.getProperty("java.class.path")));
        for (String line : PLANTED.lines().toList()) {
            String[] parts = line.replace("ROOT", ROOT).split(" +", 2);
            int room = parts[0].lastIndexOf('.');
            Path source = folder.resolve(parts[0].substring(room + 1) + ".java");
            Files.writeString(source, "package " + ROOT + "." + parts[0].substring(0, room) + "; public class "
                + parts[0].substring(room + 1) + " { " + (parts.length > 1 ? parts[1] : "") + " }");
            call.add(source.toString());
        }
        assertEquals(0, compiler.run(null, null, null, call.toArray(new String[0])));
        planted = new ClassFileImporter().importPath(folder);
    }

    @ParameterizedTest
    @EnumSource
    void theHouseKeepsTheRule(Rule rule) {
        assertEquals(List.of(), rule.violations("steward", main));
    }

    @ParameterizedTest
    @EnumSource
    void theRuleFindsWhatIsPlanted(Rule rule) {
        TreeSet<String> found = new TreeSet<>();
        for (String violation : rule.violations(ROOT, planted)) {
            // The first class that a violation names is the one that is at fault.
            planted.stream().filter(type -> violation.matches("(?s)\\W*(\\w+ <)?" + Pattern.quote(type.getName())
                + "\\b.*")).forEach(type -> found.add(type.getSimpleName()));
        }

        assertEquals(new TreeSet<>(rule.broken), found);
    }

    @Test
    void everyRoomThatExistsIsLookedAt() {
        TreeSet<String> rooms = new TreeSet<>();
        main.forEach(type -> rooms.add(type.getPackageName().replaceFirst("^steward\\.?", "")));

        assertEquals(new TreeSet<>(House.ROOMS), rooms);
    }

    @Test
    void everyRoomSaysWhatItIsFor() {
        assertEquals(Set.of(), roomsWithoutInfo(SourceText.main()));
        assertTrue(roomsWithoutInfo(SourceText.below("src/test/java")).contains("src/test/java/steward/architecture"));
    }

    private static Set<String> roomsWithoutInfo(Map<String, String> sources) {
        return sources.keySet().stream().map(file -> file.substring(0, file.lastIndexOf('/')))
            .filter(room -> !sources.containsKey(room + "/package-info.java")).collect(Collectors.toSet());
    }
}
