package steward.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.List;
import java.util.Set;
import java.util.function.BiPredicate;

/**
 * The rules of the architecture, for a house with a given root package: the rooms, lowest first, which may only look
 * downward, and what each must not know.
 */
final class House {

    /** Lowest first; the root package itself, which holds only what marks the others, is the lowest of all. */
    static final List<String> ROOMS = List.of("", "numerics", "text",
        "physics", "physics.time", "physics.impulse", "physics.event.flight", "physics.event.pairs",
        "physics.event.cells", "physics.event",
        "scene.json", "scene",
        "json", "game", "game.bodies", "game.bodies.protocol", "game.fantasticbits", "game.fantasticbits.protocol",
        "game.meanmax", "game.meanmax.protocol", "game.podrace", "game.podrace.simulator", "game.podrace.protocol",
        "game.pokerchiprace", "game.pokerchiprace.protocol", "game.searchrace", "game.searchrace.protocol",
        "files", "bot", "bot.command", "bot.accounting", "bot.hold", "bot.isolation", "bot.process", "match",
        "guest.project", "guest", "replay.sign", "replay", "replay.verify", "replay.feed", "replay.page",
        "contest.repeat", "contest.seeds", "contest.loss", "contest", "live",
        "codingame.recording", "codingame",
        "league", "league.rating", "league.sequential", "league.pairing",
        "league.tune", "league.store", "league.play", "league.page",
        "machines.check", "machines.token", "machines.wire", "machines.bundle", "machines.broker",
        "machines.serve", "machines.worker",
        "cli.streams", "cli.shared", "cli.options", "cli.explain", "cli.replay", "cli.play", "cli.sequential",
        "cli.check", "cli.league.view", "cli.league.run", "cli.league", "cli.tournament", "cli.resident",
        "cli.machines", "cli.setup", "cli",
        "lab.chart", "lab.oracle", "lab.trial", "lab.stability.pairs", "lab.stability.crowds", "lab.stability.bodies",
        "lab.stability",
        "lab.timing", "lab.calibration", "lab.tradeoff", "lab.tradeoff.report",
        "lab.bench", "lab.bench.section",
        "lab.cli.bench", "lab.cli");

    /** The game for which there are commands and formats of its own. */
    private static final String FIRST_GAME = "podrace";

    /** Functions whose last bit is up to the machine; sqrt, fma, floor and the like are exact everywhere. */
    private static final Set<String> INEXACT = Set.of("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp",
        "expm1", "log", "log10", "log1p", "pow", "cbrt", "sinh", "cosh", "tanh", "hypot");

    private static final Set<String> CLOCKS = Set.of("nanoTime", "currentTimeMillis");
    private static final Set<String> PARALLEL = Set.of("parallel", "parallelStream", "parallelPrefix", "parallelSort",
        "parallelSetAll");

    private final String root;

    House(String root) {
        this.root = root;
    }

    private String in(String room) {
        return root + "." + room + "..";
    }

    /** The rooms that a turn is computed in. */
    private DescribedPredicate<JavaClass> deterministicRooms() {
        return resideInAnyPackage(in("numerics"), in("physics"), in("scene"), in("json"), in("game"));
    }

    /** Imports point only downward. */
    ArchRule arrows() {
        return classes().that().resideInAPackage(root + "..").should(dependOnlyWhere("only look downward",
            (origin, target) -> level(origin) >= 0 && level(target) <= level(origin)));
    }

    /** A condition on a class and each class of the house that it depends on; the class itself is one of them. */
    private ArchCondition<JavaClass> dependOnlyWhere(String words, BiPredicate<JavaClass, JavaClass> may) {
        return new ArchCondition<>(words) {
            @Override
            public void check(JavaClass origin, ConditionEvents events) {
                if (!may.test(origin, origin)) {
                    events.add(SimpleConditionEvent.violated(origin, origin.getName() + " does not " + words));
                }
                for (Dependency dependency : origin.getDirectDependenciesFromSelf()) {
                    JavaClass target = dependency.getTargetClass().getBaseComponentType();
                    if (target.getPackageName().startsWith(root + ".") && !may.test(origin, target)) {
                        events.add(SimpleConditionEvent.violated(origin, dependency.getDescription()));
                    }
                }
            }
        };
    }

