package steward.schema;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import steward.architecture.SourceText;
import steward.cli.Main;
import steward.cli.streams.Streams;

/** Check of a call of the program or of Gradle that a page shows: could it be made. Nothing is executed. */
final class DocumentedCall {

    /** The program by the command that is called, set up once. */
    private static final Map<String, CommandLine> PROGRAMS = new ConcurrentHashMap<>();
    private static final String GAMES_PATH = "--games-path";
    /** Tasks that Gradle's plugins bring. */
    private static final Set<String> PLUGIN_TASKS = Set.of("run", "test", "javadoc", "installDist", "classes",
        "labTestClasses", "checkstyleMain", "checkstyleTest", "checkstyleBots", "publishToMavenLocal");
    private static final Pattern OWN_TASK = Pattern.compile("tasks\\.create\\('(\\w+)'");
    private static final Pattern PROPERTY = Pattern.compile("findProperty\\('([\\w.]+)'\\)");
    /** The list of properties that are handed to tests. */
    private static final Pattern TEST_PROPERTIES = Pattern.compile("\\[([^\\]]*)\\]\\.each \\{\\s*if \\(project\\.has");

    private static final Set<String> OPTIONS = options();

    private DocumentedCall() {
    }

    /**
     * Returns the fault of a call, or {@code null}.
     *
     * @param words its first one is {@code steward} or {@code ./gradlew}
     * @param whole whether nothing may be missing
     */
    static String problem(List<String> words, boolean whole) {
        List<String> arguments = words.subList(1, words.size());
        return words.get(0).equals("steward") ? stewardProblem(arguments, whole) : gradleProblem(arguments);
    }

    private static CommandLine program(String called) {
        return PROGRAMS.computeIfAbsent(String.valueOf(called), name -> Main.program(new Streams(
            OutputStream.nullOutputStream(), OutputStream.nullOutputStream(), false, false), called));
    }

    private static synchronized String stewardProblem(List<String> call, boolean whole) {
        List<String> arguments = new ArrayList<>(call);
        arguments.replaceAll(argument -> argument.equals("{SEED}") ? "1" : argument);   // a tool puts a number there
        int games = arguments.indexOf(GAMES_PATH);               // taken out before the command sees its options
        if (games >= 0) {
            arguments.subList(games, games + 2).clear();
        }
        try {
            program(arguments.isEmpty() ? null : arguments.get(0)).parseArgs(arguments.toArray(new String[0]));
            return null;
        } catch (CommandLine.MissingParameterException problem) {
            return whole ? problem.getMessage() : null;
        } catch (CommandLine.ParameterException problem) {
            return problem.getMessage();
        }
    }

    /** Returns the fault of an option that stands alone, or {@code null}: some command has to have it. */
    static String optionProblem(String option) {
        return OPTIONS.contains(option) || option.equals(GAMES_PATH) ? null : "no command has such an option";
    }

    /** Options of all commands: to set up every command takes long, and pages name hundreds of options. */
    private static Set<String> options() {
        return program(null).getSubcommands().values().stream()
            .flatMap(command -> Stream.concat(Stream.of(command), command.getSubcommands().values().stream()))
            .flatMap(command -> command.getCommandSpec().optionsMap().keySet().stream())
            .collect(Collectors.toUnmodifiableSet());
    }

    private static String gradleProblem(List<String> arguments) {
        for (int k = 0; k < arguments.size(); k++) {
            String argument = arguments.get(k);
            String problem = null;
            if (argument.equals("--tests")) {
                k++;
                problem = filterProblem(arguments.get(k));
            } else if (argument.startsWith("-P")) {
                problem = propertyProblem(argument.substring(2));
            } else if (!argument.equals("-q") && !PLUGIN_TASKS.contains(argument)
                    && inBuild(OWN_TASK).noneMatch(argument::equals)) {
                problem = "no task or option " + argument;
            }
            if (problem != null) {
                return problem;
            }
        }
        return null;
    }

    /** What the first group of a pattern finds in the files of the build. */
    private static Stream<String> inBuild(Pattern pattern) {
        return Stream.of("build.gradle", "gradle/publish.gradle", "gradle/release.gradle")
            .flatMap(file -> pattern.matcher(SourceText.of(file)).results()).map(found -> found.group(1));
    }

    private static String propertyProblem(String assignment) {
        String name = assignment.replaceAll("(?s)=.*", "");
        String value = assignment.substring(Math.min(assignment.length(), name.length() + 1));
        Set<String> known = inBuild(PROPERTY).collect(Collectors.toCollection(TreeSet::new));
        inBuild(TEST_PROPERTIES).flatMap(list -> Stream.of(list.split(", *")))
            .forEach(word -> known.add("steward." + word.replace("'", "")));
        if (!known.contains(name)) {
            return "no property " + name + ", there are " + known;
        }
        return switch (name) {
            case "cli" -> stewardProblem(steward.bot.command.CommandLine.split(value), true);
            case "bench" -> benchmarkProblem(value.split(" ")[0]);
            default -> null;
        };
    }

    private static String benchmarkProblem(String pattern) {
        Pattern wanted = Pattern.compile(pattern);
        return classes("src/jmh/java").anyMatch(name -> wanted.matcher(name).find()) ? null : "no benchmark " + pattern;
    }

    private static String filterProblem(String filter) {
        Pattern pattern = Pattern.compile("\\Q" + filter.replace("*", "\\E.*\\Q") + "\\E");
        return classes("src/engineTest/java", "src/test/java", "src/labTest/java")
            .anyMatch(name -> pattern.matcher(name).matches()) ? null : "no class of tests is called " + filter;
    }

    private static Stream<String> classes(String... folders) {
        return SourceText.below(folders).keySet().stream()
            .map(file -> file.replaceAll("^src/\\w+/java/|\\.java$", "").replace('/', '.'));
    }
}
