package steward.numerics;

/**
 * A number in [0, 1) with 192 binary digits. An instance is a register that operations change in place, so that code
 * that keeps a few of them computes without allocating. Further digits are cut off; errors are counted in units of the
 * last place, 2^-192.
 */
final class WideFraction {

    /** Binary digits of a double, the leading one included. */
    private static final int PRECISION = 53;

    private long high;
    private long middle;
    private long low;

    /** Becomes (high 2^128 + middle 2^64 + low) / 2^192, the words without sign. */
    WideFraction set(long highWord, long middleWord, long lowWord) {
        high = highWord;
        middle = middleWord;
        low = lowWord;
        return this;
    }

    WideFraction set(WideFraction other) {
        return set(other.high, other.middle, other.low);
    }

    /** Returns how many binary digits are 0 before the first that is 1: 64 at most. */
    int leadingZeros() {
        return Long.numberOfLeadingZeros(high);
    }

    /**
     * Times another, which may be this. The result is at most the product and less than 6 units below it: of the nine
     * products of two words three are below 1 unit and left out (two below 1, one below 2^-64), of three others the
     * lower half is (each below 1).
     */
    WideFraction multiply(WideFraction other) {
        long first = multiplyHigh(high, other.low);
        long second = multiplyHigh(middle, other.middle);
        long third = multiplyHigh(low, other.high);
        long fourth = high * other.middle;
        long fifth = middle * other.high;
        long sum = first + second;
        long carry = carry(sum, second);
        sum += third;
        carry += carry(sum, third);
        sum += fourth;
        carry += carry(sum, fourth);
        sum += fifth;
        carry += carry(sum, fifth);

        first = multiplyHigh(high, other.middle);
        second = multiplyHigh(middle, other.high);
        third = high * other.high;
        high = multiplyHigh(high, other.high);
        low = sum;
        middle = first + carry;
        high += carry(middle, carry);
        middle += second;
        high += carry(middle, second);
        middle += third;
        high += carry(middle, third);
        return this;
    }

    /** Becomes the difference of the given number, which is not less, and this. */
    WideFraction subtractFrom(long highWord, long middleWord, long lowWord) {
        long borrow = carry(lowWord, low);
        long rest = middleWord - middle;
        long nextBorrow = carry(middleWord, middle) + carry(rest, borrow);
        low = lowWord - low;
        middle = rest - borrow;
        high = highWord - high - nextBorrow;
        return this;
    }

    WideFraction subtractFrom(WideFraction other) {
        return subtractFrom(other.high, other.middle, other.low);
    }

    /** Becomes 1 less this, which is not 0. */
    WideFraction subtractFromOne() {
        return subtractFrom(0, 0, 0);                 // the 1 itself is one digit too far left, and taken away again
    }

    /** Divides by a whole number from 1 to 2^31 - 1: less than 1 unit below the quotient. */
    WideFraction divide(int divisor) {
        long rest = 0;
        long quotient = 0;
        for (int half = 0; half < 6; half++) {
            long word = half < 2 ? high : half < 4 ? middle : low;
            long dividend = rest << 32 | ((half & 1) == 0 ? word >>> 32 : word & 0xffffffffL);
            quotient = quotient << 32 | dividend / divisor;
            rest = dividend % divisor;
            if (half == 1) {
                high = quotient;
            } else if (half == 3) {
                middle = quotient;
            }
        }
        low = quotient;
        return this;
    }

    long high() {
        return high;
    }

    long middle() {
        return middle;
    }

    long low() {
        return low;
    }

    /** The nearest double, if the number is at least 2^-64. Of two that are equally near it takes the greater. */
    double toDouble() {
        int zeros = leadingZeros();
        long digits = high << zeros | middle >>> 1 >>> 63 - zeros;
        long rounded = (digits >>> Long.SIZE - PRECISION) + (digits >>> Long.SIZE - PRECISION - 1 & 1);
        // The leading digit adds 1 to the exponent, and so does another if all others were rounded up.
        return Double.longBitsToDouble(((long) Double.MAX_EXPONENT - 2 - zeros << PRECISION - 1) + rounded);
    }

    /** The upper 64 bits of the product of two words without sign. */
    static long multiplyHigh(long a, long b) {
        return Math.multiplyHigh(a, b) + (a >> 63 & b) + (b >> 63 & a);
    }

    /** 1 if a is, without sign, less than b, else 0: what a sum with the summand b carries, a difference borrows. */
    static long carry(long a, long b) {
        return Long.compareUnsigned(a, b) < 0 ? 1 : 0;
    }
}
