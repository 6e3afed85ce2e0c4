package steward.schema;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import steward.cli.Main;
import steward.cli.streams.Streams;

/** Check of a call of the program or of Gradle that a page shows: could it be made. Nothing is executed. */
final class DocumentedCall {

    /** The program by the command that is called, set up once. */
    private static final Map<String, CommandLine> PROGRAMS = new ConcurrentHashMap<>();
    private static final String GAMES_PATH = "--games-path";
    /** Tasks that Gradle's plugins bring. */
    private static final Set<String> PLUGIN_TASKS = Set.of("run", "test", "javadoc", "installDist", "classes",
        "labTestClasses",
        "checkstyleMain", "checkstyleTest", "checkstyleBots", "publishToMavenLocal");
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
            } else if (!argument.equals("-q") && !tasks().contains(argument)) {
                problem = "no task or option " + argument;
            }
            if (problem != null) {
                return problem;
            }
        }
        return null;
    }

    private static Set<String> tasks() {
        Set<String> tasks = new TreeSet<>(PLUGIN_TASKS);
        Matcher own = OWN_TASK.matcher(build());
        while (own.find()) {
            tasks.add(own.group(1));
        }
        return tasks;
    }

    private static String propertyProblem(String assignment) {
        String name = assignment.replaceAll("(?s)=.*", "");
        String value = assignment.substring(Math.min(assignment.length(), name.length() + 1));
        Set<String> known = new TreeSet<>();
        Matcher found = PROPERTY.matcher(build());
        while (found.find()) {
            known.add(found.group(1));
        }
        Matcher handed = TEST_PROPERTIES.matcher(build());
        while (handed.find()) {
            Stream.of(handed.group(1).split(", *")).forEach(word -> known.add("steward." + word.replace("'", "")));
        }
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
        boolean known = classes("src/jmh/java").stream().anyMatch(name -> wanted.matcher(name).find());
        return known ? null : "no benchmark " + pattern;
    }

    private static String filterProblem(String filter) {
        Pattern pattern = Pattern.compile("\\Q" + filter.replace("*", "\\E.*\\Q") + "\\E");
        boolean known = Stream.of("engineTest", "test", "labTest")
            .flatMap(part -> classes("src/" + part + "/java").stream())
            .anyMatch(name -> pattern.matcher(name).matches());
        return known ? null : "no class of tests is called " + filter;
    }

    private static List<String> classes(String folder) {
        Path root = Path.of(folder);
        List<String> names = new ArrayList<>();
        try (Stream<Path> files = Files.walk(root)) {
            files.map(file -> root.relativize(file).toString()).filter(name -> name.endsWith(".java"))
                .forEach(name -> names.add(name.replace(".java", "").replace('/', '.')));
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return names;
    }

    private static String build() {
        try {
            return Files.readString(Path.of("build.gradle")) + Files.readString(Path.of("gradle/publish.gradle"))
                + Files.readString(Path.of("gradle/release.gradle"));
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }
}
