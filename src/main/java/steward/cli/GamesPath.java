package steward.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.files.InputException;
import steward.files.JarFolder;
import steward.files.UserFolders;
import steward.game.GameTypes;

/**
 * The user's folder of games while a command runs: {@code --games-path DIR}, or the folder {@code steward/games} of the
 * user's data (XDG base directory specification). The option may stand anywhere in the call. The folder's jars are
 * found through the context class loader (see {@link GameTypes#installed}).
 *
 * @param words  of the call, without the option
 * @param before the context class loader of this thread before
 * @param jars   of the folder, or {@code null} if there are none
 */
record GamesPath(List<String> words, ClassLoader before, JarFolder jars) implements AutoCloseable {

    /** The option; it stands before or behind any command. */
    static final String OPTION = "--games-path";

    /** @throws InputException if a folder was named that is not there, or whose jars are no games */
    static GamesPath of(List<String> call) {
        List<String> words = new ArrayList<>(call);
        String named = null;
        int at = words.indexOf(OPTION);
        if (at >= 0 && at + 1 < words.size()) {
            words.remove(at);
            named = words.remove(at);
        }
        Path folder = named == null ? UserFolders.folder("XDG_DATA_HOME", ".local/share").resolve("games")
            : Path.of(named);
        if (named != null && !Files.isDirectory(folder)) {
            throw new InputException(OPTION + ": found no folder " + named + ", expected one with the jars of games");
        }
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        try {
            JarFolder jars = JarFolder.open(folder, GameTypes.class.getClassLoader());
            if (jars != null) {
                Thread.currentThread().setContextClassLoader(jars);
                check(folder, jars, before);
            }
            return new GamesPath(words, before, jars);
        } catch (IOException problem) {
            throw new InputException(folder + ": found a jar that cannot be read (" + problem.getMessage() + ")");
        }
    }

    private static void check(Path folder, JarFolder jars, ClassLoader before) throws IOException {
        try {
            GameTypes.installed();
        } catch (IllegalArgumentException problem) {
            Thread.currentThread().setContextClassLoader(before);
            jars.close();
            throw new InputException(folder + ": " + problem.getMessage());
        }
    }

    @Override
    public void close() {
        if (jars != null) {
            Thread.currentThread().setContextClassLoader(before);
        }
    }
}
