package steward.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Tests whether an executable in the Executable and Linkable Format has all segments that its header promises (System V
 * ABI, chapters 4 and 5). A stopped compiler, or a copy under way, leaves one that is cut off.
 */
public final class ElfFile {

    private static final int MAGIC = 0x7f454c46;
    private static final int HEADER = 64;

    private ElfFile() { }

    /** True if a file begins as such an executable and ends before its last segment does. */
    public static boolean isCutOff(Path file) {
        try (SeekableByteChannel channel = Files.newByteChannel(file)) {
            ByteBuffer header = read(channel, 0, HEADER);
            if (header.limit() < 4 || header.getInt(0) != MAGIC) {
                return false;
            }
            if (header.limit() < HEADER) {
                return true;
            }
            boolean wide = header.get(4) == 2;
            header.order(header.get(5) == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
            long table = wide ? header.getLong(32) : header.getInt(28);
            int entry = header.getShort(wide ? 54 : 42);
            int count = header.getShort(wide ? 56 : 44);
            ByteBuffer entries = read(channel, table, entry * count).order(header.order());
            boolean cut = entries.limit() < entry * count;
            for (int at = 0; !cut && at < entries.limit(); at += entry) {
                long end = wide ? entries.getLong(at + 8) + entries.getLong(at + 32)
                    : (long) entries.getInt(at + 4) + entries.getInt(at + 16);
                cut = end > channel.size();
            }
            return cut;
        } catch (IOException | IllegalArgumentException | IndexOutOfBoundsException unreadable) {
            return false;
        }
    }

    private static ByteBuffer read(SeekableByteChannel channel, long from, int length) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(length);
        channel.position(from);
        int count = 0;
        while (count >= 0 && bytes.hasRemaining()) {
            count = channel.read(bytes);
        }
        return bytes.flip();
    }
}