    private int level(JavaClass type) {
        String name = type.getPackageName();
        return ROOMS.indexOf(name.length() <= root.length() ? "" : name.substring(root.length() + 1));
    }

    /** The command line lists the games; CodinGame's own file formats are those of particular games. */
    ArchRule fewRoomsKnowParticularGames() {
        return noClasses().that().resideOutsideOfPackages(in("cli"), in("lab.cli"), in("codingame"), in("game.*"))
            .should().dependOnClassesThat().resideInAPackage(in("game.*"));
    }

    /** But for the pod race, which commands and formats of its own are made for, a game is known by a list alone. */
    ArchRule onlyTheListKnowsTheOtherGames() {
        return classes().that().resideOutsideOfPackage(in("game.*")).should(dependOnlyWhere("know no such game",
            (origin, target) -> origin.getName().equals(root + ".cli.shared.Games")
                || Set.of("", FIRST_GAME).contains(gameOf(target))));
    }

    ArchRule gamesDoNotKnowEachOther() {
        return classes().that().resideInAPackage(in("game.*")).should(dependOnlyWhere("know no other game",
            (origin, target) -> Set.of("", gameOf(origin)).contains(gameOf(target))));
    }

    /** The name of the game that a class belongs to; empty for none. */
    private String gameOf(JavaClass type) {
        String games = root + ".game.";
        return type.getPackageName().startsWith(games)
            ? type.getPackageName().substring(games.length()).split("\\.")[0] : "";
    }

    /** Rooms that play many games have no say in how they are shown. */
    ArchRule contestsKnowNoTerminal() {
        return noClasses().that().resideInAPackage(in("contest"))
            .should().dependOnClassesThat().resideInAnyPackage("picocli..", "me.tongfei..")
            .orShould().accessTargetWhere(describe("reaches the streams of the process", access ->
                access.getTargetOwner().isEquivalentTo(System.class)
                    && Set.of("out", "err", "in", "console").contains(access.getTarget().getName())));
    }

    /**
     * A command has its streams and its end from one object, so that a client of a resident can be at the other end.
     * The entry points of the program know the process, and so may readers of environment and folder: a resident has
     * one of each.
     */
    ArchRule onlyTheStreamsKnowTheProcess() {
        return noClasses().that().resideOutsideOfPackages(in("lab"), in("cli.streams"))
            .and().haveNameNotMatching("steward\\.cli\\.(Main|ArchiveTraining)"
                + "|steward\\.guest\\.GuestJvm.*"                  // the main class of a referee's JVM
                + "|steward\\.cli\\.shared\\.OutOfMemory.*"            // ends the JVM that has none left
                + "|steward\\.replay\\.WriteBehind.*")                  // writes what all commands have left
            .should().accessTargetWhere(describe("reaches the streams or the end of the process", access ->
                access.getTargetOwner().isEquivalentTo(System.class)
                    && Set.of("out", "err", "in", "console", "exit").contains(access.getTarget().getName())
                || access.getTargetOwner().isEquivalentTo(Runtime.class)
                    && Set.of("exit", "halt", "addShutdownHook").contains(access.getTarget().getName())
                || access.getTargetOwner().isEquivalentTo(java.io.FileDescriptor.class)));
    }

    /** A league knows games only through contests: it plays none by itself, and starts no process. */
    ArchRule leaguesKnowGamesThroughContests() {
        return noClasses().that().resideInAPackage(in("league"))
            .should().dependOnClassesThat().resideInAnyPackage(in("physics"), in("bot.process"), in("game.*"))
            .orShould().dependOnClassesThat().haveFullyQualifiedName(root + ".match.Referee");
    }

    /** No other command needs the time to load it. */
    ArchRule onlyTheStoreKnowsSqlite() {
        return noClasses().that().resideOutsideOfPackage(in("league.store"))
            .should().dependOnClassesThat().resideInAnyPackage("org.sqlite..", "java.sql..");
    }

    /** No other command needs the time to load it. */
    ArchRule onlyTheBrokerKnowsArtemis() {
        return noClasses().that().resideOutsideOfPackage(in("machines.broker"))
            .should().dependOnClassesThat().resideInAnyPackage("org.apache.activemq..", "io.netty..");
    }

