package steward.bot.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.text.NearestName;

/**
 * Bots that come with the program: ordinary bot programs, started as processes of the JVM that runs the referee.
 *
 * <p>The class-path resource {@value #RESOURCE} lists them, one {@code NAME = GAME main.Class} per line, with optional
 * arguments after the class, quoted as in {@link CommandLine}; the bots of a game from the weakest to the strongest.
 */
public final class BuiltinBots {

    /** Class-path resource with the list. */
    public static final String RESOURCE = "steward/bots/builtin.properties";

    /** The system property that replaces the JVM options with which builtin bots are started. */
    public static final String JVM_OPTIONS = "steward.bot.jvm";

    /** Options for a short-lived JVM: only the quick compiler, a collector without threads, no shared counters. */
    private static final String SHORT_START =
        "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Xshare:auto -XX:-UsePerfData";

    private static final Pattern LINE = Pattern.compile("([^#\\s]\\S*)\\s*=\\s*(\\S+)\\s+(.+)");

    /** The lines by name, in the order of the list. */
    private final Map<String, Matcher> lines = new LinkedHashMap<>();

    /** @param list the lines; others than those of bots are passed over */
    BuiltinBots(String list) {
        list.lines().map(LINE::matcher).filter(Matcher::matches).forEach(line -> lines.put(line.group(1), line));
    }

    /**
     * The bots of this installation; none if it ships no list.
     *
     * @throws UncheckedIOException when the list cannot be read
     */
    public static BuiltinBots installed() {
        try (InputStream list = BuiltinBots.class.getClassLoader().getResourceAsStream(RESOURCE)) {
            return new BuiltinBots(list == null ? "" : new String(list.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the list of builtin bots " + RESOURCE, e);
        }
    }

    /** The names, in the order of the list. */
    public List<String> names() {
        return List.copyOf(lines.keySet());
    }

    /** The names of the bots of a game, from the weakest to the strongest. */
    public List<String> of(String game) {
        return lines.keySet().stream().filter(name -> game(name).equals(game)).toList();
    }

    /** The game that a bot plays; it is one of {@link #names()}. */
    String game(String name) {
        return lines.get(name).group(2);
    }

    /**
     * The command that starts a builtin bot.
     *
     * @param name      one of {@link #names()}
     * @param arguments further arguments for the bot
     * @throws IllegalArgumentException when there is no such bot (the message lists those there are), or when the
     *     system property {@value #JVM_OPTIONS} cannot be split into words
     */
    public List<String> command(String name, List<String> arguments) {
        if (!lines.containsKey(name)) {
            throw new IllegalArgumentException(unknown(name));
        }
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(jvmOptions());
        command.add("-cp");
        command.add(System.getProperty("java.class.path"));
        command.addAll(CommandLine.split(lines.get(name).group(3)));
        command.addAll(arguments);
        return List.copyOf(command);
    }

    private static List<String> jvmOptions() {
        try {
            return CommandLine.split(System.getProperty(JVM_OPTIONS, SHORT_START));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("system property " + JVM_OPTIONS + ", " + e.getMessage(), e);
        }
    }

    private String unknown(String name) {
        String problem = "there is no builtin bot '" + name + "'";
        if (lines.isEmpty()) {
            return problem + ": this installation has none (no " + RESOURCE + " on the class path)";
        }
        String question = NearestName.question(name, lines.keySet(), "'");
        return problem + (question.isEmpty() ? "; there are: " : question + " There are: ")
            + names().stream().map(this::game).distinct().map(game -> String.join(", ", of(game)) + " (" + game + ")")
                .collect(Collectors.joining("; "));
    }
}
