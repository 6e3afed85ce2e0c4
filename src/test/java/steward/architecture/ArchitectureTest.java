package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.architecture.House.Touch;

/**
 * The arrows of the design, and what each room must not know. Every rule is also tried on classes in which it is broken
 * on purpose, so that none can pass by never looking.
 */
@Execution(ExecutionMode.CONCURRENT)
class ArchitectureTest {

    /** Rooms that a turn is computed in. */
    private static final String TURN = "numerics.. physics.. scene.. json.. game..";

    /** Functions whose last bit is up to the machine; sqrt, fma, floor and the like are exact everywhere. */
    private static final String INEXACT = "java.lang.Math#(sin|cos|tan|asin|acos|atan|atan2|exp|expm1|log|log10|log1p"
        + "|pow|cbrt|sinh|cosh|tanh|hypot)";

    private static List<Touch> planted;

    /**
     * Who must not touch what, each a list of names: {@code room..} for all below a room or package, {@code *} for a
     * part of a name, {@code class#member}.
     */
    enum Rule {
        /** Imports point only downward. */
        ARROWS(touch -> touch.target().getPackageName().startsWith("steward")
            && (House.level(touch.origin()) < 0 || House.level(touch.target()) > House.level(touch.origin()))),
        /** The command line lists the games; CodinGame's own file formats are those of particular games. */
        PARTICULAR_GAMES("not cli.. lab.cli.. codingame.. game.*..", "game.*.."),
        /** But for the pod race, which has commands and formats of its own, a game is known by a list alone. */
        LISTED_GAMES("not game.*.. cli.shared.Games", "game.(?!podrace.)*.."),
        /** The group is the game of the one who touches. */
        OTHER_GAMES("(game.*)..", "(?!\\1.)game.*.."),
        /** Rooms that play many games have no say in how they are shown. */
        CONTESTS("contest..", "picocli.. me.tongfei.. java.lang.System#(out|err|in|console)"),
        /**
         * A command has its streams and its end from one object, so that a client of a resident can be at the other
         * end. Excepted are the entry points of the program, the main class of a referee's JVM, and what ends the JVM
         * without memory or writes what all commands have left. Readers of environment and folder may know the process
         * too: a resident has one of each.
         */
        STREAMS("not lab.. cli.streams.. cli.Main cli.ArchiveTraining guest.GuestJvm* cli.shared.OutOfMemory*"
            + " replay.WriteBehind*", "java.lang.System#(out|err|in|console|exit)"
            + " java.lang.Runtime#(exit|halt|addShutdownHook) java.io.FileDescriptor#*"),
        /** A league knows games only through contests: it plays none by itself, and starts no process. */
        LEAGUES("league..", "physics.. bot.process.. game.*.. match.Referee"),
        /** No other command needs the time to load it. */
        SQLITE("not league.store..", "org.sqlite.. java.sql.."),
        /** No other command needs the time to load it. */
        ARTEMIS("not machines.broker..", "org.apache.activemq.. io.netty.."),
        MACHINES("machines..", "physics.. league.rating.."),
        /** Data from other machines is JSON: nothing is made of it by Java itself. */
        SERIALIZATION("machines..", "java.io.Object(Input|Output)Stream*"),
        BOTS("bot..", "game.. scene.. physics.."),
        /** Rooms that measure the physics play no matches. */
        LABS("lab.(oracle|trial|stability|timing|calibration|tradeoff)..", "bot.. match.."),
        /** But for the browser, JVMs that time one kind of turns each, and the JDK's own program that makes keys. */
        PROCESSES("not bot.. live.. lab.timing.. lab.bench.section.. machines.token..",
            "java.lang.ProcessBuilder java.lang.Process"),
        PHYSICS("numerics.. physics..", "java.(io|nio|net|time).. tools.jackson.. com.fasterxml.."),
        CLOCKS(TURN, "java.lang.System#(nanoTime|currentTimeMillis) java.time.."),
        RANDOM(TURN, "java.util.(Random|SplittableRandom|UUID|concurrent.ThreadLocalRandom) java.util.random.."
            + " java.security.. java.lang.Math#random"),
        ANGLES(TURN, INEXACT),
        HASHES("numerics.. physics.. json.. game..", "java.util.(HashMap|HashSet|IdentityHashMap|WeakHashMap|Hashtable)"
            + " java.util.concurrent.Concurrent(HashMap|SkipList*)"),
        PARALLEL(TURN, "java.util..#(parallel|parallelStream|parallelPrefix|parallelSort|parallelSetAll)"),
        STATICS("*..", "changing-static");

        private final Predicate<Touch> isBroken;

        Rule(Predicate<Touch> isBroken) {
            this.isBroken = isBroken;
        }

        Rule(String who, String mustNot) {
            String origin = who.startsWith("not ") ? "(?!" + anyOf(who.substring(4)) + " -> )\\S+" : anyOf(who);
            Predicate<String> text = Pattern.compile(origin + " -> " + anyOf(mustNot)).asMatchPredicate();
            isBroken = touch -> text.test(touch.toString());
        }

