package steward.bot.isolation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** User and group of a bot in its namespaces: the same as outside, except that root becomes an unprivileged number. */
final class UserNumbers {

    private static final int NOBODY = 65534;

    /** True if this program runs as root, whose files and rights a bot would share. */
    static boolean isRoot() {
        return number("unix:uid") == 0;
    }

    static int userInside() {
        int own = number("unix:uid");
        return own == 0 ? NOBODY : own;
    }

    static int groupInside() {
        int own = number("unix:gid");
        return own == 0 ? NOBODY : own;
    }

    /** True if the system has a name for the user inside. */
    static boolean hasName() {
        return !nameInside().equals("?");
    }

    static String nameInside() {
        return isRoot() ? "nobody" : System.getProperty("user.name");
    }

    private static int number(String attribute) {
        try {
            return (Integer) Files.getAttribute(Path.of("/proc/self"), attribute);
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException unknown) {
            return NOBODY;
        }
    }
}
