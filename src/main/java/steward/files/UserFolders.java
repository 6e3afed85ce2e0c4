package steward.files;

import java.nio.file.Path;

/** Folders of this program's user for cache, data and settings, by the XDG base directory specification. */
public final class UserFolders {

    private UserFolders() {
    }

    /** The user's home; {@code $HOME} where the system has no entry for the user, as in many containers. */
    public static Path home() {
        return home(System.getProperty("user.home", ""), System.getenv("HOME"));
    }

    /** @param entry of the system for this user; some versions of Java say {@code ?} where there is none */
    static Path home(String entry, String variable) {
        boolean other = entry.length() <= 1 && variable != null && !variable.isEmpty();
        return Path.of(other ? variable : entry);
    }

    /** Folder of this program for what can be made again. */
    public static Path cache() {
        return folder("XDG_CACHE_HOME", ".cache");
    }

    /**
     * Folder of this program in one of the user's folders.
     *
     * @param variable that may name the user's folder
     * @param usual    its path from the home otherwise
     */
    public static Path folder(String variable, String usual) {
        String given = System.getenv(variable);
        return (given != null && given.startsWith("/") ? Path.of(given) : home().resolve(usual)).resolve("steward");
    }
}