        private static String anyOf(String names) {
            return "(?:steward\\.)?(?:" + names.replace("*", "[\\w$]*").replaceAll("\\.(?!\\.)", "\\\\.")
                .replace(".\\.", "\\..*").replace(' ', '|') + ")";
        }

        private List<Touch> violations(List<Touch> touches) {
            return touches.stream().filter(isBroken).toList();
        }
    }

    /** Classes, each with what stands in it and, in a comment, all rules that it breaks. */
    private static final String PLANTED = """
        attic.Forgotten        // ARROWS
        bot.Rules              steward.game.Keeper game;  // BOTS
        cli.Exits              void end() { System.exit(1); }  // STREAMS
        cli.Hooks              void add(Thread end) { Runtime.getRuntime().addShutdownHook(end); }  // STREAMS
        cli.KnowsFish          steward.game.pond.Fish fish;  // LISTED_GAMES
        cli.Lists              steward.game.podrace.Pod pod;
        cli.Starts             ProcessBuilder program() { return new ProcessBuilder("true"); }  // PROCESSES
        cli.shared.Games       steward.game.pond.Fish fish;
        contest.Prints         void tell(String result) { System.out.println(result); }  // CONTESTS STREAMS
        game.Dates             java.time.Instant now() { return java.time.Instant.now(); }  // CLOCKS
        game.Keeper            static int count;  // STATICS
        game.KnowsPods         steward.game.podrace.Pod pod;  // ARROWS PARTICULAR_GAMES
        game.Rolls             double roll(java.util.Random dice) { return dice.nextInt() + Math.random(); }  // RANDOM
        game.podrace.Pod
        game.podrace.Turns     double turn(double y, double x) { return Math.atan2(y, x); }  // ANGLES
        game.pond.Borrows      steward.game.podrace.Pod pod;  // ARROWS OTHER_GAMES
        game.pond.Fish         // ARROWS
        lab.trial.Asks         steward.bot.Rules bot;  // LABS
        league.Pushes          steward.physics.Quiet physics; java.sql.Connection connection;  // LEAGUES SQLITE
        machines.check.Jobs    steward.physics.Quiet physics; java.io.ObjectInputStream in;  // MACHINES SERIALIZATION
        machines.check.Queues  org.apache.activemq.artemis.api.core.client.ClientSession queue;  // ARTEMIS
        match.Keeps            steward.replay.Tape tape;  // ARROWS
        numerics.Sums          int sum(java.util.stream.IntStream all) { return all.parallel().sum(); }  // PARALLEL
        physics.Hashes         Object map() { return new java.util.HashMap<String, String>(); }  // HASHES
        physics.KnowsBots      steward.bot.Rules upward;  // ARROWS
        physics.Parses         tools.jackson.core.json.JsonFactory json;  // PHYSICS
        physics.Quiet
        physics.Reads          boolean read(java.io.File file) { return file.exists(); }  // PHYSICS
        replay.DrawsPods       steward.game.podrace.Pod pod;  // PARTICULAR_GAMES
        replay.Tape
        scene.Times            java.util.function.LongSupplier clock() { return System::nanoTime; }  // CLOCKS
        """;

    @BeforeAll
    static void importPlantedClasses(@TempDir Path folder) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        if (compiler == null) {
            return;
        }
        List<String> call = new ArrayList<>(List.of("-proc:none", "-d", folder.toString(), "-cp",
            System.getProperty("java.class.path")));
        for (String line : PLANTED.lines().toList()) {
            Path source = folder.resolve(nameOf(line) + ".java");
            Files.writeString(source, line.replaceFirst("(\\S+)\\.(\\w+)(.*)",
                "package steward.$1; public class $2 {$3") + "\n}");
            call.add(source.toString());
        }
        assertEquals(0, compiler.run(null, null, null, call.toArray(new String[0])));
        planted = House.touches(new ClassFileImporter().importPath(folder));
    }

    @ParameterizedTest
    @EnumSource
    void theHouseKeepsTheRule(Rule rule) {
        assertEquals(List.of(), rule.violations(House.TOUCHES));
    }

    @ParameterizedTest
    @EnumSource
    void theRuleFindsWhatIsPlanted(Rule rule) {
        assumeTrue(planted != null, "skipped: this Java has no compiler");
        Set<String> broken = PLANTED.lines().filter(line -> line.matches(".*//.*\\b" + rule + "\\b.*"))
            .map(ArchitectureTest::nameOf).collect(Collectors.toSet());
        assertFalse(broken.isEmpty());
        assertEquals(broken, rule.violations(planted).stream().map(touch -> touch.origin().getSimpleName())
            .collect(Collectors.toSet()));
    }

    private static String nameOf(String line) {
        return line.replaceFirst("\\S+\\.(\\w+).*", "$1");
    }
}
