package steward.bot.isolation;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Locale that the launcher chose for this JVM because the user's has no UTF-8, without which a JVM can name only files
 * in ASCII. Programs that Steward starts get the user's own locale unless they need the chosen one.
 */
public final class ChosenLocale {

    private static final String VARIABLE = "LC_ALL";
    private static final String BEFORE = "steward.locale.before";

    private ChosenLocale() { }

    /** Returns its name, or {@code null} if none was chosen. */
    public static String name() {
        return System.getProperty("steward.locale");
    }

    /** Returns a variable as it was set for the launcher, or {@code null}. */
    public static String variable(String name) {
        return name() != null && name.equals(VARIABLE) ? System.getProperty(BEFORE) : System.getenv(name);
    }

    /** Returns the words before a command that is to have the chosen locale as well; none where none was chosen. */
    public static List<String> words() {
        return name() == null ? List.of() : List.of("env", VARIABLE + "=" + name());
    }

    /** Returns {@link #words} for a JVM that is started in a folder whose name it could not read without them. */
    public static List<String> wordsIn(Path folder) {
        return isAscii(folder) ? List.of() : words();
    }

    /** True if a program of Java that was started in this folder found no classes there for want of a locale. */
    public static boolean hidesClassesIn(Path folder) {
        return name() != null && !isAscii(folder);
    }

    private static boolean isAscii(Path folder) {
        return folder.toAbsolutePath().toString().chars().allMatch(each -> each < 128);
    }

    /** Puts back what was set for the launcher. */
    static void undo(Map<String, String> variables) {
        if (name() != null) {
            variables.remove(VARIABLE);
            if (System.getProperty(BEFORE) != null) {
                variables.put(VARIABLE, System.getProperty(BEFORE));
            }
        }
    }
}
