package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
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

    @BeforeAll
    static void importClasses() {
        main = HouseClasses.all();
        planted = new ClassFileImporter().importPackages("steward.architecture.fixture");
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
        for (String violation : rule.violations("steward.architecture.fixture", planted)) {
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
    void everyRoomSaysWhatItIsFor() throws IOException {
        for (Path sources : HouseClasses.sources()) {
            assertEquals(List.of(), roomsWithoutInfo(sources));
        }
        assertTrue(roomsWithoutInfo(Path.of("src/test/java")).contains("steward/architecture"), "it can fail");
    }

    private static List<String> roomsWithoutInfo(Path sources) throws IOException {
        List<String> rooms = new ArrayList<>();
        try (Stream<Path> folders = Files.walk(sources)) {
            for (Path folder : folders.filter(Files::isDirectory).sorted().toList()) {
                try (Stream<Path> files = Files.list(folder)) {
                    boolean hasTypes = files.anyMatch(file -> file.toString().endsWith(".java"));
                    if (hasTypes && !Files.exists(folder.resolve("package-info.java"))) {
                        rooms.add(sources.relativize(folder).toString());
                    }
                }
            }
        }
        return rooms;
    }
}
