package steward.schema;

import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
    /** Tasks and options that Gradle and its plugins bring. */
    private static final String PLUGIN_TASKS = "-q run test javadoc installDist classes labTestClasses checkstyleMain"
        + " checkstyleTest checkstyleBots publishToMavenLocal";
    private DocumentedCall() {
    }

    /**
     * Returns what is wrong with the calls of {@code steward} and of {@code ./gradlew}, also with those in an argument.
     *
     * @param whole whether nothing may be missing
     */
    static Stream<String> problems(String line, boolean whole) {
        String commands = !OURS.matcher(line).find() ? "" : PART.matcher(line).replaceAll(part ->
            Matcher.quoteReplacement(part.group(1) != null ? part.group() : part.group(2) != null ? "\n" : " "));
        return commands.lines().flatMap(command -> {
            List<String> words = steward.bot.command.CommandLine.split(command).stream()
                .dropWhile(word -> BEFORE_COMMAND.matcher(word).matches()).toList();
            return switch (words.isEmpty() ? "" : words.get(0)) {
                case "steward" -> stewardProblem(words.subList(1, words.size()), whole);
                case "./gradlew" -> gradleProblems(words.subList(1, words.size()));
                default -> words.stream().filter(word -> word.startsWith("steward "))
                    .flatMap(word -> problems(word, whole));
            };
        });
    }

    private static CommandLine program(String called) {
        return PROGRAMS.computeIfAbsent(called, name -> Main.program(new Streams(OutputStream.nullOutputStream(),
            OutputStream.nullOutputStream(), false, false), name.isEmpty() ? null : name));
    }

    private static synchronized Stream<String> stewardProblem(List<String> words, boolean whole) {
        int games = words.indexOf("--games-path");               // taken out before the command sees its options
        String[] arguments = Stream.concat(words.stream().limit(Math.max(games, 0)), words.stream().skip(games < 0
            ? 0 : games + 2)).map(each -> each.equals("{SEED}") ? "1" : each).toArray(String[]::new);
        try {
            program(arguments.length == 0 ? "" : arguments[0]).parseArgs(arguments);
            return Stream.of();
        } catch (CommandLine.ParameterException problem) {
            return Stream.of(problem.getMessage())
                .filter(each -> whole || !(problem instanceof CommandLine.MissingParameterException));
        }
    }

    /** Returns all options of all commands. */
    static Set<String> options() {
        return Stream.concat(Stream.of("--games-path"), program("").getSubcommands().values().stream()
            .flatMap(command -> Stream.concat(Stream.of(command), command.getSubcommands().values().stream()))
            .flatMap(command -> command.getCommandSpec().optionsMap().keySet().stream())).collect(Collectors.toSet());
    }

    private static Stream<String> gradleProblems(List<String> words) {
        Set<String> known = Stream.of(Stream.of(PLUGIN_TASKS.split(" ")), inBuild("tasks\\.create\\('(\\w+)'"),
            inBuild("findProperty\\('([\\w.]+)'\\)").map("-P"::concat),
            inBuild("\\[([^\\]]*)\\]\\.each \\{\\s*if \\(project\\.has").flatMap(handedOn -> Stream.of(handedOn
                .split("\\W+")).map("-Psteward."::concat))).flatMap(names -> names).collect(Collectors.toSet());
        return String.join("\n", words).replace("--tests\n", "--tests=").lines().flatMap(word -> {
            String value = word.replaceFirst("[^=]*=?", "");
            return switch (word.replaceFirst("=.*", "")) {
                case "--tests" -> classProblem("^" + value.replace(".", "\\.").replace("*", ".*") + "$",
                    "src/engineTest/java", "src/test/java", "src/labTest/java");
                case "-Pbench" -> classProblem(value.split(" ")[0], "src/jmh/java");
                case "-Pcli" -> problems("steward " + value, true);
                default -> Stream.of("no task, option or property " + word)
                    .filter(each -> !known.contains(word.replaceFirst("=.*", "")));
            };
        });
    }

    /** Returns what the first group of a pattern finds in the files of the build. */
    private static Stream<String> inBuild(String pattern) {
        return Stream.of("build.gradle", "gradle/publish.gradle", "gradle/release.gradle").map(SourceText::of)
            .flatMap(text -> Pattern.compile(pattern).matcher(text).results()).map(found -> found.group(1));
    }

    private static Stream<String> classProblem(String pattern, String... folders) {
        return Stream.of("no class is called " + pattern).filter(problem -> SourceText.ofKind(".java", folders).keySet()
            .stream().map(file -> file.replaceAll("^src/\\w+/java/|\\.java$", "").replace('/', '.'))
            .noneMatch(Pattern.compile(pattern).asPredicate()));
    }
}
