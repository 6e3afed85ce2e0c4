package steward.hostile;

import java.nio.file.Path;
import java.util.List;

/** Another JVM with the classes of this one. */
final class Jvm {

    private Jvm() {
    }

    /**
     * The beginning of a command; a main class and its arguments follow.
     *
     * @param temporary its folder for temporary files
     */
    static List<String> words(Path temporary) {
        return List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC", "-Djava.io.tmpdir=" + temporary, "-cp", System.getProperty("java.class.path"));
    }
}