    ArchRule machinesKnowNoPhysicsAndNoRatings() {
        return noClasses().that().resideInAPackage(in("machines"))
            .should().dependOnClassesThat().resideInAnyPackage(in("physics"), in("league.rating"));
    }

    /** Data from other machines is JSON: nothing is made of it by Java itself. */
    ArchRule machinesDoNotDeserialize() {
        return noClasses().that().resideInAPackage(in("machines"))
            .should().dependOnClassesThat().haveNameMatching("java\\.io\\.Object(Input|Output)Stream.*");
    }

    ArchRule botsKnowNoRules() {
        return noClasses().that().resideInAPackage(in("bot"))
            .should().dependOnClassesThat(resideInAnyPackage(in("game"), in("scene"), in("physics")));
    }

    /** Rooms that measure the physics play no matches. */
    ArchRule labsKnowNoBots() {
        return noClasses().that().resideInAnyPackage(in("lab.oracle"), in("lab.trial"), in("lab.stability"),
                in("lab.timing"), in("lab.calibration"), in("lab.tradeoff"))
            .should().dependOnClassesThat(resideInAnyPackage(in("bot"), in("match")));
    }

    /** But for the browser, JVMs that time one kind of turns each, and the JDK's own program that makes keys. */
    ArchRule onlyBotsAreProcesses() {
        return noClasses().that()
            .resideOutsideOfPackages(in("bot"), in("live"), in("lab.timing"), in("lab.bench.section"),
                in("machines.token"))
            .should().dependOnClassesThat().haveFullyQualifiedName(ProcessBuilder.class.getName())
            .orShould().dependOnClassesThat().haveFullyQualifiedName(Process.class.getName());
    }

    ArchRule physicsKnowsNoFilesAndNoJson() {
        return noClasses().that().resideInAnyPackage(in("numerics"), in("physics"))
            .should().dependOnClassesThat().resideInAnyPackage("java.io..", "java.nio..", "java.net..", "java.time..",
                "tools.jackson..", "com.fasterxml..");
    }

    ArchRule noClockInAGame() {
        return noClasses().that(deterministicRooms())
            .should().accessTargetWhere(calls(System.class, CLOCKS))
            .orShould().dependOnClassesThat().resideInAPackage("java.time..");
    }

    ArchRule noRandomNumbersOfTheJdk() {
        return noClasses().that(deterministicRooms())
            .should().dependOnClassesThat().haveNameMatching("java\\.util\\.(Random|SplittableRandom|UUID)"
                + "|java\\.util\\.concurrent\\.ThreadLocalRandom|java\\.util\\.random\\..*|java\\.security\\..*")
            .orShould().accessTargetWhere(calls(Math.class, Set.of("random")));
    }

    ArchRule anglesAreStrict() {
        return noClasses().that(deterministicRooms()).should().accessTargetWhere(calls(Math.class, INEXACT));
    }

    ArchRule noHashOrder() {
        return noClasses().that().resideInAnyPackage(in("numerics"), in("physics"), in("json"), in("game"))
            .should().dependOnClassesThat()
            .haveNameMatching("java\\.util\\.(HashMap|HashSet|IdentityHashMap|WeakHashMap|Hashtable)"
                + "|java\\.util\\.concurrent\\.Concurrent(HashMap|SkipList.*)");
    }

    ArchRule noParallelSums() {
        return noClasses().that(deterministicRooms()).should().accessTargetWhere(describe("calls something parallel",
            access -> PARALLEL.contains(access.getTarget().getName())
                && access.getTargetOwner().getPackageName().startsWith("java.util")));
    }

    ArchRule staticsDoNotChange() {
        return fields().that().areStatic().and().areDeclaredInClassesThat().resideInAPackage(root + "..")
            .should().beFinal();
    }

    private static DescribedPredicate<JavaAccess<?>> calls(Class<?> owner, Set<String> names) {
        return describe("calls " + owner.getSimpleName() + "." + names, access ->
            access.getTargetOwner().isEquivalentTo(owner) && names.contains(access.getTarget().getName()));
    }
}
