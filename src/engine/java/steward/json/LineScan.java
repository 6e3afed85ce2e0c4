package steward.json;

/**
 * Fast scanner for simple JSON lines, which nearly all bots write: names, brackets and short decimal numbers in the
 * expected order, with blanks between them. It rejects everything else, including much valid JSON; a full parser must
 * then read the line from its beginning.
 */
public final class LineScan {

    /** The number of decimal digits that fit into the 53 bits of a double. */
    private static final int MOST_DIGITS = 15;

    private static final double[] POWERS = new double[MOST_DIGITS + 1];

    static {
        POWERS[0] = 1;
        for (int k = 1; k < POWERS.length; k++) {
            POWERS[k] = 10 * POWERS[k - 1];
        }
    }

    private byte[] bytes;
    private int at;
    private int end;
    private double number;

    /** Starts a line of {@code length} bytes. */
    public void begin(byte[] line, int length) {
        begin(line, 0, length);
    }

    /** Starts at a place of a line, which ends before another one. */
    public void begin(byte[] line, int from, int to) {
        bytes = line;
        at = from;
        end = to;
    }

    /** The place behind what was accepted last. */
    public int at() {
        return at;
    }

    private void skipBlanks() {
        while (at < end && (bytes[at] == ' ' || bytes[at] == '\t')) {
            at++;
        }
    }

    /** Accepts one ASCII character after blanks. @return whether it was next; otherwise only blanks are skipped */
    public boolean accept(char one) {
        skipBlanks();
        if (at < end && bytes[at] == one) {
            at++;
            return true;
        }
        return false;
    }

    /** Accepts these bytes after blanks. @return whether they were next */
    public boolean accept(byte[] text) {
        skipBlanks();
        if (text.length > end - at) {
            return false;
        }
        for (int k = 0; k < text.length; k++) {
            if (bytes[at + k] != text[k]) {
                return false;
            }
        }
        at += text.length;
        return true;
    }

    /** Accepts this name and a colon. @return whether they were next */
    public boolean acceptName(byte[] quoted) {
        return accept(quoted) && accept(':');
    }

    /** True if only blanks and line ends are left. */
    public boolean isAtEnd() {
        for (; at < end; at++) {
            if (bytes[at] != ' ' && bytes[at] != '\t' && bytes[at] != '\r' && bytes[at] != '\n') {
                return false;
            }
        }
        return true;
    }

    /**
     * Accepts a number after blanks: an optional minus, digits, and optionally a point and more digits; see
     * {@link #number}. Digits and powers of ten up to 10^15 are exact doubles, and so their quotient is the nearest
     * double to the decimal (W. Clinger, "How to read floating point numbers accurately", 1990, its fast path).
     *
     * @return whether one was next
     */
    public boolean acceptNumber() {
        skipBlanks();
        boolean negative = at < end && bytes[at] == '-';
        int first = negative ? at + 1 : at;
        int place = first;
        long digits = 0;
        for (; place < end && isDigit(bytes[place]) && place - first <= MOST_DIGITS; place++) {
            digits = 10 * digits + bytes[place] - '0';
        }
        int whole = place - first;
        boolean leadingZero = whole > 1 && bytes[first] == '0';
        int fraction = 0;
        if (place < end && bytes[place] == '.') {
            int point = place++;
            for (; place < end && isDigit(bytes[place]) && place - point <= MOST_DIGITS; place++) {
                digits = 10 * digits + bytes[place] - '0';
            }
            fraction = place - point - 1;
            if (fraction == 0) {
                return false;
            }
        }
        boolean goesOn = place < end && (isDigit(bytes[place]) || bytes[place] == '.' || bytes[place] == 'e'
            || bytes[place] == 'E');
        if (whole == 0 || leadingZero || goesOn || whole + fraction > MOST_DIGITS || negative && digits == 0) {
            return false;
        }
        number = (negative ? -digits : digits) / POWERS[fraction];
        at = place;
        return true;
    }

    private static boolean isDigit(byte one) {
        return one >= '0' && one <= '9';
    }

    /** The number last accepted. */
    public double number() {
        return number;
    }
}
