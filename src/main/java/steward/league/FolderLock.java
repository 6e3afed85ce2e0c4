package steward.league;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.StandardOpenOption;
import steward.files.InputException;
import steward.files.OutputFiles;

/**
 * Lock that lets only one run at a time write to a league. It is a lock of the operating system, which is released when
 * the process ends, however that happens. The file contains the id of the process; without the lock that id means
 * nothing.
 */
public final class FolderLock implements AutoCloseable {

    private static final int LONGEST = 100;

    private final FileChannel channel;

    private FolderLock(FileChannel channel) {
        this.channel = channel;
    }

    /** @throws InputException if another process has it, or the file cannot be written */
    public static FolderLock take(LeagueFolder folder) {
        FileChannel channel = null;
        try {
            channel = FileChannel.open(folder.lock(), StandardOpenOption.READ, StandardOpenOption.WRITE,
                StandardOpenOption.CREATE);
            FileLock lock = channel.tryLock();
            if (lock == null) {
                throw taken(folder, holder(channel));
            }
            channel.truncate(0);
            channel.write(ByteBuffer.wrap((ProcessHandle.current().pid() + "\n").getBytes(StandardCharsets.UTF_8)), 0);
            return new FolderLock(channel);
        } catch (OverlappingFileLockException same) {
            throw taken(folder, Long.toString(ProcessHandle.current().pid()));
        } catch (InputException refused) {
            close(channel);
            throw refused;
        } catch (IOException problem) {
            close(channel);
            throw new InputException(folder.lock() + ": cannot be written: "
                + OutputFiles.reason(folder.lock(), problem));
        }
    }

    private static InputException taken(LeagueFolder folder, String process) {
        return new InputException(folder.path() + ": found a league that is being played by process "
            + (process.isEmpty() ? "of unknown id" : process) + ", expected one run at a time");
    }

    private static String holder(FileChannel channel) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(LONGEST);
        channel.read(bytes, 0);
        return new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8).strip();
    }

    private static void close(FileChannel channel) {
        try {
            if (channel != null) {
                channel.close();
            }
        } catch (IOException gone) {
            return;
        }
    }

    @Override
    public void close() {
        close(channel);
    }
}
