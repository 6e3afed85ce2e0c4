package steward.bot;

/** Character boundaries in UTF-8 bytes that may be cut in the middle of a character. */
public final class Utf8 {

    private Utf8() { }

    /**
     * The largest count, at most {@code count}, for which the bytes from {@code from} do not end inside a character.
     * Bytes that are not UTF-8 are left as they are.
     */
    public static int wholeCharacters(byte[] bytes, int from, int count) {
        int end = from + count;
        int lead = end - 1;
        while (lead >= from && lead > end - 4 && (bytes[lead] & 0xC0) == 0x80) {
            lead--;
        }
        boolean cut = lead >= from && lead + sequenceLength(bytes[lead]) > end;
        return cut ? lead - from : count;
    }

    private static int sequenceLength(byte lead) {
        int b = lead & 0xFF;
        if (b >= 0xF0 && b < 0xF8) {
            return 4;
        }
        if (b >= 0xE0 && b < 0xF0) {
            return 3;
        }
        return b >= 0xC0 && b < 0xE0 ? 2 : 1;
    }
}
