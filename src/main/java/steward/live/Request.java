package steward.live;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** HTTP request while it arrives, up to the empty line behind its headers. */
final class Request {

    private static final int MOST_BYTES = 16 << 10;
    private static final String END = "\r\n\r\n";

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private String[] lines;

    void add(ByteBuffer arrived) {
        byte[] all = new byte[Math.min(arrived.remaining(), MOST_BYTES + 1 - bytes.size())];
        arrived.get(all);
        bytes.writeBytes(all);
        String text = bytes.toString(StandardCharsets.ISO_8859_1);
        int end = text.indexOf(END);
        lines = end < 0 ? null : text.substring(0, end).split("\r\n");
    }

    boolean isComplete() {
        return lines != null;
    }

    boolean isTooLong() {
        return lines == null && bytes.size() > MOST_BYTES;
    }

    /** The words of the request line; three if it is one of HTTP. */
    String[] words() {
        return lines[0].split(" ");
    }

    /** The first value of a header, or {@code null}. */
    String header(String name) {
        String start = name.toLowerCase(Locale.ROOT) + ":";
        for (int k = 1; k < lines.length; k++) {
            if (lines[k].toLowerCase(Locale.ROOT).startsWith(start)) {
                return lines[k].substring(start.length()).strip();
            }
        }
        return null;
    }
}
