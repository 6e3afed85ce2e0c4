package steward.bot.isolation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;

/** The call of {@code bwrap} for {@link SandboxLevel#STRICT}. */
final class StrictSandbox {

    /** A private folder for temporary files, the only one that a bot can write to. */
    static final String TEMPORARY = "/tmp";

    /** Where the bot's own launcher is inside. */
    static final String LAUNCHER = "/run/steward-launch";

    /** How much fits into the private folder for temporary files, in bytes. */
    private static final long TEMPORARY_BYTES = 64L << 20;

    private static final long PATIENCE_MS = 10_000;
    private static final long SHARED_BYTES = 64L << 20;

    private StrictSandbox() {
    }

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
     */
    static List<String> words(Isolation isolation, List<String> command, List<List<String>> others, Path launcher) {
        Path bwrap = ProgramFinder.find("bwrap");
        List<String> words = new ArrayList<>(List.of(bwrap == null ? "bwrap" : bwrap.toString(),
            "--unshare-user", "--uid", "" + UserNumbers.userInside(), "--gid", "" + UserNumbers.groupInside(),
            "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--cap-drop", "ALL",
            "--die-with-parent", "--new-session",
            "--ro-bind", "/", "/", "--proc", "/proc", "--dev", "/dev",
            "--size", "" + SHARED_BYTES, "--tmpfs", "/dev/shm", "--remount-ro", "/dev",
            "--size", "" + TEMPORARY_BYTES, "--tmpfs", TEMPORARY));
        if (launcher != null) {
            words.add("--as-pid-1");
        }
        if (NoUserNamespaces.POSSIBLE) {
            words.add("--disable-userns");
        }
        StrictView view = StrictView.of(command, others, isolation.visible());
        for (Path hidden : view.hidden()) {
            words.addAll(List.of("--tmpfs", hidden.toString()));
        }
        for (Map.Entry<Path, StrictView.Treatment> each : view.treated().entrySet()) {
            String path = each.getKey().toString();
            words.addAll(switch (each.getValue()) {
                case SHOW -> List.of("--ro-bind", path, path);
                case HIDE_FOLDER -> List.of("--tmpfs", path);
                case HIDE_FILE -> List.of("--ro-bind", "/dev/null", path);
            });
        }
        if (launcher != null) {
            words.addAll(List.of("--ro-bind", launcher.toString(), LAUNCHER));
        }
        String here = Path.of("").toAbsolutePath().toString();
        words.addAll(List.of("--dir", here));
        for (Path hidden : view.hidden()) {
            words.addAll(List.of("--remount-ro", hidden.toString()));
        }
        view.treated().forEach((path, treatment) -> {
            if (treatment == StrictView.Treatment.HIDE_FOLDER) {
                words.addAll(List.of("--remount-ro", path.toString()));
            }
        });
        words.addAll(List.of("--chdir", here, "--"));
        return words;
    }
}
