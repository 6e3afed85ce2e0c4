package steward.scene;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import steward.scene.json.Block;
import steward.scene.json.JsonLimits;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;
import steward.scene.json.Wording;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/** Files of scenes, found by path, or by the name of a shipped scene. */
public final class SceneFiles {

    /** The scenes that come with the program; a test compares the list with their folder. */
    static final List<String> SHIPPED = List.of("avalanche", "billiards", "bowl", "bullets", "cradle", "dense-box",
        "duel", "fantastic-bits-contest", "fantastic-bits", "gas", "mad-pod-racing-silver", "mad-pod-racing",
        "mean-max", "poker-chip-race", "search-race", "walled-race");

    private static final String SUFFIX = ".json";

    private SceneFiles() { }

    /** The names that {@link #load} knows; none when the program runs without its resources. */
    public static List<String> shipped() {
        return SceneFiles.class.getResource(resource(SHIPPED.get(0))) == null ? List.of() : SHIPPED;
    }

    /**
     * The file that is named, if it is one: what has a slash or ends in {@code .json} is a path. A name without either
     * is that of a shipped scene, whatever files there are.
     */
    public static Optional<Path> file(String pathOrName) {
        try {
            Path path = Path.of(pathOrName);
            return isPath(pathOrName) && Files.exists(path) && !Files.isDirectory(path) ? Optional.of(path)
                : Optional.empty();
        } catch (InvalidPathException e) {
            return Optional.empty();                          // no file can have this name
        }
    }

    /**
     * Copies a scene with the files that belong to it: the figures of its accuracy and its CSV files. Files of these
     * names are replaced. Those of a referee stay where they are, and are named by their whole path.
     *
     * @param scene that can be read
     * @param to    where it goes, in another folder
     * @throws IOException if a file cannot be read or written
     */
    public static void copy(Path scene, Path to) throws IOException {
        SceneText text = load(scene.toAbsolutePath().toString());
        Block root = new Block(text.source(), "", JsonTree.read(text.text(), text.source(), "a scene"));
        for (String csv : CsvLines.names(root)) {
            Files.copy(scene.resolveSibling(csv), to.resolveSibling(csv), StandardCopyOption.REPLACE_EXISTING);
        }
        Path figures = AccuracyFigures.beside(scene);
        if (Files.isRegularFile(figures)) {
            Files.copy(figures, AccuracyFigures.beside(to), StandardCopyOption.REPLACE_EXISTING);
        }
        Block placed = RefereeWords.found(root, scene.toAbsolutePath());
        if (placed == root) {
            Files.copy(scene, to, StandardCopyOption.REPLACE_EXISTING);
        } else {
            Files.writeString(to, placed.json());
        }
    }

    private static boolean isPath(String pathOrName) {
        return pathOrName.endsWith(SUFFIX) || pathOrName.indexOf('/') >= 0
            || pathOrName.indexOf(File.separatorChar) >= 0;
    }

    /**
     * @param pathOrName see {@link #file}; {@code NAME.json} that is no file is a shipped scene, too
     * @throws SceneException if there is no such scene, it is too long, or cannot be read as UTF-8
     */
    public static SceneText load(String pathOrName) {
        Optional<Path> file = file(pathOrName);
        if (file.isPresent()) {
            Path path = file.get();
            try {
                return new SceneText(decode(bytes(path, pathOrName, "a scene"), pathOrName), pathOrName,
                    Optional.of(AccuracyFigures.beside(path)));
            } catch (IOException e) {
                String why = e instanceof AccessDeniedException ? "no permission" : e.getMessage();
                throw new SceneException(pathOrName + ": found a file that cannot be read (" + why
                    + "), expected a scene file");
            }
        }
        String name = pathOrName.endsWith(SUFFIX)
            ? pathOrName.substring(0, pathOrName.length() - SUFFIX.length()) : pathOrName;
        List<String> shipped = shipped();
        if (shipped.contains(name)) {
            return loadShipped(name);
        }
        throw new SceneException((pathOrName.isEmpty() ? "\"\"" : pathOrName) + ": found " + found(pathOrName)
            + ", expected a scene file" + (shipped.isEmpty() ? "" : " or " + Wording.choice(name, shipped)));
    }

    private static String found(String pathOrName) {
        try {
            Path path = Path.of(pathOrName);
            return pathOrName.isEmpty() || !Files.exists(path) ? "no such file"
                : Files.isDirectory(path) ? "a folder"
                : "a file that is named like no scene (write ./" + pathOrName + ")";
        } catch (InvalidPathException e) {
            return "no such file";
        }
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
