package steward.bot.process;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import steward.bot.isolation.Launch;

/**
 * Small process beside this JVM that kills remaining bots after the JVM has ended for any reason. It reads orders from
 * a pipe, and at the end of the pipe it kills all targets on its list. It also kills on demand, which saves starting a
 * program: Java itself cannot signal a process group.
 *
 * <p>It is a shell that uses only built-in commands. It has a session of its own, so that a Ctrl-C at the terminal does
 * not reach it, and ignores every signal that can be ignored. Its list holds only the running bots and stays small.
 *
 * <p>At the end it also removes the folder of {@link HoldFolder} and any files for stderr that still have names. It
 * kills every process that has one of these files as its own stderr: such a process has left its group, and would fill
 * a file without a name for ever.
 *
 * <p>A target is an argument of the {@code kill} command: a process number, or minus the number of a group. If the
 * sentinel has died, a new one is given the whole list; without a shell, an external {@code kill} is used.
 */
final class Sentinel {

    /*
     * + adds a target; - removes it; s stops it; c lets it go on; k removes and kills it, and reports whether there was
     * anything to kill; f
     * adds the number of a file for stderr or of a folder for sockets, and u removes it. At the end of the pipe, a
     * group may not exist although its process does: the process was just started and is about to make the group. That
     * case is tried several times.
     */
    private static final String SCRIPT = """
        trap '' HUP INT QUIT TERM PIPE ALRM USR1 USR2 TSTP TTIN TTOU
        cd /
        known=' '
        files=' '
        forget() {
          case $known in *" $1 "*) known="${known%%" $1 "*} ${known#*" $1 "}" ;; esac
        }
        while read -r order target; do
          case $order in
            +) known="$known$target " ;;
            -) forget "$target" ;;
            s) kill -s STOP -- "$target" ;;
            c) kill -s CONT -- "$target" ;;
            f) files="$files$target " ;;
            u) case $files in *" $target "*) files="${files%%" $target "*} ${files#*" $target "}" ;; esac ;;
            k) forget "$target"; kill -s KILL -- "$target"; echo $? ;;
          esac
        done
        for target in $known; do
          tries=0
          until kill -s KILL -- "$target" || [ ! -d "/proc/${target#-}" ] || [ $tries -ge 20000 ]; do
            tries=$((tries + 1))
          done
        done
        for file in $files; do
          rm -rf -- "$1/steward-$file.stderr" "$1/steward-$file.hold"
          for holder in /proc/[0-9]*; do
            if [ -f "$holder/fd/2" ]; then
              case $(readlink "$holder/fd/2") in
                */steward-"$file".stderr*) kill -s KILL "${holder#/proc/}" ;;
              esac
            fi
          done
        done
        """;

    /** How long the sentinel may take to report a kill, in nanoseconds, before it is considered dead. */
    private static final long REPORT_NANOS = 500_000_000;

    /** How long a report is awaited by spinning, in nanoseconds: it usually comes sooner than a sleep would end. */
    private static final long SPIN_NANOS = 100_000;

    private static final long EXTERNAL_KILL_MS = 1000;

    private final Set<String> targets = new LinkedHashSet<>();
    private final Set<String> files = new LinkedHashSet<>();
    private Process process;
    private OutputStream orders;
    private InputStream reports;

    private static final class Shared {
        static final Sentinel INSTANCE = new Sentinel();
    }

    static Sentinel shared() {
        return Shared.INSTANCE;
    }

    /** Starts the process unless it is running. */
    synchronized void start() {
        if (process != null && process.isAlive()) {
            return;
        }
        List<String> command = new ArrayList<>(Launch.ownSession());
        command.addAll(List.of("sh", "-c", SCRIPT, "steward-sentinel", StderrFile.folder().toString()));
        try {
            process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
            orders = process.getOutputStream();
            reports = process.getInputStream();
            for (String target : targets) {
                write("+ " + target);
            }
            for (String file : files) {
                write("f " + file);
            }
        } catch (IOException e) {
            process = null;
        }
    }

    /** From now on the target is killed when this JVM ends. */
    synchronized void watch(String target) {
        targets.add(target);
        tell("+ " + target);
    }

    /** Removes the target from the list without killing it. */
    synchronized void forget(String target) {
        targets.remove(target);
        tell("- " + target);
    }

    /** From now on a file for stderr is removed when this JVM ends, by its number; it need not exist yet. */
    synchronized void watchFile(String number) {
        files.add(number);
        tell("f " + number);
    }

    /** The file is gone, and so is what wrote to it. */
    synchronized void forgetFile(String number) {
        files.remove(number);
        tell("u " + number);
    }

    private void tell(String order) {
        if (!order(order)) {
            start();
        }
    }

    /** Kills the target and removes it from the list. @return whether there was anything to kill */
    synchronized boolean kill(String target) {
        targets.remove(target);
        int status = order("k " + target) ? report() : -1;
        if (status >= 0) {
            return status == 0;
        }
        dismiss();
        boolean found = killExternally(target);
        start();
        return found;
    }

    /** Stops the target, or lets it go on; without a sentinel nothing happens. */
    synchronized void pause(String target, boolean stop) {
        if (!order((stop ? "s " : "c ") + target)) {
            start();
            order((stop ? "s " : "c ") + target);
        }
    }

    /** The process number, or -1 without a process. */
    synchronized long pid() {
        return process == null ? -1 : process.pid();
    }

    /** Returns how many targets are on the list. */
    synchronized int size() {
        return targets.size();
    }

    /** Closes the pipe, as the end of this JVM does: the sentinel kills all targets and exits. */
    synchronized void endOrders() throws IOException {
        orders.close();
    }

    /** Sends an order; returns whether it was sent. */
    private boolean order(String line) {
        if (process == null) {
            return false;
        }
        try {
            write(line);
            return true;
        } catch (IOException e) {
            dismiss();
            return false;
        }
    }

    private void write(String line) throws IOException {
        orders.write((line + "\n").getBytes(StandardCharsets.US_ASCII));
        orders.flush();
    }

    /** The status of the ordered kill, or -1 if no report came. */
    private int report() {
        long start = Watchdog.now();
        int status = 0;
        try {
            for (;;) {
                if (reports.available() > 0) {
                    int digit = reports.read();
                    if (digit == '\n') {
                        return status;
                    }
                    status = 10 * status + digit - '0';
                } else {
                    long waited = Watchdog.now() - start;
                    if (waited < SPIN_NANOS) {
                        Thread.yield();
                    } else if (waited > REPORT_NANOS || !process.isAlive()) {
                        return -1;
                    } else {
                        LockSupport.parkNanos(20_000);
                    }
                }
            }
        } catch (IOException e) {
            return -1;
        }
    }

    /** Kills a sentinel that does not respond, before it can see the end of its orders. */
    synchronized void dismiss() {
        if (process != null) {
            process.toHandle().destroyForcibly();
            process.destroyForcibly();
            process = null;
        }
    }

    private static boolean killExternally(String target) {
        try {
            Process kill = new ProcessBuilder("kill", "-KILL", "--", target)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(ProcessBuilder.Redirect.DISCARD).start();
            return kill.waitFor(EXTERNAL_KILL_MS, TimeUnit.MILLISECONDS) && kill.exitValue() == 0;
        } catch (IOException e) {
            return false;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}
