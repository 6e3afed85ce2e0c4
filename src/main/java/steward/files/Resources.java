package steward.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** Files that come with the program, read by their absolute names on the class path. */
public final class Resources {

    private Resources() { }

    /** @throws IllegalStateException if it is missing */
    public static byte[] bytes(String name) {
        try (InputStream in = Resources.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the program is not whole: " + name + " is missing");
            }
            return in.readAllBytes();
        } catch (IOException problem) {
            throw new IllegalStateException("the program is not whole: " + name, problem);
        }
    }

    /** Returns a text whose lines all end with {@code \n}, whatever the system was that it was built on. */
    public static String text(String name) {
        return new String(bytes(name), StandardCharsets.UTF_8).replace("\r\n", "\n");
    }
}
