package steward.bot.isolation;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Environment variables that a bot inherits. By default, at {@link SandboxLevel#STRICT}, it is a short list; at the
 * other levels it is all variables except those whose names look like secrets.
 *
 * @param clean whether it is the short list at every level
 * @param names of further variables that are passed, also secrets
 */
public record BotEnvironment(boolean clean, List<String> names) {

    /** The usual environment of each level. */
    public static final BotEnvironment USUAL = new BotEnvironment(false, List.of());

    /** Variables that programs need to find others, and to write text and dates as their user does. */
    private static final Set<String> SHORT_LIST = Set.of("PATH", "HOME", "USER", "LOGNAME", "SHELL", "LANG", "LANGUAGE",
        "TZ", "TERM", "TMPDIR", "JAVA_HOME");

    private static final String LOCALE = "LC_";

    public BotEnvironment {
        names = List.copyOf(names);
    }

    /** True if a name looks like that of a secret: has TOKEN, SECRET or PASSWORD in it, or ends with _KEY. */
    public static boolean isSecret(String name) {
        String upper = name.toUpperCase(Locale.ROOT);
        return upper.contains("TOKEN") || upper.contains("SECRET") || upper.contains("PASSWORD")
            || upper.endsWith("_KEY");
    }

    /** Removes what a bot does not inherit. */
    public void apply(Map<String, String> variables, SandboxLevel level) {
        variables.keySet().removeIf(name -> !passes(name, level));
        if (level == SandboxLevel.STRICT) {
            variables.computeIfPresent("TMPDIR", (name, folder) -> StrictSandbox.TEMPORARY);
        }
    }

    private boolean passes(String name, SandboxLevel level) {
        if (names.contains(name)) {
            return true;
        }
        return clean || level == SandboxLevel.STRICT ? SHORT_LIST.contains(name) || name.startsWith(LOCALE)
            : !isSecret(name);
    }
}
