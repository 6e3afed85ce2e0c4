package steward.live;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Which names a request may call this server by. A page from elsewhere can have its own name resolved to this machine
 * (DNS rebinding) and would then be allowed to read what is served here; the name it asks for gives it away. A numeric
 * address cannot be rebound, so those are fine.
 *
 * @param given the name or address that the server was told to listen on
 * @param port  where it listens
 */
record AllowedHosts(String given, int port) {

    private static final Pattern HOST = Pattern.compile("(\\[[0-9a-f:.]+]|[^:\\[\\]]+)(?::(\\d{1,5}))?");
    private static final Pattern ADDRESS = Pattern.compile("\\[.*]|\\d{1,3}(\\.\\d{1,3}){3}");
    private static final String USUAL_PORT = "80";

    /** @param header the header {@code Host}, or {@code null} if there is none */
    boolean accept(String header) {
        Matcher host = HOST.matcher(header == null ? "" : header.toLowerCase(Locale.ROOT));
        if (!host.matches()) {
            return false;
        }
        String name = host.group(1);
        String asked = host.group(2) == null ? USUAL_PORT : host.group(2);
        boolean known = name.equals("localhost") || name.equals(given.toLowerCase(Locale.ROOT))
            || ADDRESS.matcher(name).matches();
        return known && Integer.parseInt(asked) == port;
    }
}
