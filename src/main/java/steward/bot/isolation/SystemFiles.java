package steward.bot.isolation;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * System paths that programs need in order to start at all: programs, libraries, and the settings of both. Nothing in
 * them is personal, and nothing of {@code /etc} is listed that holds a secret.
 */
final class SystemFiles {

    /** Where systems install programs; what another bot's command names there is nobody's secret. */
    private static final List<String> INSTALLED = List.of("/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32",
        "/usr/bin", "/usr/sbin", "/usr/games", "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libx32", "/usr/libexec",
        "/nix/store", "/gnu/store", "/run/current-system");

    /** Installed by hand, perhaps bots as well: these are hidden from their opponents. */
    private static final List<String> BY_HAND = List.of("/usr/share", "/usr/local/bin", "/usr/local/sbin",
        "/usr/local/lib", "/usr/local/lib32", "/usr/local/lib64", "/usr/local/libexec", "/usr/local/share");

    /** The loader, names of users, the time zone, certificates, and what interpreters read at their start. */
    private static final List<String> SETTINGS = List.of("alternatives", "ld.so.cache", "ld.so.conf", "ld.so.conf.d",
        "passwd", "group", "nsswitch.conf", "host.conf", "hosts", "protocols", "services", "localtime", "timezone",
        "os-release", "locale.alias", "mime.types", "fonts", "ssl/certs", "ssl/openssl.cnf", "pki/tls/certs",
        "pki/tls/openssl.cnf", "pki/java", "pki/ca-trust/extracted", "crypto-policies", "java", "dotnet", "mono",
        "perl", "php", "R", "julia");

    /** Of each version of Java on Debian, to which its own folder links. */
    private static final String JAVA = "java-";

    private static final class Found {
        static final List<Path> PATHS = Stream.of(INSTALLED.stream(), BY_HAND.stream(),
            SETTINGS.stream().map("/etc/"::concat), java()).flatMap(each -> each).map(Path::of).filter(Files::exists)
            .toList();
    }

    private static Stream<String> java() {
        String[] names = Path.of("/etc").toFile().list((folder, name) -> name.startsWith(JAVA));
        return names == null ? Stream.of() : Stream.of(names).sorted().map("/etc/"::concat);
    }

    /** Folders among them that are on this machine. */
    static List<Path> shown() {
        return Found.PATHS;
    }

    /** True if a path is part of the system, or of what was installed by hand. */
    static boolean holds(Path path) {
        return isInstalled(path) || path.startsWith("/usr/local") && path.getNameCount() == 2
            || BY_HAND.stream().anyMatch(path::startsWith);
    }

    private static boolean isInstalled(Path path) {
        return path.startsWith("/etc") || path.startsWith("/dev") || path.startsWith("/proc")
            || INSTALLED.stream().anyMatch(path::startsWith);
    }

    /** True if a path that the arguments of a bot name is the system's, and no bot of somebody's among its folders. */
    static boolean isCommon(Path path) {
        boolean deep = path.startsWith("/usr/lib") || path.startsWith("/usr/libexec")
            || path.startsWith("/etc") && path.getNameCount() > 2;
        return isInstalled(path) && !deep;
    }
}
