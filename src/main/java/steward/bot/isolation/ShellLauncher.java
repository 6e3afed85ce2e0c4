package steward.bot.isolation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;

/**
 * Launcher of bots in a sandbox by {@code setsid}, {@code unshare}, {@code setpriv} and a shell, if there is no
 * {@link NativeLauncher}; slower, with the same isolation.
 */
final class ShellLauncher {

    private static final String SIGNALS = "HUP INT QUIT TERM PIPE ALRM USR1 USR2 TSTP TTIN TTOU";

    /*
     * The outer shell is in the new namespaces but for that of processes, of which its first child becomes the first
     * process: the inner shell. Both let go of the bot's streams after the fork. A shell that does not wait for a child
     * at once gives it no input, and lets it ignore SIGINT and SIGQUIT: descriptor 3 and 'env' undo that. SIGQUIT stays
     * blocked, as it is in whatever a JVM starts, and is no more where a shell has waited for a child.
     */
    private static final String LIGHT = """
        trap '' %1$s
        %2$sexec 3<&0
        {
          {
            trap - %1$s
            %3$sexec %4$s "$@"
          } <&3 3<&- &
          exec </dev/null >/dev/null 2>&1 3<&-
          wait $!
          exit $?
        } &
        exec </dev/null >/dev/null 2>&1 3<&-
        wait $!
        exit $?
        """;

    private static final String OUTSIDE = "%sexec 3<&0 4>&1 </dev/null >/dev/null; exec \"$@\"";
    private static final String INSIDE = "%sexec <&3 >&4 3<&- 4>&-; exec \"$@\"";

    static List<String> off(Path controlGroup) {
        List<String> words = new ArrayList<>(Launch.ownSession());
        if (controlGroup != null) {
            words.addAll(List.of(program("sh"), "-c", join(controlGroup) + "exec \"$@\"", "steward-launch"));
        }
        return words;
    }

    static List<String> light(boolean network, ResourceLimits limits, Path controlGroup, boolean emptied,
                              List<String> closed) {
        List<String> words = new ArrayList<>(List.of(program("setsid"), program("unshare"), "--user",
            "--map-user=" + UserNumbers.userInside(), "--map-group=" + UserNumbers.groupInside(), "--keep-caps",
            "--pid", "--net", "--ipc", "--uts"));
        String mount = program("mount");
        List<String> mounts = new ArrayList<>(closed.stream().map(file -> CommandLine.quote(List.of(file))).map(file ->
            mount + " --bind " + file + " " + file + " && " + mount + " -o remount,bind,ro " + file).toList());
        if (emptied) {
            mounts.add(mount + " -t tmpfs -o nosuid,nodev,mode=1777,size=" + Launch.SHARED_BYTES + " tmpfs "
                + Launch.SHARED);
        }
        String made = mounts.isEmpty() ? "" : CommandLine.quote(List.of(program("sh"), "-c",
            String.join(" && ", mounts) + " && exec \"$@\"", "sh")) + " ";
        String last = program("unshare") + " --mount --mount-proc " + made + program("setpriv")
            + " --no-new-privs --ambient-caps=-all --inh-caps=-all --bounding-set=-all "
            + program("env") + " --default-signal=INT,QUIT --block-signal=QUIT";
        String loopback = network ? program("ip") + " link set lo up\n" : "";
        words.addAll(List.of(program("sh"), "-c", String.format(LIGHT, SIGNALS, join(controlGroup) + loopback,
            limits.shell(), last), "steward-launch"));
        return words;
    }

    static List<String> outside(Path controlGroup) {
        return List.of(program("setsid"), program("sh"), "-c", String.format(OUTSIDE, join(controlGroup)),
            "steward-launch");
    }

    static List<String> inside(ResourceLimits limits) {
        // Not by its path out here, which may be in a home and hidden.
        return List.of("/bin/sh", "-c", String.format(INSIDE, limits.shell()), "steward-launch");
    }

    private static String join(Path controlGroup) {
        return controlGroup == null ? "" : "echo 0 >'" + controlGroup.toString().replace("'", "'\\''") + "'\n";
    }

    /** By its path: the bot's variables need not lead there. */
    private static String program(String name) {
        Path file = ProgramFinder.find(name);
        return file == null ? name : file.toString();
    }
}
