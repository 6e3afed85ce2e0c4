package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.Internal;
import steward.architecture.House.Touch;
import steward.examples.MatchInside;
import steward.examples.SimulatorBot;

/**
 * The arrows of the design, and what each room must not know; rooms, types for users and the map of the tour are those
 * that people read of. Every rule is also tried on touches that break it, so that none can pass by never looking.
 */
@Execution(ExecutionMode.CONCURRENT)
class ArchitectureTest {

    /** Rooms that a turn is computed in. */
    private static final String TURN = "numerics.. physics.. scene.. json.. game..";

    /** Functions whose last bit is up to the machine; sqrt, fma, floor and the like are exact everywhere. */
    private static final String INEXACT = "java.lang.Math#(sin|cos|tan|asin|acos|atan|atan2|exp|expm1|log|log10|log1p"
        + "|pow|cbrt|sinh|cosh|tanh|hypot)";

    /**
     * Who must not touch what, each a list of names, and touches that break the rule. A name is {@code room..} for all
     * below a room or package, {@code *} for a part of a name, {@code class#member}. After {@code not} stand those who
     * may, and all of them do.
     */
    enum Rule {
        /** Imports point only downward. */
        ARROWS("attic.Forgotten -> attic.Forgotten, game.KnowsPods -> game.podrace.Pod, match.Keeps -> replay.Tape,"
            + " physics.KnowsBots -> bot.Rules"),
        /** The command line lists the games; CodinGame's own file formats are those of particular games. */
        PARTICULAR_GAMES("not cli.. lab.cli.. codingame.. game.*..", "game.*..", "replay.Draws -> game.podrace.Pod"),
        /** But for the pod race, which has commands and formats of its own, a game is known by a list alone. */
        LISTED_GAMES("not game.*..", "game.(?!podrace.)*..", "cli.KnowsFish -> game.pond.Fish"),
        /** The group is the game of the one who touches. */
        OTHER_GAMES("(game.*)..", "(?!\\1.)game.*..", "game.pond.Borrows -> game.podrace.Pod"),
        /** Rooms that play many games have no say in how they are shown. */
        CONTESTS("contest..", "picocli.. me.tongfei.. java.lang.System#(out|err|in|console)",
            "contest.Prints -> java.lang.System#out, contest.Parses -> picocli.CommandLine"),
        /**
         * A command has its streams and its end from one object, so that a client of a resident can be at the other
         * end. Excepted are the entry points of the program, the main class of a referee's JVM, and what ends the JVM
         * without memory or writes what all commands have left. Readers of environment and folder may know the process
         * too: a resident has one of each.
         */
        STREAMS("not lab.. cli.streams.. cli.Main cli.ArchiveTraining guest.GuestJvm* cli.shared.OutOfMemory*"
            + " replay.WriteBehind*", "java.lang.System#(out|err|in|console|exit)"
            + " java.lang.Runtime#(exit|halt|addShutdownHook) java.io.FileDescriptor#*",
            "cli.Exits -> java.lang.System#exit, cli.Hooks -> java.lang.Runtime#addShutdownHook"),
        /** A league knows games only through contests: it plays none by itself, and starts no process. */
        LEAGUES("league..", "physics.. bot.process.. game.*.. match.Referee", "league.Pushes -> physics.time.Circles"),
        /** They play one game, attempts at one, games of programs that nobody changes, or many ({@link #WATCHED}). */
        PLAYERS("not cli.check.BotCheck cli.play.RunCommand contest.CountedGame contest.PairedPlay contest.SeriesPlay"
            + " league.play.KeptGames* machines.worker.BotTrial machines.worker.JobPlay", "contest.Contest#play",
            "cli.Plays -> contest.Contest#play"),
        LEAGUE_PLAYERS("not league.play.LeagueRun", "league.play.GamePlay#play",
            "cli.Plays -> league.play.GamePlay#play"),
        /** Programs of bots are watched by all that plays more than one game, and by nothing else. */
        WATCHED("not contest.PairedPlay contest.SeriesPlay league.play.LeagueRun",
            "contest.ProgramWatch#await league.play.RosterWatch#look", "cli.Watches -> contest.ProgramWatch#await"),
        /** No other command needs the time to load it. */
        SQLITE("not league.store..", "org.sqlite.. java.sql..", "league.Asks -> java.sql.Connection"),
        /** No other command needs the time to load it. */
        ARTEMIS("not machines.broker..", "org.apache.activemq.. io.netty..",
            "machines.check.Queues -> org.apache.activemq.artemis.api.core.client.ClientSession"),
        MACHINES("machines..", "physics.. league.rating..", "machines.check.Jobs -> physics.Bodies"),
        /** Data from other machines is JSON: nothing is made of it by Java itself. */
        SERIALIZATION("machines..", "java.io.Object(Input|Output)Stream*",
            "machines.check.Jobs -> java.io.ObjectInputStream"),
        BOTS("bot..", "game.. scene.. physics..", "bot.Rules -> game.Keeper"),
        /** Rooms that measure the physics play no matches. */
        LABS("lab.(oracle|trial|timing|calibration|tradeoff)..", "bot.. match..",
            "lab.trial.Asks -> bot.Bot"),
        /** But for the browser, JVMs that time one kind of turns each, and the JDK's own program that makes keys. */
        PROCESSES("not bot.. live.. lab.timing.. lab.bench.section.. machines.token..",
            "java.lang.ProcessBuilder java.lang.Process", "cli.Starts -> java.lang.ProcessBuilder"),
        PHYSICS("numerics.. physics..", "java.(io|nio|net|time).. tools.jackson.. com.fasterxml..",
            "physics.Parses -> tools.jackson.core.json.JsonFactory, physics.Reads -> java.io.File#exists"),
        CLOCKS(TURN, "java.lang.System#(nanoTime|currentTimeMillis) java.time..",
            "game.Dates -> java.time.Instant, scene.Times -> java.lang.System#nanoTime"),
        RANDOM(TURN, "java.util.(Random|SplittableRandom|UUID|concurrent.ThreadLocalRandom) java.util.random.."
            + " java.security.. java.lang.Math#random", "game.Rolls -> java.util.Random, game.Rolls -> "
            + "java.lang.Math#random"),
        ANGLES(TURN, INEXACT, "game.podrace.Turns -> java.lang.Math#atan2"),
        HASHES("numerics.. physics.. json.. game..", "java.util.(HashMap|HashSet|IdentityHashMap|WeakHashMap|Hashtable)"
            + " java.util.concurrent.Concurrent(HashMap|SkipList*)", "physics.Hashes -> java.util.HashMap"),
        PARALLEL(TURN, "java.util..#(parallel|parallelStream|parallelPrefix|parallelSort|parallelSetAll)",
            "numerics.Sums -> java.util.stream.IntStream#parallel"),
        STATICS("*..", "changing-static", "game.Keeper -> changing-static");

