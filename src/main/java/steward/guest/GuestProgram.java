package steward.guest;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Isolation;
import steward.guest.RefereeBlock.Name;
import steward.guest.project.SdkProject;
import steward.scene.SceneReader;
import steward.scene.json.Block;

/**
 * The block {@code referee} of a scene, which says how the referee is run. It is a command that plays one game, or a
 * class path whose main class plays game after game in a JVM.
 *
 * @param command      the program and its arguments; empty with a class path
 * @param classPath    folders and jars of a referee made with an SDK, the project itself first; empty with a command
 * @param reuse        name of the JVMs whose games use the classes of those before; {@code null} for fresh ones
 * @param system       system properties of a referee on a class path: its mode and level
 * @param tests        those of a game for one, and how its results are ordered
 * @param properties   lines {@code key=value} of the block INIT behind that of the seed, in the order of the keys
 * @param limitMs      how long the referee may take each time that it speaks, its start included
 * @param undetermined blocks that are not the same when a game is played again; they are not recorded
 */
record GuestProgram(List<String> command, List<String> classPath, String main, String reuse,
                    Map<String, String> system, SoloTests tests, Map<String, String> properties, int limitMs,
                    Set<Name> undetermined) {

    /**
     * Guice needs the package open on 17, identity hashes decide results of some, and blocks are UTF-8. The second
     * compiler costs more than it saves: fresh classes are gone before it is done, and kept ones had not repaid it
     * after 900 games.
     */
    private static final List<String> JVM_OPTIONS = List.of("-XX:+UseSerialGC", "-Xshare:auto",
        "-XX:TieredStopAtLevel=1",
        "-XX:+UnlockExperimentalVMOptions", "-XX:hashCode=2", "-Dfile.encoding=UTF-8",
        "--add-opens", "java.base/java.lang=ALL-UNNAMED");
    private static final String MODE = "game.mode";
    static final String LEVEL = "league.level";
    /** Field of a scene: how many levels its referee is known to have. */
    static final String LEVELS = "leagueLevels";
    static final String SOLO = "solo";
    /** Field of a scene with texts for people: what adopting chose, and why. */
    static final String ADOPTED = "adopted";
    static final int MOST_LEVEL = 20;
    private static final int USUAL_LIMIT_MS = 30_000;
    private static final int MOST_LIMIT_MS = 3_600_000;
    static final Set<Name> FOR_PEOPLE = EnumSet.of(Name.VIEW, Name.INFOS, Name.SUMMARY, Name.TOOLTIP,
        Name.UINPUT, Name.METADATA);

    static GuestProgram read(Block root) {
        Block block = root.block(SceneReader.REFEREE);
        boolean resident = block.contains("classPath");
        if (resident == block.contains("command")) {
            throw block.error(resident ? "a command and a classPath" : "neither a command nor a classPath",
                "one of them");
        }
        List<String> command = resident ? List.of() : words(block, "command");
        List<String> classPath = resident ? words(block, "classPath") : List.of();
        Map<String, String> system = new TreeMap<>();
        String main = null;
        String reuse = null;
        if (resident) {
            main = block.has("main") ? block.text("main") : SdkProject.MAIN;
            boolean kept = block.choice("reuse", Map.of("classes", true, "nothing", false), false);
            String mode = block.choice("mode", Map.of("multi", "multi", SOLO, SOLO), "multi");
            system.put(MODE, mode);
            int levels = block.integer(LEVELS, 1, MOST_LEVEL, MOST_LEVEL);
            if (block.has("leagueLevel")) {
                system.put(LEVEL, Integer.toString(block.integer("leagueLevel", 1, levels)));
            }
            String solo = Stream.of("testIn", SoloTests.FIELD, SoloTests.CRITERION, SoloTests.LOWER)
                .filter(block::contains).findFirst().orElse(null);
            if (solo != null && !mode.equals(SOLO)) {
                throw block.error(solo, solo.equals("testIn") ? "a test in the mode " + mode : "the mode " + mode,
                    "the mode solo with it");
            }
            // One JVM plays one level where classes stay: levels are often kept in static fields.
            reuse = kept ? "level " + system.get(LEVEL) : null;
        }
        block.optionalBlock(ADOPTED).ifPresent(words -> Stream.of("level", "engine", SoloTests.FIELD)
            .filter(words::has).forEach(words::text));
        int limitMs = block.integer("limitMs", 1, MOST_LIMIT_MS, USUAL_LIMIT_MS);
        SoloTests tests = SoloTests.read(block);
        Set<Name> undetermined = undetermined(block);
        if (!tests.criterion().isEmpty() && undetermined.contains(Name.METADATA)) {
            throw block.error("undetermined", "METADATA", "other blocks: the criterion is in it");
        }
        return new GuestProgram(command, classPath, main, reuse, system, tests, properties(block), limitMs,
            undetermined);
    }

    private static List<String> words(Block block, String name) {
        List<String> words = block.texts(name);
        if (words.isEmpty()) {
            throw block.error(name, "no words", "at least one");
        }
        if (words.stream().anyMatch(word -> word.indexOf('\0') >= 0)) {
            throw block.error(name, "a null character", "words that a program can be given");
        }
        return words;
    }

    private static Map<String, String> properties(Block block) {
        Map<String, String> properties = new TreeMap<>();
        block.optionalBlock("properties").ifPresent(values ->
            values.entries().keySet().forEach(key -> properties.put(key, values.text(key))));
        properties.forEach((key, value) -> {
            if (key.equals("seed")) {
                throw block.block("properties").error(key, "a seed", "none: each game has one of its own");
            }
            if ((key + value).chars().anyMatch(Character::isISOControl) || key.contains("=")) {
                throw block.error("properties", "the property '" + key + "'", "keys and values of one line");
            }
        });
        return properties;
    }

    private static Set<Name> undetermined(Block block) {
        Set<Name> undetermined = EnumSet.noneOf(Name.class);
        for (String word : block.has("undetermined") ? block.texts("undetermined") : List.<String>of()) {
            undetermined.add(FOR_PEOPLE.stream().filter(name -> name.name().equals(word)).findFirst()
                .orElseThrow(() -> block.error("undetermined", "\"" + word + "\"", "blocks of " + FOR_PEOPLE)));
        }
        return undetermined;
    }

    /** True if one process plays game after game. */
    boolean isResident() {
        return !classPath.isEmpty();
    }

    /** League level of a referee on a class path; 0 if none is named. */
    int level() {
        return Integer.parseInt(system.getOrDefault(LEVEL, "0"));
    }

    boolean isSolo() {
        return SOLO.equals(system.get(MODE));
    }

    /** Entries of the class path, or words of the command that are files. */
    List<String> files() {
        return isResident() ? classPath : command.stream().filter(GuestProgram::isFile).toList();
    }

    private static boolean isFile(String word) {
        try {
            return Files.isRegularFile(Path.of(word));
        } catch (InvalidPathException noFile) {
            return false;
        }
    }

    /** Returns the blocks that begin a game. */
    String beginning(int players, long seed) {
        List<String> lines = new ArrayList<>();
        lines.add(Integer.toString(players));
        lines.addAll(tests.lines(seed));
        lines.addAll(assignments(properties));
        return (isResident() ? RefereeBlock.text("START", assignments(system)) : "")
            + RefereeBlock.text("INIT", lines);
    }

    private static List<String> assignments(Map<String, String> values) {
        return values.entrySet().stream().map(value -> value.getKey() + "=" + value.getValue()).toList();
    }

    /** Name of a program or an entry of the class path that is not there, or {@code null}. */
    String missing() {
        return isResident() ? classPath.stream().filter(entry -> !Files.exists(Path.of(entry))).findFirst().orElse(null)
            : ProgramFinder.find(command.get(0)) == null ? command.get(0) : null;
    }

    /** The words of the process to start; nothing is {@link #missing}. */
    List<String> words() {
        List<String> words = new ArrayList<>();
        if (!isResident()) {
            words.add(ProgramFinder.find(command.get(0)).toString());
            words.addAll(command.subList(1, command.size()));
            return words;
        }
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(JVM_OPTIONS);
        if (reuse != null) {
            words.add("-Dsteward.reuse=" + reuse);
        }
        List<String> entries = classPath.stream().map(entry -> Path.of(entry).toAbsolutePath().toString()).toList();
        // The referee has loaders of its own, but some look for their files by the system's.
        words.addAll(List.of("-cp", hostPath() + File.pathSeparator + String.join(File.pathSeparator, entries),
            GuestJvm.class.getName(), main, reuse == null ? "fresh" : "classes"));
        words.addAll(entries);
        return words;
    }

    /** Where the classes of this program are, of which the JVM needs one. */
    private static String hostPath() {
        try {
            return Path.of(GuestJvm.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Isolation of the referee: its class path is let through. */
    Isolation isolated(Isolation usual) {
        return usual.showing(classPath.stream().map(entry -> Path.of(entry).toAbsolutePath()).toList());
    }
}
