package steward.bot.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.SortedMap;
import java.util.TreeMap;
import steward.text.NearestName;

/**
 * The bots bundled with the program: ordinary bot programs, started as processes of the JVM that runs the referee.
 *
 * <p>The class-path resource {@value #RESOURCE} lists them, one {@code NAME = main.Class} per line, with optional
 * arguments after the class, quoted as in {@link CommandLine}.
 */
public final class BuiltinBots {

    /** Class-path resource with the list. */
    public static final String RESOURCE = "steward/bots/builtin.properties";

    /** The system property that replaces the JVM options with which builtin bots are started. */
    public static final String JVM_OPTIONS = "steward.bot.jvm";

    /** Options for a short-lived JVM: only the quick compiler, a collector without threads, no shared counters. */
    private static final String SHORT_START =
        "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Xshare:auto -XX:-UsePerfData";

    private final SortedMap<String, String> mains;

    /** @param mains by bot name: the main class, then optional arguments */
    BuiltinBots(Map<String, String> mains) {
        this.mains = Collections.unmodifiableSortedMap(new TreeMap<>(mains));
    }

    /**
     * The bots of this installation; none if it ships no list.
     *
     * @throws UncheckedIOException when the list cannot be read
     */
    public static BuiltinBots installed() {
        Properties properties = new Properties();
        try (InputStream list = BuiltinBots.class.getClassLoader().getResourceAsStream(RESOURCE)) {
            if (list != null) {
                properties.load(list);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the list of builtin bots " + RESOURCE, e);
        }
        SortedMap<String, String> mains = new TreeMap<>();
        properties.stringPropertyNames().forEach(name -> mains.put(name, properties.getProperty(name)));
        return new BuiltinBots(mains);
    }

    /** The names, in alphabetical order. */
    public List<String> names() {
        return List.copyOf(mains.keySet());
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
        String main = mains.get(name);
        if (main == null) {
            throw new IllegalArgumentException(unknown(name));
        }
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(jvmOptions());
        command.add("-cp");
        command.add(System.getProperty("java.class.path"));
        command.addAll(CommandLine.split(main));
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
        if (mains.isEmpty()) {
            return problem + ": this installation has none (no " + RESOURCE + " on the class path)";
        }
        String question = NearestName.question(name, mains.keySet(), "'");
        return problem + (question.isEmpty() ? "; there are: " : question + " There are: ")
            + String.join(", ", mains.keySet());
    }
}
