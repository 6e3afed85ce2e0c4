package steward.files;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;

/**
 * Output file that is created at the first write. So a process that is killed before leaves no empty file, and a file
 * to be replaced stays until then. Foreseeable errors are found at construction, where it is tried whether a new file
 * can be created. Existing devices and pipes are opened at once.
 *
 * <p>One thread at a time may use it.
 */
public final class LateFile extends OutputStream {

    private final Path path;
    private final boolean overwrite;
    private volatile OutputStream file;

    /** @throws InputException if it cannot be written, or exists and is not to be overwritten */
    public LateFile(Path path, boolean overwrite) {
        this.path = path;
        this.overwrite = overwrite;
        OutputFiles.check(path, overwrite);
        if (Files.exists(path, LinkOption.NOFOLLOW_LINKS) && !Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
            file = OutputFiles.open(path, overwrite);
            return;
        }
        String problem = problem(path);
        if (problem != null) {
            throw new InputException(path + ": cannot be written: " + problem);
        }
    }

    /** Returns why a file could not be made or replaced, {@code null} if nothing is in the way. */
    private static String problem(Path path) {
        Path folder = path.toAbsolutePath().getParent();
        try {
            Files.readAttributes(path, BasicFileAttributes.class);
            return Files.isWritable(path) ? null : "no permission";
        } catch (NoSuchFileException missing) {
            return folder != null && Files.isDirectory(folder) && !Files.isWritable(folder) ? "no permission"
                : triedProblem(path);
        } catch (IOException unusable) {
            return OutputFiles.reason(path, unusable);
        }
    }

    /** Makes the file and removes it at once: some file systems refuse what permissions allow. */
    private static String triedProblem(Path path) {
        try {
            Files.createFile(path);
            Files.delete(path);
            return null;
        } catch (IOException problem) {
            return OutputFiles.reason(path, problem);
        }
    }

    @Override
    public void write(int one) throws IOException {
        write(new byte[] {(byte) one}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
        if (file == null && length > 0) {
            try {
                file = OutputFiles.create(path, overwrite);
            } catch (FileAlreadyExistsException other) {
                throw new IOException("it exists by now", other);
            } catch (IOException problem) {
                throw new IOException(OutputFiles.reason(path, problem), problem);
            }
        }
        if (length > 0) {
            file.write(bytes, from, length);
        }
    }

    /** True if it has been made: from then on it is this program's. */
    public boolean isMade() {
        return file != null;
    }

    @Override
    public void flush() throws IOException {
        if (file != null) {
            file.flush();
        }
    }

    @Override
    public void close() throws IOException {
        if (file != null) {
            file.close();
        }
    }
}
