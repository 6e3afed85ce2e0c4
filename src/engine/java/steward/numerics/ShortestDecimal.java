package steward.numerics;

import java.math.BigInteger;

/**
 * Writer of the shortest decimal that reads back as the same double, among equals the nearest to it, without
 * allocating:
 * <pre>-12.5   0.001   3.141592653589793</pre>
 *
 * <p>It covers only the numbers that are frequent in frames and replays: not whole, no power of two, magnitude from
 * 10^-3 to below 10^7. Callers need another conversion for the rest (see {@link #UNSUPPORTED}).
 *
 * <p>Source: R. Giulietti, "The Schubfach way to render doubles" (2020), for the regular interval only.
 */
public final class ShortestDecimal {

    /** The maximum number of characters that {@link #write} writes: sign, "0.00" and 17 digits. */
    public static final int MAXIMUM_LENGTH = 24;

    /** Result of {@link #write} for a number outside its range. */
    public static final int UNSUPPORTED = -1;

    private static final double LOWEST = 1e-3;
    private static final double LIMIT = 1e7;

    private static final int FRACTION_BITS = 52;
    private static final long FRACTION = (1L << FRACTION_BITS) - 1;
    private static final int EXPONENT = (1 << 11) - 1;
    /** A double is c · 2^(e - BIAS), c being its 53-bit significand and e its exponent field. */
    private static final int BIAS = 1023 + FRACTION_BITS;
    private static final long LOW_63 = Long.MAX_VALUE;
    private static final long SIXTEEN_DIGITS = 10_000_000_000_000_000L;
    private static final long NINE_DIGITS = 1_000_000_000;

    /*
     * With v = c · 2^q and k = floor(log10(2^q)), the decimals f · 10^k are spaced by less than the doubles, and
     * f · 10^(k+1) by more. g(k) is 10^-k as a fixed-point number of 126 bits, rounded up: g · 2^(r - 125), with
     * r = floor(log2(10^-k)). The products of c with it, of which two fraction bits and a sticky bit (whether any
     * further bit is set) are kept, decide exactly (theorem 9.2 of the paper).
     */
    private static final int LOWEST_K = -19;
    private static final int HIGHEST_K = -9;
    private static final long[] POWERS = table();

    private ShortestDecimal() { }

    private static long[] table() {
        long[] table = new long[2 * (HIGHEST_K - LOWEST_K + 1)];
        for (int k = LOWEST_K; k <= HIGHEST_K; k++) {
            BigInteger power = BigInteger.TEN.pow(-k);
            BigInteger g = power.shiftLeft(125 - log2OfPower10(-k)).add(BigInteger.ONE);
            table[2 * (k - LOWEST_K)] = g.shiftRight(63).longValueExact();
            table[2 * (k - LOWEST_K) + 1] = g.and(BigInteger.valueOf(LOW_63)).longValueExact();
        }
        return table;
    }

    /** floor(log2(10^n)), for |n| up to thousands: log2(10) in 38 binary places. */
    private static int log2OfPower10(int n) {
        return (int) (n * 913_124_641_741L >> 38);
    }

    /** floor(log10(2^n)), likewise: log10(2) in 41 binary places. */
    private static int log10OfPower2(int n) {
        return (int) (n * 661_971_961_083L >> 41);
    }

    /**
     * Writes a number.
     *
     * @param into room for {@link #MAXIMUM_LENGTH} characters
     * @return how many characters were written, from the first; or {@link #UNSUPPORTED}
     */
    public static int write(double value, char[] into) {
        double magnitude = Math.abs(value);
        long bits = Double.doubleToRawLongBits(magnitude);
        long fraction = bits & FRACTION;
        if (!(magnitude >= LOWEST && magnitude < LIMIT) || fraction == 0 || magnitude == Math.rint(magnitude)) {
            return UNSUPPORTED;
        }
        int q = (int) (bits >>> FRACTION_BITS & EXPONENT) - BIAS;
        int k = log10OfPower2(q);
        long digits = shortest(fraction | 1L << FRACTION_BITS, q, k);
        int count = digits >= SIXTEEN_DIGITS ? 17 : 16;   // c is below 2^53, and 2^q / 10^k from 1 to below 10
        for (long shorter = digits / 10; shorter * 10 == digits; shorter = digits / 10) {
            digits = shorter;
            count--;
            k++;
        }
        int at = 0;
        if (value < 0) {
            into[at++] = '-';
        }
        return writeDigits(digits, count, count + k, into, at);
    }

    /** The digits f of the shortest f · 10^k inside the interval that rounds to c · 2^q; f may end in zeros. */
    private static long shortest(long c, int q, int k) {
        long g1 = POWERS[2 * (k - LOWEST_K)];
        long g0 = POWERS[2 * (k - LOWEST_K) + 1];
        int h = q + log2OfPower10(-k) + 2;
        long odd = c & 1;                              // an even c rounds both ends of its interval to itself
        long value = scaled(g1, g0, (4 * c) << h);
        long low = scaled(g1, g0, (4 * c - 2) << h) + odd;
        long high = scaled(g1, g0, (4 * c + 2) << h) - odd;
        long s = value >> 2;
        long tens = s / 10 * 10;
        boolean lowerTens = low <= 4 * tens;
        boolean upperTens = 4 * (tens + 10) <= high;
        if (lowerTens != upperTens) {
            return lowerTens ? tens : tens + 10;
        }
        boolean lower = low <= 4 * s;
        boolean upper = 4 * (s + 1) <= high;
        if (lower != upper) {
            return lower ? s : s + 1;
        }
        long middle = value - 2 * (2 * s + 1);
        return middle < 0 || middle == 0 && (s & 1) == 0 ? s : s + 1;
    }

    /** g · c / 2^126, the last bit set if any non-zero bit was cut off. */
    private static long scaled(long g1, long g0, long c) {
        long x1 = Math.multiplyHigh(g0, c);
        long y0 = g1 * c;
        long y1 = Math.multiplyHigh(g1, c);
        long z = (y0 >>> 1) + x1;
        long w = y1 + (z >>> 63);
        return w | (z & LOW_63) + LOW_63 >>> 63;
    }

    /**
     * Writes digits with {@code whole} of them before the point; if that is negative, as many zeros follow the point.
     */
    private static int writeDigits(long digits, int count, int whole, char[] into, int from) {
        int at = from;
        if (whole <= 0) {
            into[at++] = '0';
            into[at++] = '.';
            for (int zero = whole; zero < 0; zero++) {
                into[at++] = '0';
            }
            writeDigits(digits, into, at, at + count);
            return at + count;
        }
        writeDigits(digits, into, at + 1, at + 1 + count);
        for (int place = at; place < at + whole; place++) {
            into[place] = into[place + 1];
        }
        into[at + whole] = '.';
        return at + 1 + count;
    }

    /** Writes {@code to - from} digits in two halves, because dividing an int is cheaper. */
    private static void writeDigits(long digits, char[] into, int from, int to) {
        long high = digits / NINE_DIGITS;
        int rest = (int) (digits - high * NINE_DIGITS);
        int place = to;
        for (int least = Math.max(from, to - 9); place > least;) {
            int shorter = rest / 10;
            into[--place] = (char) ('0' + rest - 10 * shorter);
            rest = shorter;
        }
        rest = (int) high;
        while (place > from) {
            int shorter = rest / 10;
            into[--place] = (char) ('0' + rest - 10 * shorter);
            rest = shorter;
        }
    }
}
