package steward.cli;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Damages texts as disks, editors and hurried people do: bytes changed, cut, doubled and put in, values swapped. */
final class Mutations {

    /** Pieces that stand in place of a value, or anywhere. */
    private static final List<String> PIECES = List.of("null", "true", "false", "0", "-1", "-0.0", "1e999", "1e-999",
        "0.5", "99999999999999999999", "2147483648", "-9223372036854775809", "NaN", "Infinity", "1e99999999999", "01",
        "+1", ".5", "5.", "\"\"", "\"x\"", "\"null\"", "\"\\u0000\"", "\"\\ud800\"", "\"\\x\"", "\"\n\"", "[]", "{}",
        "[[]]", "[null]", "{\"\":0}", "{\"x\":1,\"x\":2}", "\"infinite\"", "[", "]", "{", "}", ",", ":", "\"", "\n",
        "\r\n", "\t", " ", "\0", "\uFEFF", "\u202E", "\u00e9", "//", "#", "'", "\\", "-", "e", ".", "<", "codingame",
        "json", "\"$schema\"", "SHIELD", "BOOST", "1".repeat(400), "[".repeat(600), "{\"a\":".repeat(600),
        "x".repeat(2000), "9".repeat(1200));

    /** A number, a text or a word of JSON. */
    private static final Pattern SCALAR =
        Pattern.compile("-?\\d[-+.eE\\d]*|\"(?:[^\"\\\\]++|\\\\.)*+\"|true|false|null");
    private static final int MOST_CHANGES = 3;
    private static final int LONGEST_SLICE = 200;

    private final SplittableRandom random;

    Mutations(SplittableRandom random) {
        this.random = random;
    }

    /** The bytes with one to three changes. */
    byte[] of(byte[] original) {
        byte[] bytes = original;
        for (int changes = 1 + random.nextInt(MOST_CHANGES); changes > 0; changes--) {
            bytes = changed(bytes);
        }
        return bytes;
    }

    private byte[] changed(byte[] bytes) {
        if (bytes.length == 0) {
            return piece();
        }
        int at = random.nextInt(bytes.length);
        int end = Math.min(bytes.length, at + 1 + random.nextInt(LONGEST_SLICE));
        return switch (random.nextInt(10)) {
            case 0 -> with(bytes, at, at + 1, (byte) random.nextInt(256));
            case 1 -> with(bytes, at, at + 1, (byte) (bytes[at] ^ 1 << random.nextInt(8)));
            case 2 -> Arrays.copyOf(bytes, at);
            case 3 -> with(bytes, at, end);
            case 4 -> with(bytes, at, at, Arrays.copyOfRange(bytes, at, end));
            case 5 -> with(bytes, at, at, piece());
            case 6 -> swapped(bytes);
            default -> revalued(bytes);
        };
    }

    /** One value of the text made another. */
    private byte[] revalued(byte[] bytes) {
        int[] value = scalar(bytes);
        return value == null ? with(bytes, 0, 0, piece()) : with(bytes, value[0], value[1], piece());
    }

    /** One value of the text in the place of another, or beside it. */
    private byte[] swapped(byte[] bytes) {
        int[] one = scalar(bytes);
        int[] other = scalar(bytes);
        return one == null ? bytes : with(bytes, one[0], one[1], Arrays.copyOfRange(bytes, other[0], other[1]));
    }

    /** Where a value begins and ends: the first one behind a place drawn by lot, or before. */
    private int[] scalar(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        int from = random.nextInt(text.length());
        List<int[]> near = new ArrayList<>();
        Matcher matcher = SCALAR.matcher(text).region(from, Math.min(text.length(), from + 10 * LONGEST_SLICE));
        while (near.size() < 5 && matcher.find()) {
            near.add(new int[] {matcher.start(), matcher.end()});
        }
        return near.isEmpty() ? matcher.reset().find() ? new int[] {matcher.start(), matcher.end()} : null
            : near.get(random.nextInt(near.size()));
    }

    private byte[] piece() {
        return PIECES.get(random.nextInt(PIECES.size())).getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] with(byte[] bytes, int from, int to, byte... between) {
        byte[] changed = new byte[bytes.length - (to - from) + between.length];
        System.arraycopy(bytes, 0, changed, 0, from);
        System.arraycopy(between, 0, changed, from, between.length);
        System.arraycopy(bytes, to, changed, from + between.length, bytes.length - to);
        return changed;
    }
}
