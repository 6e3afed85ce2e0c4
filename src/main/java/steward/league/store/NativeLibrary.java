package steward.league.store;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.sqlite.SQLiteJDBCLoader;
import org.sqlite.util.LibraryLoaderUtil;
import org.sqlite.util.OSInfo;
import steward.files.UserFolders;

/**
 * Native library of SQLite, unpacked once into the user's cache folder. By default, the library would unpack itself
 * into the temporary folder at every start, and a killed process would leave it there.
 */
final class NativeLibrary {

    private static final String PATH = "org.sqlite.lib.path";
    private static final String NAME = "org.sqlite.lib.name";

    /**
     * Makes sure that it is there, before the first connection.
     *
     * @param own a folder to take if there is no cache folder
     */
    static void prepare(Path own) {
        if (System.getProperty(PATH) != null) {
            return;
        }
        String name = LibraryLoaderUtil.getNativeLibName();
        String system = system();
        Path folder = unpack(UserFolders.cache(), system, name);
        if (folder == null) {
            folder = unpack(own.resolve(".sqlite"), system, name);
        }
        if (folder != null) {
            System.setProperty(PATH, folder.toString());
            System.setProperty(NAME, name);
        }
    }

    /**
     * The system and processor as the driver's jar names its folders. The driver would start {@code uname} to ask
     * whether a Linux is Android; a terminal there says so by a variable.
     */
    static String system() {
        boolean plain = System.getProperty("os.name").equals("Linux") && !OSInfo.isAndroidRuntime()
            && System.getenv("ANDROID_ROOT") == null;
        if (!plain) {
            return OSInfo.getNativeLibFolderPathForCurrentOS();
        }
        return (OSInfo.isMusl() ? "Linux-Musl" : "Linux") + "/" + OSInfo.getArchName();
    }

    /** The folder with the library, or {@code null} if it cannot be written there. */
    static Path unpack(Path cache, String system, String name) {
        Path folder = cache.resolve("sqlite-" + SQLiteJDBCLoader.getVersion() + "-" + system.replace('/', '-'));
        Path file = folder.resolve(name);
        if (Files.isRegularFile(file)) {
            return folder;
        }
        Path part = null;
        String resource = "/org/sqlite/native/" + system + "/" + name;
        try (InputStream library = SQLiteJDBCLoader.class.getResourceAsStream(resource)) {
            if (library == null) {
                return null;
            }
            Files.createDirectories(folder);
            part = Files.createTempFile(folder, "unpacking", ".part");
            Files.copy(library, part, StandardCopyOption.REPLACE_EXISTING);
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            return folder;
        } catch (IOException problem) {
            remove(part);
            return null;
        }
    }

    private static void remove(Path part) {
        try {
            if (part != null) {
                Files.deleteIfExists(part);
            }
        } catch (IOException stays) {
            return;
        }
    }
}
