package steward.replay.page;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.zip.GZIPInputStream;
import tools.jackson.databind.json.JsonMapper;

/** Writes pages for tests, of replays as they are or tampered with. */
public final class PageTestPages {

    private final Path folder;
    private int written;

    public PageTestPages(Path folder) {
        this.folder = folder;
    }

    /** A page of a replay. */
    public Path page(byte[] replay, String title) {
        return page(replay, title, PageExtras.NONE);
    }

    /** A page of a replay, with more than it. */
    public Path page(byte[] replay, String title, PageExtras extras) {
        Path page = folder.resolve("page-" + ++written + ".html");
        try {
            Files.write(page, ReplayPage.of(replay, "race.jsonl", title, extras));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return page;
    }

    /** A page that waits for turns, without a server that sends any. */
    public Path live(String title) {
        Path page = folder.resolve("page-" + ++written + ".html");
        try {
            Files.write(page, ReplayPage.live(title, "feed", null));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        return page;
    }

    /** The replay with every message that player 0 gives replaced. */
    static byte[] withMessage(byte[] replay, String message) {
        return replaced(replay, "\"messages\":\\[\"[^\"]*\"", "\"messages\":[" + quote(message));
    }

    /** The replay with everything that player 0 writes to stderr replaced. */
    static byte[] withStderr(byte[] replay, String stderr) {
        return replaced(replay, "\"stderr\":\\[\"[^\"]*\"", "\"stderr\":[" + quote(stderr));
    }

    /** Returns the replay within a page. */
    public static byte[] embedded(String page) {
        int from = page.indexOf('>', page.indexOf("type=\"application/octet-stream\"")) + 1;
        return unpacked(page.substring(from, page.indexOf("</script>", from)));
    }

    /** Returns the content of a packed text, as pages have them. */
    static byte[] unpacked(String text) {
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(Base64.getDecoder().decode(text)))) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static byte[] replaced(byte[] replay, String pattern, String by) {
        return new String(replay, StandardCharsets.UTF_8)
            .replaceAll(pattern, Matcher.quoteReplacement(by)).getBytes(StandardCharsets.UTF_8);
    }

    private static String quote(String text) {
        return JsonMapper.shared().writeValueAsString(text);
    }
}
