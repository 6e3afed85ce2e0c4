package steward.bot.process;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Debugger that is started in place of a bot. A debugger reads its own commands from the input on which the bot expects
 * its frames. So the debugger gets the terminal, and its bot gets the two pipes, which are kept as descriptors 3 and 4
 * in the meantime.
 */
public final class Debugger {

    private static final Pattern GDB = Pattern.compile("(.*/)?([a-z0-9_]+-)*gdb(-multiarch)?");

    /** Without a terminal there is no input, and output goes to stderr: for calls with -batch. */
    private static final String TERMINAL = "exec 3<&0 4>&1; if (: </dev/tty) 2>/dev/null; "
        + "then exec </dev/tty >/dev/tty; else exec </dev/null >&2; fi; exec \"$@\"";

    /** How the debugger is to start the bot. */
    private static final String WRAPPER = "set exec-wrapper sh -c 'exec \"$@\" <&3 >&4 3<&- 4>&-' sh";

    private Debugger() { }

    /** True if a command starts a supported debugger: gdb. */
    public static boolean is(List<String> command) {
        return GDB.matcher(command.get(0)).matches();
    }

    /** The command that starts the debugger on the terminal. */
    public static List<String> onTerminal(List<String> command) {
        List<String> words = new ArrayList<>(List.of("sh", "-c", TERMINAL, "sh", command.get(0), "-iex", WRAPPER));
        words.addAll(command.subList(1, command.size()));
        return words;
    }
}
