package steward.bot.isolation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.command.Program;
import steward.bot.hold.HoldPolicy;

/**
 * Settings with which bots are started: the isolation level, and the limits and files that bots get in it.
 *
 * @param level       which works on this machine, see {@link SandboxSupport}
 * @param network     whether the loopback device of a network namespace is brought up
 * @param limits      what a bot may use at most; none at {@link SandboxLevel#OFF}
 * @param environment which variables it inherits
 * @param visible     files and folders that {@link SandboxLevel#STRICT} lets it see besides its own; absolute
 * @param hidden      files and folders that it hides also in folders that it shows, unless the bot's command names
 *                    them; absolute
 * @param hold        which bots are stopped while others are asked, see {@link #holds}
 */
public record Isolation(SandboxLevel level, boolean network, ResourceLimits limits, BotEnvironment environment,
                        List<Path> visible, List<Path> hidden, HoldPolicy hold) {

    /** Nothing but a process group of its own, and an environment without secrets. */
    public static final Isolation OFF = at(SandboxLevel.OFF);

    /** @throws IllegalArgumentException if there are limits and nothing that holds them */
    public Isolation {
        visible = List.copyOf(visible);
        hidden = List.copyOf(hidden);
        if (level == SandboxLevel.OFF && !limits.isNone()) {
            throw new IllegalArgumentException("limits at level off, expected light or strict with them");
        }
    }

    /** The usual at a level. */
    public static Isolation at(SandboxLevel level) {
        return new Isolation(level, false, level == SandboxLevel.STRICT ? ResourceLimits.STRICT : ResourceLimits.NONE,
            BotEnvironment.USUAL, List.of(), List.of(), HoldPolicy.BURNERS);
    }

    /** The usual at the level that is usual on this machine; the first call may try it, which starts a program. */
    public static Isolation usual() {
        return at(SandboxSupport.usual());
    }

    /** Level, limits and what was let through in words, the level first: what is signed with a replay. */
    public String text() {
        return level.word() + ", memory " + limits.memory() + ", processes " + limits.processes() + ", file size "
            + limits.fileSize() + ", open files " + limits.openFiles() + (network ? ", network" : "")
            + (visible.isEmpty() ? "" : ", visible " + visible.size());
    }

    public Isolation withoutMemoryLimit() {
        return new Isolation(level, network, limits.withoutMemory(), environment, visible, hidden, hold);
    }

    /** A copy that lets {@link SandboxLevel#STRICT} see these files and folders as well. */
    public Isolation showing(List<Path> paths) {
        List<Path> all = new ArrayList<>(visible);
        all.addAll(paths);
        return new Isolation(level, network, limits, environment, all, hidden, hold);
    }

    /** Returns this isolation with these files and folders hidden as well. */
    public Isolation hiding(List<Path> paths) {
        List<Path> all = new ArrayList<>(hidden);
        all.addAll(paths);
        return new Isolation(level, network, limits, environment, visible, all, hold);
    }

    /** Returns this isolation with other bots' files hidden: those that make them what they are. */
    public Isolation hidingFilesOf(List<Program> bots) {
        return hiding(bots.stream().flatMap(bot -> OwnFiles.brought(bot).stream())
            .filter(path -> !SystemFiles.isCommon(path)).toList());
    }

    public Isolation holding(HoldPolicy other) {
        return new Isolation(level, network, limits, environment, visible, hidden, other);
    }

    /**
     * Returns which bots are stopped in fact: at {@link SandboxLevel#OFF} burners are not, since bots there can hide
     * what they use.
     */
    public HoldPolicy holds() {
        return level == SandboxLevel.OFF && hold == HoldPolicy.BURNERS ? HoldPolicy.NEVER : hold;
    }
}
