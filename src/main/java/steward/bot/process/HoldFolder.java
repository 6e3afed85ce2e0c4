package steward.bot.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.ThreadLocalRandom;
import steward.bot.hold.HoldSocket;

/**
 * Private folder of this JVM for the sockets through which bots are held. Only its user can enter it, and no bot can
 * see it. The {@link Sentinel} removes it when this JVM has ended.
 */
final class HoldFolder {

    private Path folder;

    private HoldFolder() { }

    private static final class Shared {
        static final HoldFolder INSTANCE = new HoldFolder();
    }

    /** The folder of this JVM; it is made with the first socket. */
    static HoldFolder shared() {
        return Shared.INSTANCE;
    }

    /** A new socket in it, or {@code null} where there can be none. */
    synchronized HoldSocket socket() {
        try {
            if (folder == null || !Files.isDirectory(folder)) {
                folder = create();
            }
            return HoldSocket.in(folder);
        } catch (IOException | UnsupportedOperationException none) {
            return null;
        }
    }

    private static Path create() throws IOException {
        String number = Long.toUnsignedString(ThreadLocalRandom.current().nextLong(), Character.MAX_RADIX);
        // Known before it exists: a referee that is killed in between leaves none behind.
        Sentinel.shared().watchFile(number);
        return Files.createDirectory(StderrFile.folder().toRealPath().resolve("steward-" + number + ".hold"),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    }
}
