package steward.bot.process;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** JVMs of their own with the classes of this one, which start quickly. */
public final class JavaProcess {

    private JavaProcess() {
    }

    /** Returns a command that runs a class, in any folder. */
    public static List<String> words(Class<?> program, String... arguments) {
        return words(List.of(), program, List.of(arguments));
    }

    /** Returns a command that runs a class, in any folder. @param options of the JVM */
    public static List<String> words(List<String> options, Class<?> program, List<String> arguments) {
        String classPath = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(part -> Path.of(part).toAbsolutePath().toString()).collect(Collectors.joining(File.pathSeparator));
        return Stream.of(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-XX:-UsePerfData", "--enable-native-access=ALL-UNNAMED"),
            options, List.of("-cp", classPath, program.getName()), arguments).flatMap(List::stream).toList();
    }
}
