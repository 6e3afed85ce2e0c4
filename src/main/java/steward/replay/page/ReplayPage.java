package steward.replay.page;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.function.IntPredicate;
import java.util.zip.Deflater;
import java.util.zip.GZIPOutputStream;
import steward.game.GameTypes;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.scene.json.SceneException;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;

/**
 * HTML page of a replay, which shows the match and works offline. Page, styles, script and replay are in a single file.
 * The replay is embedded as gzip in base64, whose alphabet cannot end a script element; the browser unpacks it. A long
 * replay is packed further, see {@link PackedTurns}.
 *
 * <p>A replay that was cut off is embedded up to the cut, and the page says so.
 */
public final class ReplayPage {

    /** Characters of a server's line that a page shows. */
    private static final int LONGEST = 1000;

    private ReplayPage() { }

    /**
     * Returns the page.
     *
     * @param replay its bytes
     * @param source name of the replay, for errors
     * @param title  heading of the page, plain text
     * @param extras what it has besides the replay
     * @throws ReplayException if it is no replay, of a newer format, or damaged before its end
     */
    public static byte[] of(byte[] replay, String source, String title, PageExtras extras) {
        byte[] read = ReplayReader.asWritten(replay);
        String warning = check(read, source);
        byte[] whole = warning == null ? read : upToCut(read);
        PageTemplate page = PageTemplate.ofReplay(title, gameOf(read, source));
        page.put("meta", extras.meta(title));
        page.put("details", embedded(PageDetails.of(whole, source, extras.types())));
        page.put("policy", page.policy("'none'"));
        page.put("save", "");
        page.put("source", (warning == null ? "" : "data-warning=\"" + PageTemplate.escape(warning) + "\"")
            + differs(whole, source, extras.types()));
        return page.with(PackedTurns.of(whole));
    }

    /**
     * Returns the page of a match that is being played. It holds no replay but follows server-sent events: each event's
     * data is one line of the replay (header, turns, result), sent from the beginning to every client; the result ends
     * it, or an event of type {@code end}.
     *
     * @param title heading of the page, plain text
     * @param feed  address of the events, relative to the page
     * @param save  address under which the page as a file is found, relative to the page, or {@code null} for none
     */
    public static byte[] live(String title, String feed, String save) {
        PageTemplate page = PageTemplate.ofReplay(title, null);
        page.put("policy", page.policy("'self'"));
        page.put("save", save == null ? "" : "<a href=\"" + PageTemplate.escape(save) + "\" download>Save</a>");
        page.put("source", "data-feed=\"" + PageTemplate.escape(feed) + "\"");
        return page.with("");
    }

    /**
     * The page without a replay and without a title, for a page that puts several together by itself.
     *
     * @param before     the page up to the replay; <code>{{title}}</code> stands where the title goes, as HTML
     * @param after      the rest; <code>{{details}}</code> stands where the details go
     * @param scriptHash what the policy of the other page has to allow
     * @param styleHash  likewise
     */
    public record Shell(String before, String after, String scriptHash, String styleHash) { }

    public static Shell shell() {
        PageTemplate page = PageTemplate.ofReplay("", null);
        page.put("title", "{{title}}");
        page.put("policy", page.policy("'none'"));
        page.put("save", "");
        page.put("source", "");
        page.put("details", "{{details}}");
        return new Shell(page.before(), page.after(), page.scriptHash(), page.styleHash());
    }

    /**
     * A replay as it stands in a page, gzip in base64.
     *
     * @param details what the page has besides it, likewise
     */
    public record Embedded(String replay, String details) { }

    /**
     * Reads a replay for a page.
     *
     * @param types  games with which it is played again, so that the page has what bots were sent; or {@code null}
     * @param stderr whether what a player wrote there, and its command, may be seen; {@code null} for all
     * @throws IOException     if it cannot be read
     * @throws ReplayException if the file is no replay, of a newer format, or damaged before its end
     */
    public static Embedded embedded(Path replay, GameTypes types, IntPredicate stderr) throws IOException {
        byte[] bytes = ReplayReader.asWritten(Files.readAllBytes(replay));
        byte[] whole = check(bytes, replay.toString()) == null ? bytes : upToCut(bytes);
        byte[] seen = stderr == null ? whole : OwnStderr.of(whole, stderr);
        return new Embedded(PackedTurns.of(seen), embedded(PageDetails.of(seen, replay.toString(), types)));
    }

    /** Bytes as they stand in a page: gzip in base64. */
    static String embedded(byte[] bytes) {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        try {
            embed(bytes, text);
        } catch (IOException inMemory) {
            throw new UncheckedIOException(inMemory);
        }
        return text.toString(StandardCharsets.US_ASCII);
    }

    /** Attributes that tell from which turn on a server has shown another match, and in which line; or none. */
    private static String differs(byte[] replay, String source, GameTypes types) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            ReplayDifference found = types == null || !reader.imported() ? null
                : Verification.of(reader, types).difference();
            if (found == null) {
                return "";
            }
            ReplayDifference.Lines lines = found.lines() != null ? found.lines()
                : new ReplayDifference.Lines(found.recorded(), found.found());
            return " data-differs-from=\"" + found.turn() + "\" data-differs=\"" + PageTemplate.escape(
                "The server's game differs from here on: turn " + found.turn() + ", " + found.field() + "\nserver: "
                    + TextFormat.beginning(lines.server(), LONGEST) + "\nhere:   "
                    + TextFormat.beginning(lines.ours(), LONGEST)) + "\"";
        } catch (ReplayException | SceneException cannotBePlayedAgain) {
            return "";
        }
    }

    private static String gameOf(byte[] replay, String source) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            return reader.header() == null ? null : reader.header().game();
        }
    }

    /** Reads the replay to its end; returns where it was cut off, without the name of the file, or null. */
    private static String check(byte[] replay, String source) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), source)) {
            RecordedTurn turn;
            do {
                turn = reader.next();
            } while (turn != null);
            String warning = reader.warning();
            return warning != null && warning.startsWith(source + ": ")
                ? "This recording was " + warning.substring(source.length() + 2) + "." : warning;
        }
    }

    /** The replay without a line that was cut off; a complete last line without line end is kept, as by the reader. */
    private static byte[] upToCut(byte[] replay) {
        int end = replay.length;
        while (end > 0 && replay[end - 1] != '\n') {
            end--;
        }
        boolean isWhole = end == replay.length || isObject(Arrays.copyOfRange(replay, end, replay.length));
        return isWhole ? replay : Arrays.copyOf(replay, end);
    }

    private static boolean isObject(byte[] line) {
        try {
            new JsonLine("last line", line);
            return true;
        } catch (JacksonException problem) {
            return false;
        }
    }

    private static void embed(byte[] lines, OutputStream html) throws IOException {
        OutputStream base64 = Base64.getEncoder().wrap(new UnclosedOutputStream(html));
        try (OutputStream gzip = new SmallestGzip(base64)) {
            gzip.write(lines);
        }
    }

    private static final class SmallestGzip extends GZIPOutputStream {
        SmallestGzip(OutputStream out) throws IOException {
            super(out);
            def.setLevel(Deflater.BEST_COMPRESSION);
        }
    }
}
