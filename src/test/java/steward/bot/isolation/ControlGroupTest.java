package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.hold.HoldPolicy;

/** Texts that are written to the files of a control group; a folder stands in for the system's. */
class ControlGroupTest {

    @TempDir
    private Path folder;

    private Path group(String controllers, String enabled) throws IOException {
        Path group = Files.createDirectory(folder.resolve("group"));
        Files.writeString(group.resolve("cgroup.procs"), "");
        Files.writeString(group.resolve("cgroup.controllers"), controllers);
        Files.writeString(group.resolve("cgroup.subtree_control"), enabled);
        return group;
    }

    private static Isolation strict(long memory) {
        return new Isolation(SandboxLevel.STRICT, false, new ResourceLimits(memory, 64, 0, 0), BotEnvironment.USUAL,
            List.of(), List.of(), HoldPolicy.ALWAYS);
    }

    @Test
    void aGroupIsFoundByItsMountAndMembership() throws IOException {
        Path group = group("cpu memory pids", "memory pids");
        Path memberships = Files.writeString(folder.resolve("cgroup"), "4:memory:/elsewhere\n0::/group\n");
        Path mounts = Files.writeString(folder.resolve("mounts"),
            "tmpfs /sys/fs/cgroup tmpfs rw 0 0\ncgroup2 " + folder + " cgroup2 rw 0 0\n");
        assertEquals(new ControlGroup.Base(group, true), ControlGroup.Base.find(memberships, mounts));
        Files.writeString(mounts, "cgroup " + folder + " cgroup rw 0 0\n");
        assertNull(ControlGroup.Base.find(memberships, mounts));
    }

    @Test
    void withoutTheControllersItOnlyPauses() throws IOException {
        assertFalse(ControlGroup.Base.at(group("cpu io", ""), false).limits());
    }

    @Test
    void aGroupThatCannotHoldTheLimitsIsNotLeft() throws IOException {
        ControlGroup.Base base = ControlGroup.Base.at(group("memory pids", "memory pids"), false);
        // The system makes these files with a group; here writing them fails, and no half-limited group is left.
        assertNull(ControlGroup.in(base, strict(64L << 20)));
        ControlGroup pausing = ControlGroup.in(new ControlGroup.Base(base.folder(), false), strict(64L << 20));
        assertFalse(pausing.limits());
        assertFalse(pausing.pause(true), "there is no cgroup.freeze");
        assertTrue(Files.isDirectory(pausing.joinFile().getParent()));
        pausing.remove();
        assertFalse(Files.exists(pausing.joinFile().getParent()));
    }

    @Test
    void groupsOfRefereesThatHaveGoneAreRemoved() throws IOException {
        Path group = group("", "");
        Path old = Files.createDirectory(group.resolve("steward-99999999-1"));
        Path own = Files.createDirectory(group.resolve("steward-" + ProcessHandle.current().pid() + "-1"));
        ControlGroup.Base.at(group, false);
        assertFalse(Files.exists(old));
        assertTrue(Files.exists(own));
    }
}
