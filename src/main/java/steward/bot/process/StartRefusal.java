package steward.bot.process;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Refusal of the operating system to start a program.
 *
 * @param status with which a shell would end; 0 if the refusal is not the program's doing, such as when this machine
 *               has no more processes, memory or descriptors
 * @param reason the system's words behind a colon, or empty
 */
record StartRefusal(int status, String reason) {

    /** Java's message: the number of the system's error, and the system's words. */
    private static final Pattern SYSTEM_ERROR = Pattern.compile("error[=:] ?(\\d+)[ ,(]+([^)]*)");
    /** The number of "No such file or directory". */
    private static final String NO_ENTRY = "2";
    /** ENOENT, ENOEXEC, EACCES, ENOTDIR, ETXTBSY, ELOOP: errors by a file that the system does not execute. */
    private static final Set<String> PROGRAM_ERRORS = Set.of(NO_ENTRY, "8", "13", "20", "26", "40");
    /** The statuses with which a shell, env or setsid ends that cannot find or execute a program. */
    private static final int NOT_FOUND = 127;
    private static final int NOT_EXECUTABLE = 126;

    /** @param message of the JDK */
    static StartRefusal of(String message) {
        Matcher system = SYSTEM_ERROR.matcher(message);
        if (!system.find()) {
            return new StartRefusal(0, "");
        }
        String error = system.group(1);
        return new StartRefusal(!PROGRAM_ERRORS.contains(error) ? 0 : error.equals(NO_ENTRY) ? NOT_FOUND
            : NOT_EXECUTABLE, ": " + system.group(2));
    }
}
