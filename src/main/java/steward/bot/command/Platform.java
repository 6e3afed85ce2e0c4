package steward.bot.command;

import java.util.Locale;
import java.util.regex.Pattern;

/** Platforms for which programs are made, written as system and processor, such as {@code linux-aarch64}. */
public final class Platform {

    /** Form of a platform, in words. */
    public static final String FORM = "a platform such as linux-x86_64 or linux-aarch64: linux, macos or windows, and "
        + "x86_64, aarch64, arm, loongarch64, ppc64le, riscv64, s390x or x86";

    private static final Pattern WRITTEN = Pattern.compile(
        "(linux|macos|windows)-(x86_64|aarch64|arm|loongarch64|ppc64le|riscv64|s390x|x86)");

    private Platform() { }

    /** True if a text names a platform. */
    public static boolean isWritten(String text) {
        return WRITTEN.matcher(text).matches();
    }

    public static String here() {
        return of(System.getProperty("os.name", ""), System.getProperty("os.arch", ""));
    }

    /** Returns the platform by the names that Java gives to system and processor. */
    static String of(String system, String processor) {
        String name = system.toLowerCase(Locale.ROOT);
        String written = name.startsWith("mac") ? "macos" : name.startsWith("windows") ? "windows" : name;
        return written + "-" + switch (processor) {
            case "amd64" -> "x86_64";
            case "i386", "i686" -> "x86";
            default -> processor;
        };
    }
}
