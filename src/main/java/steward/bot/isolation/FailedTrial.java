package steward.bot.isolation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/**
 * Explanation of why an isolation level does not work: the program's words, and known causes of exactly that error. A
 * setting of the machine is named only if it forbids the step that failed.
 *
 * @param switchedOff whether the kernel's switches for user namespaces are off
 * @param appArmor    whether AppArmor restricts them
 * @param container   whether this machine is a container
 */
record FailedTrial(boolean switchedOff, boolean appArmor, boolean container) {

    /** Making namespaces, and what is done in them first. */
    private static final Pattern STEP = Pattern.compile(
        "namespace|unshare|clone|[ug]id_?map|[ug]id map|setgroups|mount|/proc", Pattern.CASE_INSENSITIVE);
    private static final Pattern FORBIDDEN = Pattern.compile("Operation not permitted|Permission denied|No permissions",
        Pattern.CASE_INSENSITIVE);
    /** The kernel's words where a machine may have no user namespaces. */
    private static final String NO_MORE = "No space left on device";
    private static final Pattern TOO_OLD = Pattern.compile("unrecognized option|Unknown option");
    /** From here on the statuses mean that the bot of the trial could not be executed, and no step failed. */
    private static final int NOT_EXECUTED = 126;

    static FailedTrial here() {
        return new FailedTrial(isNumber("/proc/sys/user/max_user_namespaces", "0")
            || isNumber("/proc/sys/kernel/unprivileged_userns_clone", "0"),
            isNumber("/proc/sys/kernel/apparmor_restrict_unprivileged_userns", "1"),
            Files.exists(Path.of("/.dockerenv")) || Files.exists(Path.of("/run/.containerenv")));
    }

    /**
     * @param line   the first that the program wrote; empty for none
     * @param status of its exit
     */
    String reason(String line, int status) {
        String said = line.isEmpty() ? "status " + status : line;
        if (TOO_OLD.matcher(line).find()) {
            return said + "; it is too old";
        }
        boolean step = status < NOT_EXECUTED && STEP.matcher(line).find();
        boolean forbidden = step && FORBIDDEN.matcher(line).find();
        if (switchedOff && (forbidden || step && line.contains(NO_MORE))) {
            return "user namespaces are switched off on this machine (" + said + ")";
        }
        if (appArmor && forbidden) {
            return "AppArmor does not let programs make user namespaces (" + said + ")";
        }
        if (container && forbidden) {
            return "this is a container that does not let programs make namespaces (" + said + ")";
        }
        return said;
    }

    private static boolean isNumber(String file, String number) {
        try {
            return Files.readString(Path.of(file)).strip().equals(number);
        } catch (IOException none) {
            return false;
        }
    }
}
