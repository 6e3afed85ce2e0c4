package steward.contest;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import steward.files.InputException;
import steward.files.LateFile;
import steward.replay.WriteBehind;

/**
 * Output file for the replay of one game, which remembers its write error and is never left behind empty. The file is
 * created together with its first line. So after {@code kill -9} every existing file can be verified up to its cut,
 * except one killed between the two system calls: that one is empty.
 */
public final class ReplayFile extends WriteBehind {

    private final Path path;
    private final LateFile file;

    /** @throws InputException if it cannot be opened, or exists and is not to be overwritten */
    public ReplayFile(Path path, boolean overwrite) {
        this(path, new LateFile(path, overwrite));
    }

    private ReplayFile(Path path, LateFile file) {
        super(file);
        this.path = path;
        this.file = file;
    }

    /** Closes the file; a failure to write is remembered, see {@link #problem}, and nothing is thrown. */
    @Override
    public void close() {
        try {
            super.close();
        } catch (IOException remembered) {
            return;
        }
    }

    /** Describes the failure of the file, and its fate; {@code null} if there was none. */
    public String problem() {
        if (failure() == null) {
            return null;
        }
        String what = path + ": cannot be written: " + failure().getMessage();
        if (!exists()) {
            return what + "; it had no turn, and is removed";
        }
        return isOurs() ? what + "; the turns before are in it" : what;
    }

    /** True if anything went wrong with the file. */
    public boolean isBroken() {
        return failure() != null;
    }

    /** When it is closed: removes a file that has no turn. */
    public void removeIfEmpty() {
        if (isOurs() && !hasTurn()) {
            remove();
        }
    }

    /** True if the file was made here: what others have made, devices and links stay. */
    private boolean isOurs() {
        return file.isMade() && Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS);
    }

    /** True if there is a complete line after that of the header. */
    private boolean hasTurn() {
        byte[] bytes = new byte[1 << 13];
        int lines = 0;
        try (InputStream written = Files.newInputStream(path)) {
            for (int count = written.read(bytes); count >= 0; count = written.read(bytes)) {
                for (int k = 0; k < count; k++) {
                    lines += bytes[k] == '\n' ? 1 : 0;
                }
                if (lines >= 2) {
                    return true;
                }
            }
            return false;
        } catch (IOException unreadable) {
            return true;                               // unknown: it is kept, nothing recorded is lost
        }
    }

    /**
     * When it is closed: gives the file another name, replacing a file of that name.
     *
     * @return whether it has it: a device or a link stays
     * @throws IOException if that is not possible
     */
    boolean moveTo(Path other) throws IOException {
        if (isOurs()) {
            Files.move(path, other, StandardCopyOption.ATOMIC_MOVE);
            return true;
        }
        return false;
    }

    /** Removes the file, whatever is in it. */
    void remove() {
        try {
            if (isOurs()) {
                Files.delete(path);
            }
        } catch (IOException stays) {
            // It cannot be removed.
            return;
        }
    }

    /** True if there is a replay: the file was made, and has not been removed. */
    public boolean exists() {
        return file.isMade() && Files.exists(path);
    }

    Path path() {
        return path;
    }
}
