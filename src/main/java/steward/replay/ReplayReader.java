package steward.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import steward.Internal;
import steward.match.OwnLimits;
import steward.match.Protocol;
import steward.replay.sign.SignerKey;
import steward.scene.Time;
import steward.scene.json.JsonProblem;
import tools.jackson.core.JacksonException;

/**
 * Reader of a replay, line by line, also if it is packed with gzip, has a byte order mark or Windows line ends. A file
 * that was cut off anywhere is read up to the cut: its last line, if it has no line end and is no complete object, is
 * dropped, and {@link #warning} says so, as it does if turns are missing.
 *
 * <p>Throws {@link ReplayException} if a file is no replay, has a newer format, is damaged before its end, has a line
 * that is too long, or a field that its format does not have at that place; {@link UncheckedIOException} if the file
 * cannot be read. Over 400 lines: each kind of line is read here, with the fields that it may have.
 */
public final class ReplayReader implements AutoCloseable {

    /**
     * The longest line that is read, in bytes: a header with 200,000 bodies, whose scene may have taken in 64 MiB of
     * CSV, with their drawing and their places.
     */
    static final int LONGEST_LINE = 1 << 27;

    private static final byte[] BYTE_ORDER_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    private static final byte[] GZIP = {0x1F, (byte) 0x8B};

