package steward.live;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Host names that a request may use for this server, as protection against DNS rebinding. A foreign page can have its
 * own name resolved to this machine and could then read what is served here; the {@code Host} header reveals that name.
 * A numeric address cannot be rebound, so numeric addresses are accepted.
 *
 * @param given the name or address that the server was told to listen on
 * @param port  the server's port
 */
record AllowedHosts(String given, int port) {

    private static final Pattern HOST = Pattern.compile("(\\[[0-9a-f:.]+]|[^:\\[\\]]+)(?::(\\d{1,5}))?");
    private static final Pattern ADDRESS = Pattern.compile("\\[.*]|\\d{1,3}(\\.\\d{1,3}){3}");
    private static final String USUAL_PORT = "80";

    /** @param header the value of the header {@code Host}, or {@code null} */
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