        private final Predicate<Touch> isBroken;
        private final String planted;
        private final List<Pattern> excepted;

        Rule(String planted) {
            isBroken = touch -> House.level(touch.origin()) < 0
                || House.level(touch.target()) > House.level(touch.origin());
            this.planted = planted;
            excepted = List.of();
        }

        Rule(String who, String mustNot, String planted) {
            String[] may = who.startsWith("not ") ? who.substring(4).split(" ") : new String[0];
            String origin = may.length == 0 ? anyOf(who) : "(?!" + anyOf(String.join(" ", may)) + " -> )\\S+";
            Pattern broken = Pattern.compile(origin + " -> " + anyOf(mustNot));
            isBroken = touch -> broken.matcher(touch.toString()).matches();
            this.planted = planted;
            excepted = Stream.of(may).map(each -> Pattern.compile(anyOf(each) + " -> " + anyOf(mustNot))).toList();
        }

        private static String anyOf(String names) {
            return "(?:steward\\.)?(?:" + names.replace("*", "[\\w$]*").replaceAll("\\.(?!\\.)", "\\\\.")
                .replace(".\\.", "\\..*").replace(' ', '|') + ")";
        }
    }

    @ParameterizedTest
    @EnumSource
    void theHouseKeepsTheRule(Rule rule) {
        assertEquals(List.of(), House.TOUCHES.stream().filter(rule.isBroken).toList());
        assertEquals(List.of(), rule.excepted.stream().filter(each -> House.TOUCHES.stream().map(Touch::toString)
            .noneMatch(each.asMatchPredicate())).toList());
    }

    @ParameterizedTest
    @EnumSource
    void theRuleFindsWhatIsPlanted(Rule rule) {
        List<Touch> planted = Stream.of(rule.planted.split(", ")).map(each -> each.split(" -> "))
            .map(ends -> new Touch(ends[0], ends[1])).toList();
        assertEquals(planted, planted.stream().filter(rule.isBroken).toList());
    }

    /** A field that is there to be seen. */
    private static int changing;

    @Test
    void touchesOfEveryKindAreSeen() {
        List<String> seen = House.touches(new ClassFileImporter().importClasses(ArchitectureTest.class)).stream()
            .map(Touch::target).map(name -> name.replaceFirst(".*\\.", "")).toList();
        assertTrue(seen.containsAll(List.of("changing-static", "House", "House#TOUCHES", "House#touches",
            "House$Touch#target")), seen::toString);
    }

