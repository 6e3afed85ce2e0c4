package steward.bot.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class MountTableTest {

    private static final String TABLE = """
        /dev/sda1 / ext4 rw,relatime 0 0
        tmpfs /tmp tmpfs rw,nosuid,nodev,noexec 0 0
        tmpfs /tmp/build tmpfs rw,relatime 0 0
        /dev/sdb1 /media/my\\040stick vfat rw,noexec,relatime 0 0
        tmpfs /twice tmpfs rw,noexec 0 0
        tmpfs /twice tmpfs rw 0 0
        odd
        """;

    @Test
    void theInnermostMountDecides() {
        assertNull(MountTable.noexec(TABLE, Path.of("/home/bot")));
        assertEquals("/tmp", MountTable.noexec(TABLE, Path.of("/tmp/a/bot")));
        assertNull(MountTable.noexec(TABLE, Path.of("/tmp/build/bot")));
        assertEquals("/tmp", MountTable.noexec(TABLE, Path.of("/tmp/builder")));
        assertEquals("/media/my stick", MountTable.noexec(TABLE, Path.of("/media/my stick/bot")));
        assertNull(MountTable.noexec(TABLE, Path.of("/twice/bot")));
        assertNull(MountTable.noexec("", Path.of("/bot")));
    }
}
