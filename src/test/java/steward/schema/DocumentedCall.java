package steward.schema;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import steward.architecture.SourceText;
import steward.cli.Main;
import steward.cli.streams.Streams;

/** Calls of the program and of Gradle in a line of shell: could each be made. Nothing is executed. */
final class DocumentedCall {

    private static final Pattern OURS = Pattern.compile("(?:^|[\\s\"'(])(?:steward|\\./gradlew)(?:\\s|[\"')]*$)");
    private static final String WORD = "(?:'[^']*'|\"(?:\\\\.|[^\"\\\\])*+\"|\\\\.|[^\\s'\"\\\\|;&()<>])++";
    /** A word with its quotes; what ends a command; or a redirection, which is no word of it. */
    private static final Pattern PART =
        Pattern.compile("((?!#)" + WORD + ")|(#.*|[|;&()])|[<>][ \\t]*(?:" + WORD + ")?");
    private static final Pattern BEFORE_COMMAND = Pattern.compile("(?s)env|-i|[A-Za-z_]\\w*=.*");

    /** The program by the command that is called, set up once. */
    private static final Map<String, CommandLine> PROGRAMS = new ConcurrentHashMap<>();
    private static final String GAMES_PATH = "--games-path";
    /** Tasks that Gradle's plugins bring. */
    private static final Set<String> PLUGIN_TASKS = Set.of("-q", "run", "test", "javadoc", "installDist", "classes",
        "labTestClasses", "checkstyleMain", "checkstyleTest", "checkstyleBots", "publishToMavenLocal");
    private static final Pattern OWN_TASK = Pattern.compile("tasks\\.create\\('(\\w+)'");
    private static final Pattern PROPERTY = Pattern.compile("findProperty\\('([\\w.]+)'\\)");
    /** The list of properties that are handed to tests. */
    private static final Pattern TEST_PROPERTIES = Pattern.compile("\\[([^\\]]*)\\]\\.each \\{\\s*if \\(project\\.has");

    private DocumentedCall() {
    }

    /** The calls of {@code steward} and of {@code ./gradlew}, also in an argument; each begins with that word. */
    static List<List<String>> calls(String line) {
        List<List<String>> calls = new ArrayList<>();
        String commands = !OURS.matcher(line).find() ? "" : PART.matcher(line).replaceAll(part ->
            Matcher.quoteReplacement(part.group(1) != null ? part.group() : part.group(2) != null ? "\n" : " "));
        for (String command : commands.split("\n")) {
            List<String> words = steward.bot.command.CommandLine.split(command).stream()
                .dropWhile(word -> BEFORE_COMMAND.matcher(word).matches()).toList();
            if (!words.isEmpty() && (words.get(0).equals("steward") || words.get(0).equals("./gradlew"))) {
                calls.add(words);
            } else {
                words.stream().filter(word -> word.startsWith("steward ")).forEach(word -> calls.addAll(calls(word)));
            }
        }
        return calls;
    }

    /**
     * Returns the first fault of the calls in a line, or {@code null}.
     *
     * @param whole whether nothing may be missing
     */
    static String problem(String line, boolean whole) {
        return calls(line).stream().map(call -> call.get(0).equals("steward")
            ? stewardProblem(call.subList(1, call.size()), whole) : gradleProblem(call.subList(1, call.size())))
            .filter(Objects::nonNull).findFirst().orElse(null);
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
        } catch (CommandLine.ParameterException problem) {
            boolean mayBe = problem instanceof CommandLine.MissingParameterException && !whole;
            return mayBe ? null : problem.getMessage();
        }
    }

    /** Returns all options of all commands. */
    static Set<String> options() {
        return Stream.concat(Stream.of(GAMES_PATH), program(null).getSubcommands().values().stream()
            .flatMap(command -> Stream.concat(Stream.of(command), command.getSubcommands().values().stream()))
            .flatMap(command -> command.getCommandSpec().optionsMap().keySet().stream())).collect(Collectors.toSet());
    }

    private static String gradleProblem(List<String> arguments) {
        String problem = null;
        for (Iterator<String> rest = arguments.iterator(); problem == null && rest.hasNext();) {
            String argument = rest.next();
            if (argument.equals("--tests")) {
                problem = classProblem("^" + rest.next().replace(".", "\\.").replace("*", ".*") + "$",
                    "src/engineTest/java", "src/test/java", "src/labTest/java");
            } else if (argument.startsWith("-P")) {
                problem = propertyProblem(argument.substring(2));
            } else if (!PLUGIN_TASKS.contains(argument) && inBuild(OWN_TASK).noneMatch(argument::equals)) {
                problem = "no task or option " + argument;
            }
        }
        return problem;
    }

    /** Returns what the first group of a pattern finds in the files of the build. */
    private static Stream<String> inBuild(Pattern pattern) {
        return Stream.of("build.gradle", "gradle/publish.gradle", "gradle/release.gradle")
            .flatMap(file -> pattern.matcher(SourceText.of(file)).results()).map(found -> found.group(1));
    }

    private static String propertyProblem(String assignment) {
        String[] parts = (assignment + "=").split("=", 2);
        String value = parts[1].replaceFirst("=$", "");
        Set<String> known = inBuild(PROPERTY).collect(Collectors.toCollection(TreeSet::new));
        inBuild(TEST_PROPERTIES).flatMap(list -> Stream.of(list.split(", *")))
            .forEach(word -> known.add("steward." + word.replace("'", "")));
        if (!known.contains(parts[0])) {
            return "no property " + parts[0] + ", there are " + known;
        }
        return switch (parts[0]) {
            case "cli" -> stewardProblem(steward.bot.command.CommandLine.split(value), true);
            case "bench" -> classProblem(value.split(" ")[0], "src/jmh/java");
            default -> null;
        };
    }

    private static String classProblem(String pattern, String... folders) {
        return SourceText.below(folders).keySet().stream()
            .map(file -> file.replaceAll("^src/\\w+/java/|\\.java$", "").replace('/', '.'))
            .anyMatch(Pattern.compile(pattern).asPredicate()) ? null : "no class is called " + pattern;
    }
}
