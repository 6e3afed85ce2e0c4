package steward.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import steward.scene.json.JsonLimits;
import steward.scene.json.SceneException;
import steward.scene.json.Wording;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/** Finds scene files: by path, or by the name of a shipped scene. */
public final class SceneFiles {

    /** The scenes that come with the program; a test compares the list with their folder. */
    static final List<String> SHIPPED = List.of("avalanche", "billiards", "bowl", "bullets", "cradle", "dense-box",
        "duel", "fantastic-bits-contest", "fantastic-bits", "gas", "mad-pod-racing-silver", "mad-pod-racing",
        "mean-max", "poker-chip-race", "search-race", "walled-race");

    private static final String SUFFIX = ".json";

    private SceneFiles() {
    }

    /** The names that {@link #load} knows; none when the program runs without its resources. */
    public static List<String> shipped() {
        return SHIPPED.stream().filter(name -> SceneFiles.class.getResource(resource(name)) != null).toList();
    }

    /**
     * @param pathOrName a path to a file; otherwise the name of a shipped scene, with or without {@code .json}
     * @throws SceneException if there is no such scene, it is too long, or cannot be read as UTF-8
     */
    public static SceneText load(String pathOrName) {
        boolean folder = false;
        try {
            Path path = Path.of(pathOrName);
            folder = Files.isDirectory(path) && !pathOrName.isEmpty();
            if (Files.exists(path) && !Files.isDirectory(path)) {
                return new SceneText(decode(bytes(path, pathOrName, "a scene"), pathOrName), pathOrName,
                    Optional.of(AccuracyFigures.beside(path)));
            }
        } catch (InvalidPathException e) {
            // No file can have this name, so it is looked up among the shipped ones and reported below.
        } catch (IOException e) {
            String why = e instanceof AccessDeniedException ? "no permission" : e.getMessage();
            throw new SceneException(pathOrName + ": found a file that cannot be read (" + why
                + "), expected a scene file");
        }
        String name = pathOrName.endsWith(SUFFIX)
            ? pathOrName.substring(0, pathOrName.length() - SUFFIX.length()) : pathOrName;
        List<String> shipped = shipped();
        if (shipped.contains(name)) {
            return loadShipped(name);
        }
        throw new SceneException((pathOrName.isEmpty() ? "\"\"" : pathOrName) + ": found "
            + (folder ? "a folder" : "no such file") + ", expected a scene file"
            + (shipped.isEmpty() ? "" : " or " + Wording.choice(name, shipped)));
    }

    /** @param what says in the error what the file should be, as in {@code a scene} */
    static byte[] bytes(Path path, String source, String what) throws IOException {
        try (InputStream in = Files.newInputStream(path)) {
            return bytes(in, source, what);
        }
    }

    /** Reads at most one byte beyond the limit: the size of a pipe is not known before. */
    private static byte[] bytes(InputStream in, String source, String what) throws IOException {
        byte[] bytes = in.readNBytes(JsonLimits.BYTES + 1);
        if (bytes.length > JsonLimits.BYTES) {
            throw new SceneException(source + ": found a file of more than " + JsonLimits.BYTES
                + " bytes, expected " + what + " of at most " + JsonLimits.BYTES);
        }
        return bytes;
    }

    /**
     * A scene that is no file, such as the standard input.
     *
     * @param in     is read, and not closed
     * @param source how errors name it
     * @throws IOException    if it cannot be read
     * @throws SceneException if it is too long, or not in UTF-8
     */
    public static SceneText read(InputStream in, String source) throws IOException {
        return new SceneText(decode(bytes(in, source, "a scene"), source), source);
    }

    /**
     * A shipped scene, also where a file has its name.
     *
     * @throws SceneException if there is none of this name
     */
    public static SceneText shipped(String name) {
        if (!shipped().contains(name)) {
            throw new SceneException((name.isEmpty() ? "\"\"" : name) + ": found no scene of this name, expected "
                + Wording.choice(name, shipped()));
        }
        return loadShipped(name);
    }

    private static SceneText loadShipped(String name) {
        String source = resource(name).substring(1);
        try (InputStream in = SceneFiles.class.getResourceAsStream(resource(name))) {
            return new SceneText(decode(in.readAllBytes(), source), source);
        } catch (IOException e) {
            throw new SceneException(source + ": found a damaged scene (" + e.getMessage()
                + "), expected the program to be whole");
        }
    }

    private static String resource(String name) {
        return "/scenes/" + name + SUFFIX;
    }

    /** Strict decoding, unlike {@code new String}; a byte order mark is removed. */
    static String decode(byte[] bytes, String source) {
        try {
            String text = Utf8Text.decode(bytes, source, "a text in UTF-8");
            return text.startsWith("\ufeff") ? text.substring(1) : text;
        } catch (NotUtf8Exception problem) {
            throw new SceneException(problem.getMessage());
        }
    }
}