    /** Types for users, the last column of docs/api.md. */
    private final Set<String> listed = House.rows(SourceText.of("docs/api.md")).stream()
        .flatMap(row -> House.quoted(row.replaceFirst(".*\\|(?=.+\\|$)", "")).stream()
            .map(name -> House.quoted(row).get(0) + "." + name)).collect(Collectors.toCollection(TreeSet::new));

    @Test
    void typesForUsersAreThere() {
        assertTrue(listed.size() > 40, "the page is read");
        House.CLASSES.stream().filter(type -> type.isTopLevelClass() && isReachable(type)).map(JavaClass::getName)
            .forEach(listed::remove);
        assertEquals(Set.of(), listed);
    }

    /** A signature of a listed type names only listed types, unless the method is marked. */
    @Test
    void whatIsListedNeedsNothingElse() {
        assertEquals(Set.of(), namesBeyond());
        listed.remove("steward.scene.Plan");
        assertTrue(namesBeyond().contains("steward.game.GameSetup: steward.scene.Plan"), "it can fail");
    }

    private Set<String> namesBeyond() {
        return House.CLASSES.stream().filter(this::isListed).flatMap(type -> Stream.concat(
            Stream.concat(type.getSuperclass().stream(), type.getInterfaces().stream())
                .map(JavaType::getAllInvolvedRawTypes),
            type.getMembers().stream().filter(ArchitectureTest::isReachable).flatMap(member -> Stream.of(
                member.getAllInvolvedRawTypes(), member instanceof JavaCodeUnit unit
                    ? Set.copyOf(unit.getExceptionTypes()) : Set.<JavaClass>of())))
            .flatMap(Set::stream).map(JavaClass::getBaseComponentType)
            .filter(named -> named.getPackageName().startsWith("steward") && !isListed(named))
            .map(named -> type.getName() + ": " + named.getName())).collect(Collectors.toSet());
    }

    private boolean isListed(JavaClass type) {
        return listed.contains(House.outermost(type.getName())) && isReachable(type);
    }

    private static boolean isReachable(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC)
            && type.getEnclosingClass().map(ArchitectureTest::isReachable).orElse(true);
    }

    private static boolean isReachable(JavaMember member) {
        Set<JavaModifier> modifiers = member.getModifiers();
        return !Collections.disjoint(modifiers, Set.of(JavaModifier.PUBLIC, JavaModifier.PROTECTED))
            && Collections.disjoint(modifiers, Set.of(JavaModifier.SYNTHETIC, JavaModifier.BRIDGE))
            && !member.isAnnotatedWith(Internal.class);
    }

    @Test
    void examplesUseOnlyWhatIsListed() {
        listed.remove("steward.match.Referee");
        assertEquals(Set.of("steward.match.Referee"), House.touches(new ClassFileImporter()
            .importClasses(SimulatorBot.class, MatchInside.class)).stream()
            .map(touch -> House.outermost(touch.target()))
            .filter(name -> name.matches("steward\\.(?!examples\\.).*") && !listed.contains(name))
            .collect(Collectors.toSet()), "the one that is taken off the list, and no other");
    }

    @Test
    void everyRoomThatExistsIsListedOnce() {
        Set<String> rooms = House.CLASSES.stream().map(type -> House.room(type.getName())).collect(Collectors.toSet());
        assertEquals(rooms.stream().sorted().toList(), House.ROOMS.stream().sorted().toList());
    }

    @Test
    void noNameIsTakenTwice() {
        List<String> names = House.CLASSES.stream().filter(JavaClass::isTopLevelClass).map(JavaClass::getSimpleName)
            .filter(name -> !name.equals("package-info")).toList();
        assertEquals(List.of(), names.stream().filter(name -> Collections.frequency(names, name) > 1).toList());
    }

    @Test
    void theMapIsThatOfTheCodeAndEachWayIsShort() {
        String page = SourceText.of(House.TOUR.toString());
        assertEquals(House.withMap(page), page, "./gradlew house draws it anew");
        assertEquals(3, page.split("\n\\| 1 \\| \\[`").length - 1, "ways: a match, a league, a worker");
        assertEquals(1, page.split("\n\\| 9 \\| \\[`").length, "no way has more than 8 files");
    }

    /** Sizes of all parts, though tests have pictures and packed files. */
    @Test
    void houseTellsTheSizeOfEachPart() {
        String sizes = String.join("\n", House.sizes());
        assertTrue(sizes.matches("engine .*\nmain .*\nlab .*\nengineTest .*\ntest .*\nlabTest .*"), sizes);
        assertTrue(House.sizes().stream().allMatch(line -> line.matches("\\w+ +[1-9]\\d{3,} lines .*")), sizes);
    }
}
