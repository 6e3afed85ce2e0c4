package steward.live;

import java.nio.charset.StandardCharsets;
import java.util.Map;

/** HTTP heads and refusals of the live pages' server, as bytes; each answer ends with its connection. */
final class Answers {

    static final int OK = 200;
    static final int BAD_REQUEST = 400;
    static final int FORBIDDEN = 403;
    static final int NOT_FOUND = 404;
    static final int WRONG_METHOD = 405;
    static final String HTML = "text/html; charset=utf-8";
    /** Figures for Prometheus, in its text format. */
    static final String FIGURES = "text/plain; version=0.0.4; charset=utf-8";
    static final String EVENTS = "text/event-stream";

    /** Types of files by the ends of their names; others are bytes. */
    private static final Map<String, String> TYPES = Map.of("js", "text/javascript; charset=utf-8", "html", HTML,
        "css", "text/css; charset=utf-8", "json", "application/json", "fnt", "text/xml", "png", "image/png",
        "jpg", "image/jpeg", "svg", "image/svg+xml");

    static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** Returns the type of a page by its path. */
    static String type(String path) {
        return path.equals("/metrics") ? FIGURES : HTML;
    }

    /**
     * The head: no caching, no embedding in frames, where the page's own policy, in a meta element, has no effect.
     *
     * @param length of the body, or -1 if it ends with the connection
     */
    static byte[] head(int status, String type, int length) {
        return bytes("HTTP/1.1 " + status + " " + (status == OK ? "OK" : "No") + "\r\nContent-Type: " + type
            + "\r\nConnection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
            + "X-Frame-Options: DENY\r\nContent-Security-Policy: frame-ancestors 'none'\r\n"
            + "Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\n"
            + (status == WRONG_METHOD ? "Allow: GET\r\n" : "")
            + (length < 0 ? "" : "Content-Length: " + length + "\r\n") + "\r\n");
    }

    /** The head of a file for a sandboxed frame of a page of this server: the frame may load from here alone. */
    static byte[] openHead(String path, int length) {
        return bytes("HTTP/1.1 200 OK\r\nContent-Type: "
            + TYPES.getOrDefault(path.substring(path.lastIndexOf('.') + 1), "application/octet-stream")
            + "\r\nConnection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
            + "Access-Control-Allow-Origin: *\r\nContent-Security-Policy: frame-ancestors 'self'; default-src 'self'"
            + " 'unsafe-inline' 'unsafe-eval' data: blob:\r\nReferrer-Policy: no-referrer\r\nContent-Length: "
            + length + "\r\n\r\n");
    }

    /** The whole answer to a request that is not granted. */
    static byte[][] refusal(int status, String why) {
        byte[] body = bytes(why + "\n");
        return new byte[][] {head(status, "text/plain; charset=utf-8", body.length), body};
    }

    /** Event for a viewer who is not admitted: a page cannot read the body of an answer that is not OK. */
    static byte[] refused(String why) {
        return bytes("event: refused\ndata: " + why + "\n\n");
    }
}
