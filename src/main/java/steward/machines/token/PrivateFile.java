package steward.machines.token;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import java.util.function.Supplier;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.scene.json.Block;
import steward.scene.json.JsonLimits;
import steward.scene.json.JsonTree;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/** Files and folders that only their owner may read. */
public final class PrivateFile {

    private static final Set<PosixFilePermission> OTHERS = PosixFilePermissions.fromString("---rwxrwx");

    private static final String OWNER = "rw-------";

    /** A process has one lock on a file; its threads wait here. */
    private static final ReentrantLock ALONE = new ReentrantLock();

    private PrivateFile() { }

    /** Takes the permissions of others away from a file that a program has made. */
    static void close(Path file) {
        try {
            if (isPosix(file)) {
                Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(OWNER));
            }
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
    }

    /**
     * Does something while no other thread or process does such a thing in this folder, which is made if it is not
     * there. Within it, it can be done again.
     */
    static <T> T alone(Path folder, Supplier<T> work) {
        if (ALONE.isHeldByCurrentThread()) {
            return work.get();
        }
        OutputFiles.privateFolder(folder);
        Path file = folder.resolve("lock");
        ALONE.lock();
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            channel.lock();                            // until it is closed
            return work.get();
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        } finally {
            ALONE.unlock();
        }
    }

    /** Writes a file as a whole: it is never there with other permissions, nor in part. */
    static void write(Path file, String text, boolean replace) {
        write(file, text.getBytes(StandardCharsets.UTF_8), replace);
    }

    /** Writes bytes, readable by the owner alone. */
    static void write(Path file, byte[] bytes, boolean replace) {
        Path part = file.resolveSibling(file.getFileName() + ".part");
        try {
            if (!replace && Files.exists(file)) {
                throw new InputException(file + ": exists already, and is kept; expected the name of a new file");
            }
            Files.deleteIfExists(part);
            Files.createFile(part, OutputFiles.ownerOnly());
            Files.write(part, bytes);
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
    }

    static String read(Path file, String expected) {
        try {
            if (Files.isDirectory(file) || Files.notExists(file)) {
                throw new InputException(file + ": found " + (Files.isDirectory(file) ? "a folder" : "no such file")
                    + ", expected " + expected);
            }
            if (Files.size(file) > JsonLimits.BYTES) {
                throw new InputException(file + ": found a file of " + Files.size(file) + " bytes, expected "
                    + expected);
            }
            return Utf8Text.decode(Files.readAllBytes(file), file.toString(), expected);
        } catch (NotUtf8Exception problem) {
            throw new InputException(problem.getMessage());
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be read: " + OutputFiles.reason(file, problem));
        }
    }

    /**
     * Reads a JSON object.
     *
     * @param source names it in errors
     * @param reader of its fields, all of them; {@code null} from it is returned whatever else is there
     * @throws InputException if it is none, or not as it should be
     */
    static <T> T parse(String text, String source, String expected, Function<Block, T> reader) {
        return InputException.of(() -> {
            Block block = new Block(source, "", JsonTree.read(text, source, expected));
            T read = reader.apply(block);
            if (read != null) {
                block.done();
            }
            return read;
        });
    }

    /** Returns a warning where others may read or write a file; {@code null} if they may not. */
    public static String warning(Path file) {
        try {
            if (isPosix(file)) {
                Set<PosixFilePermission> found = Files.getPosixFilePermissions(file);
                if (found.stream().anyMatch(OTHERS::contains)) {
                    return file + ": found it readable or writable by others (" + PosixFilePermissions.toString(found)
                        + "), expected a file of yours alone: chmod 600 " + file;
                }
            }
            return null;
        } catch (IOException gone) {
            return null;
        }
    }

    private static boolean isPosix(Path file) {
        return file.getFileSystem().supportedFileAttributeViews().contains("posix");
    }
}
