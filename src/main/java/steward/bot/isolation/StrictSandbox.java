package steward.bot.isolation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;

/** Call of {@code bwrap} for {@link SandboxLevel#STRICT}. */
final class StrictSandbox {

    /** A private folder for temporary files, the only one that a bot can write to. */
    static final String TEMPORARY = "/tmp";

    /** Where the bot's own launcher is inside. */
    static final String LAUNCHER = "/run/steward-launch";

    /** Bytes that fit into the private folder for temporary files. */
    private static final long TEMPORARY_BYTES = 64L << 20;

    private static final long PATIENCE_MS = 10_000;

    /** From bwrap 0.8 on. In a user namespace of its own a bot could mount control groups, and end the match there. */
    private static final class NoUserNamespaces {
        static final boolean POSSIBLE = find();

        private static boolean find() {
            try {
                return ProgramFinder.find("bwrap") != null && ProgramTrial.of(List.of("bwrap", "--unshare-user",
                    "--disable-userns", "--ro-bind", "/", "/", "true"), PATIENCE_MS).works();
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
                return false;
            }
        }
    }

    /**
     * The words up to the command.
     *
     * @param launcher the program that is the first process inside, or {@code null} if that is bwrap itself; a bot can
     *                 attach to bwrap and so outlive a referee that is killed, while it cannot attach to the launcher
     * @param group    the control group that limits the bot, shown so that a JVM knows its memory; or {@code null}
     */
    static List<String> words(Isolation isolation, Program bot, List<Program> others, Path launcher, Path group) {
        Path bwrap = ProgramFinder.find("bwrap");
        List<String> words = new ArrayList<>(List.of(bwrap == null ? "bwrap" : bwrap.toString(),
            "--unshare-user", "--uid", "" + UserNumbers.userInside(), "--gid", "" + UserNumbers.groupInside(),
            "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--cap-drop", "ALL",
            "--die-with-parent", "--new-session",
            "--proc", "/proc", "--remount-ro", "/proc", "--dev", "/dev",
            "--size", "" + Launch.SHARED_BYTES, "--tmpfs", Launch.SHARED.toString(), "--remount-ro", "/dev",
            "--size", "" + TEMPORARY_BYTES, "--tmpfs", TEMPORARY));
        if (launcher != null) {
            words.add("--as-pid-1");
        }
        if (NoUserNamespaces.POSSIBLE) {
            words.add("--disable-userns");
        }
        List<String> hidden = new ArrayList<>();
        StrictView.of(bot, others, isolation).entries().forEach((file, entry) -> {
            String path = file.toString();
            words.addAll(switch (entry.treatment()) {
                case SHOW -> List.of("--ro-bind", path, path);
                case LINK -> List.of("--symlink", entry.target().toString(), path);
                case EMPTY_FOLDER -> List.of("--dir", path);
                case HIDE_FOLDER -> List.of("--tmpfs", path);
                case HIDE_FILE -> List.of("--ro-bind", "/dev/null", path);
            });
            if (entry.treatment() == StrictView.Treatment.HIDE_FOLDER) {
                hidden.addAll(List.of("--remount-ro", path));
            }
        });
        if (launcher != null) {
            words.addAll(List.of("--ro-bind", launcher.toString(), LAUNCHER));
        }
        if (group != null) {
            words.addAll(List.of("--unshare-cgroup-try", "--ro-bind", group.toString(), "/sys/fs/cgroup"));
        }
        words.addAll(hidden);
        words.addAll(List.of("--remount-ro", "/", "--chdir", bot.folder().toString(), "--"));
        return words;
    }
}
