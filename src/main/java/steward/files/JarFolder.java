package steward.files;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Class loader for the jars of a folder, with their digests. A class from a jar counts as another one whenever a byte
 * of the jar changes: the digest is stored in the seasons and replays of a game from that jar.
 */
public final class JarFolder extends URLClassLoader {

    static {
        registerAsParallelCapable();
    }

    private final Map<String, String> digests;

    private JarFolder(List<URL> jars, Map<String, String> digests, ClassLoader parent) {
        super(jars.toArray(new URL[0]), parent);
        this.digests = digests;
    }

    /**
     * Opens the jars of a folder, in the order of their names.
     *
     * @return {@code null} if the folder has none, or is not there
     * @throws IOException if a jar cannot be read
     */
    public static JarFolder open(Path folder, ClassLoader parent) throws IOException {
        if (!Files.isDirectory(folder)) {
            return null;
        }
        List<URL> jars = new ArrayList<>();
        Map<String, String> digests = new HashMap<>();
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.filter(file -> file.getFileName().toString().endsWith(".jar")).sorted().toList();
        }
        for (Path file : files) {
            URL jar = file.toUri().toURL();
            jars.add(jar);
            digests.put(jar.toString(), "sha256:" + Sha256.hex(Files.readAllBytes(file)));
        }
        return jars.isEmpty() ? null : new JarFolder(jars, digests, parent);
    }

    /** Digest of the jar that an object's class is from, or its own; {@code null} for what comes with the program. */
    public static String digestOf(Object of) {
        if (of instanceof Digested own) {
            return own.digest();
        }
        CodeSource source = of.getClass().getProtectionDomain().getCodeSource();
        return of.getClass().getClassLoader() instanceof JarFolder jars && source != null
            ? jars.digests.get(source.getLocation().toString()) : null;
    }
}