    private static final VarHandle EIGHT_BYTES =
        MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.nativeOrder());
    private static final long ONES = 0x0101_0101_0101_0101L;
    private static final long LINE_FEEDS = '\n' * ONES;
    private static final long HIGH_BITS = 0x80 * ONES;

    private final String source;
    private final InputStream in;
    private final int longest;
    private final byte[] buffer = new byte[1 << 16];
    private int position;
    private int limit;
    private int lineNumber;
    private boolean lineEnded;

    private final ReplayHeader header;
    private final JsonLine headerLine;
    private int lastTurn;
    private String warning;
    private JsonLine result;
    private JsonLine signature;

    /**
     * Opens a file and reads its header.
     *
     * @throws IOException     if it is missing or cannot be read
     * @throws ReplayException if it is no replay
     */
    public static ReplayReader open(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new ReplayException(file + ": found a folder, expected a replay file");
        }
        InputStream in = Files.newInputStream(file);
        try {
            return new ReplayReader(in, file.toString());
        } catch (RuntimeException problem) {
            in.close();
            throw problem;
        }
    }

    /** @param source the name of the file, for errors */
    public ReplayReader(InputStream in, String source) {
        this(in, source, LONGEST_LINE);
    }

    /** @param longest how long a line may be, in bytes */
    ReplayReader(InputStream in, String source, int longest) {
        this.longest = longest;
        this.source = source;
        try {
            this.in = unpacked(in, true);
        } catch (IOException problem) {
            throw new UncheckedIOException(source + ": cannot read: " + problem.getMessage(), problem);
        }
        byte[] first = readLine();
        if (first == null) {
            throw new ReplayException(source + ": found an empty file, expected a replay");
        }
        if (!isSignature(first)) {
            throw new ReplayException(where() + ": found no replay header, expected a line that begins with "
                + ReplayHeader.SIGNATURE);
        }
        headerLine = parse(first);
        header = headerLine == null ? null : header(headerLine);
    }

    /** Returns the bytes of a replay as they were written, if git, gzip or an editor have changed them. */
    public static byte[] asWritten(byte[] replay) {
        try {
            byte[] bytes = unpacked(new ByteArrayInputStream(replay), true).readAllBytes();
            int count = 0;
            for (int k = 0; k < bytes.length; k++) {
                if (bytes[k] != '\r' || k + 1 == bytes.length || bytes[k + 1] != '\n') {
                    bytes[count++] = bytes[k];
                }
            }
            return Arrays.copyOf(bytes, count);
        } catch (IOException damaged) {
            return replay;
        }
    }

    /** The bytes of the replay: without a byte order mark, and unpacked if they were packed. */
    private static InputStream unpacked(InputStream in, boolean packed) throws IOException {
        PushbackInputStream found = new PushbackInputStream(in, BYTE_ORDER_MARK.length);
        byte[] first = found.readNBytes(BYTE_ORDER_MARK.length);
        if (Arrays.equals(first, BYTE_ORDER_MARK)) {
            return in;
        }
        found.unread(first);
        boolean zipped = packed && first.length > 1 && first[0] == GZIP[0] && first[1] == GZIP[1];
        return zipped ? unpacked(new GZIPInputStream(found, 1 << 16), false) : found;
    }

    /** True if the line begins like a replay; a line that was cut off needs to agree only as far as it goes. */
    private boolean isSignature(byte[] line) {
        byte[] signature = ReplayHeader.SIGNATURE.getBytes(StandardCharsets.UTF_8);
        int count = lineEnded ? signature.length : Math.min(signature.length, line.length);
        return line.length >= count && Arrays.equals(line, 0, count, signature, 0, count);
    }

    private static ReplayHeader header(JsonLine line) {
        int format = line.integer("format");
        if (format != ReplayHeader.FORMAT) {
            throw new ReplayException(line.where() + ": format: found " + format + ", expected "
                + ReplayHeader.FORMAT + (format > ReplayHeader.FORMAT ? ": a newer version of Steward wrote this replay"
                : "; formats 1 and 2 are no longer read"));
        }
        LineFields.HEADER.check(line);
        if (!line.text("angles").equals(ReplayHeader.ANGLES)) {
            throw new ReplayException(line.where() + ": angles: found " + JsonLine.quoted(line.text("angles"))
                + ", expected \"" + ReplayHeader.ANGLES + '"');
        }
        String[] names = line.textsOf("players", "name");
        String[] bots = line.textsOf("players", "bot");
        if (names.length == 0 && new JsonLine(line.where(), line.object("scene")).integer("players") != 0) {
            throw new ReplayException(line.where() + ": players: found none, expected those of the scene");
        }
        for (int player = 0; player < names.length; player++) {
            if (names[player] == null || bots[player] == null) {
                throw new ReplayException(line.where() + ": players[" + player + "]: found "
                    + (names[player] == null ? "no name" : "no bot") + ", expected an object with name and bot");
            }
        }
        long seed;
        try {
            seed = Long.parseLong(line.text("seed"));
        } catch (NumberFormatException problem) {
            throw new ReplayException(line.where() + ": seed: found " + JsonLine.quoted(line.text("seed"))
                + ", expected a whole number of 64 bits");
        }
        return new ReplayHeader(line.text("game"), new String(line.object("scene"), StandardCharsets.UTF_8), seed,
            List.of(names), List.of(bots), protocols(line, names.length),
            line.number("timeFactor", Double.POSITIVE_INFINITY),
            law(line), signer(line)).ofJar(line.has(LineFields.JAR) ? line.text(LineFields.JAR) : null)
            .ofLimits(limits(line));
    }

    /** Time limits of players that had their own. */
    private static Map<Integer, Time> limits(JsonLine line) {
        Map<Integer, Time> limits = new HashMap<>();
        List<JsonLine> players = line.objects("players");
        for (int player = 0; player < players.size(); player++) {
            if (players.get(player).has(LineFields.TIME)) {
                JsonLine time = new JsonLine(players.get(player).where() + ": " + LineFields.TIME,
                    players.get(player).object(LineFields.TIME));
                limits.put(player, new Time(limit(time, LineFields.FIRST_ANSWER), limit(time, LineFields.ANSWER)));
            }
        }
        return limits;
    }

    private static int limit(JsonLine time, String name) {
        int limit = time.integer(name);
        if (limit < 1 || limit > OwnLimits.MOST_MS) {
            throw new ReplayException(time.where() + ": " + name + ": found " + limit + ", expected 1 to "
                + OwnLimits.MOST_MS);
        }
        return limit;
    }

    private static int law(JsonLine line) {
        int law = line.has(LineFields.LAW) ? line.integer(LineFields.LAW) : 1;
        if (law < 1 || law == 1 && line.has(LineFields.LAW)) {
            throw new ReplayException(line.where() + ": law: found " + law + ", expected at least 2, or none for 1");
        }
        return law;
    }

    private static String signer(JsonLine line) {
        if (!line.has("signer")) {
            return null;
        }
        String signer = line.text("signer");
        try {
            return SignerKey.ofText(signer).text();
        } catch (IllegalArgumentException problem) {
            throw new ReplayException(line.where() + ": signer: found " + problem.getMessage()
                + ", expected one as steward key makes it");
        }
    }

    private static List<Protocol> protocols(JsonLine line, int players) {
        String[] words = line.textsOf("players", "protocol");
        List<Protocol> protocols = new ArrayList<>();
        for (int player = 0; player < players; player++) {
            protocols.add(Protocol.of(words[player]).orElse(null));
            if (protocols.get(player) == null) {
                throw new ReplayException(line.where() + ": players[" + player + "].protocol: found "
                    + (words[player] == null ? "no text" : JsonLine.quoted(words[player]))
                    + ", expected \"json\" or \"codingame\"");
            }
        }
        return protocols;
    }

    /** The header, or {@code null} if the file was cut off within it ({@link #warning} says so). */
    public ReplayHeader header() {
        return header;
    }

    /** True if the answers are those of a match of the site's server, whose frames stand beside; only with a header. */
    public boolean imported() {
        return headerLine.has(LineFields.SERVER);
    }

    /** True for an import of an earlier version, whose states are what a server showed; only with a header. */
    public boolean importedEarlier() {
        return headerLine.flag(LineFields.IMPORTED);
    }

    /** Returns the shapes to draw, as JSON, see {@link steward.game.GameJson#writeDrawing}; only with a header. */
    public byte[] drawing() {
        return headerLine.object("drawing");
    }

    /** The line of the header; only with a header. */
    @Internal
    public JsonLine headerLine() {
        return headerLine;
    }

    /** State and hash before the first turn, as JSON; only with a header. */
    public byte[] start() {
        return headerLine.object("start");
    }

    /** The name of the file. */
    public String source() {
        return source;
    }

    /** The next turn, or {@code null} at the end: then the result and the warning are known. */
    public RecordedTurn next() {
        return header == null || result != null ? null : turn(nextLine());
    }

    /** The next line as it stands, or {@code null} at the end of the file; only with a header. */
    public byte[] nextLine() {
        return readLine();
    }

    /** Notes that a line was not parsed, because it is known to be that of this turn. */
    public void passed(int turn) {
        lastTurn = turn;
    }

    /** Parses the last line read, as {@link #next}. */
    public RecordedTurn turn(byte[] bytes) {
        JsonLine line = bytes == null ? null : parse(bytes);
        if (line == null) {
            if (warning == null) {
                warning = source + (lastTurn == 0 ? ": cut off before the first turn: there is only the header"
                    : ": cut off after turn " + lastTurn + ": there is no result");
            }
            return null;
        }
        switch (line.text("type")) {
            case "turn" -> {
                RecordedTurn turn = RecordedTurn.of(line, header.names().size());
                if (turn.number() != lastTurn + 1 && warning == null) {
                    warning = line.where() + ": turn: found " + turn.number() + ", expected " + (lastTurn + 1)
                        + ": turns are missing or out of order";
                }
                lastTurn = turn.number();
                return turn;
            }
            case LineFields.RESULT_TYPE -> {
                LineFields.RESULT.check(line);
                result = line;
                readSignature();
                return null;
            }
            default -> throw new ReplayException(line.where() + ": type: found "
                + JsonLine.quoted(line.text("type")) + ", expected \"turn\" or \"result\"");
        }
    }

    /** The last line of a replay that names its signer; if it is not there, the file was cut off. */
    private void readSignature() {
        byte[] bytes = readLine();
        if (header.signer() != null) {
            JsonLine line = bytes == null ? null : parse(bytes);
            if (line == null) {
                warning = source + ": cut off after the result: there is no signature, which the header announces";
                return;
            }
            if (!line.text("type").equals("signature")) {
                throw new ReplayException(line.where() + ": type: found "
                    + JsonLine.quoted(line.text("type")) + ", expected \"signature\"");
            }
            LineFields.SIGNATURE.check(line);
            signature = line;
            bytes = readLine();
        }
        if (bytes != null) {
            throw new ReplayException(where() + ": found more behind the "
                + (header.signer() == null ? "result" : "signature") + ", expected the end of the file");
        }
    }

    /**
     * The signature in base64, or {@code null} if there is none, or its line is not spelled as it is written; known at
     * the end. Whether it is right is up to {@link steward.replay.verify}.
     */
    public String signature() {
        String text = signature == null ? null : signature.text("signature");
        boolean plain = text != null && Arrays.equals(signature.json(),
            ReplayWriter.signatureLine(text, isolation()).getBytes(StandardCharsets.UTF_8));
        return plain ? text : null;
    }

    /** Returns how bots were kept apart, as the line of the signature says it; or {@code null} where it does not. */
    public String isolation() {
        return signature != null && signature.has("isolation") ? signature.text("isolation") : null;
    }

    /** The result line, or {@code null} if the replay has none; known once {@link #next} has returned null. */
    @Internal
    public JsonLine result() {
        return result;
    }

    /** The sentence that says how the match ended, or {@code null} if the replay has no result; known at the end. */
    public String ending() {
        return result == null ? null : result.text("ending");
    }

    /** The result line as JSON, or {@code null} if the replay has none; known at the end. */
    public byte[] resultJson() {
        return result == null ? null : result.json();
    }

    /** Says where the file was cut off or turns are missing; {@code null} if it is whole; known at the end. */
    public String warning() {
        return warning;
    }

    /** @return {@code null} if the line was cut off, which then is the warning */
    private JsonLine parse(byte[] line) {
        try {
            return new JsonLine(where(), line);
        } catch (JacksonException problem) {
            if (lineEnded) {
                String column = problem.getLocation() == null ? "" : ":" + problem.getLocation().getColumnNr();
                throw new ReplayException(where() + column + ": not JSON: " + JsonProblem.message(problem));
            }
            warning = lineNumber == 1 ? source + ": cut off within the header: there is no turn to look at"
                : source + (lastTurn == 0 ? ": cut off within the first turn: only the header is whole"
                : ": cut off within the line after turn " + lastTurn);
            return null;
        }
    }

    private String where() {
        return source + ":" + lineNumber;
    }

    /** Refuses a line that is too long, before it fills the memory. */
    private void checkLength(long length) {
        if (length > longest) {
            throw new ReplayException(where() + ": found a line of more than " + longest
                + " bytes, expected a line of a replay, which is shorter");
        }
    }

    /** The next line without its end, or {@code null} at the end of the file. */
    private byte[] readLine() {
        ByteArrayOutputStream line = null;
        lineNumber++;
        lineEnded = false;
        try {
            for (;;) {
                if (position == limit) {
                    position = 0;
                    limit = in.read(buffer, 0, buffer.length);
                    if (limit <= 0) {
                        limit = 0;
                        return line == null ? null : line.toByteArray();
                    }
                }
                int end = lineEnd(buffer, position, limit);
                lineEnded = end < limit;
                checkLength((line == null ? 0L : line.size()) + end - position);
                if (lineEnded && line == null) {
                    boolean windows = end > position && buffer[end - 1] == '\r';
                    byte[] whole = Arrays.copyOfRange(buffer, position, windows ? end - 1 : end);
                    position = end + 1;
                    return whole;
                }
                line = line == null ? new ByteArrayOutputStream() : line;
                line.write(buffer, position, end - position);
                position = lineEnded ? end + 1 : end;
                if (lineEnded) {
                    byte[] whole = line.toByteArray();
                    return whole.length > 0 && whole[whole.length - 1] == '\r'
                        ? Arrays.copyOf(whole, whole.length - 1) : whole;
                }
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(where() + ": cannot read: " + problem.getMessage(), problem);
        }
    }

    /**
     * Returns where the next line end is, or {@code to}. Eight bytes are tested at once: XOR with line feeds makes one
     * zero.
     */
    private static int lineEnd(byte[] bytes, int from, int to) {
        int at = from;
        for (; at + Long.BYTES <= to; at += Long.BYTES) {
            long eight = (long) EIGHT_BYTES.get(bytes, at) ^ LINE_FEEDS;
            if ((eight - ONES & ~eight & HIGH_BITS) != 0) {
                break;
            }
        }
        while (at < to && bytes[at] != '\n') {
            at++;
        }
        return at;
    }

    @Override
    public void close() {
        try {
            in.close();
        } catch (IOException problem) {
            throw new UncheckedIOException(source + ": cannot close: " + problem.getMessage(), problem);
        }
    }
}
