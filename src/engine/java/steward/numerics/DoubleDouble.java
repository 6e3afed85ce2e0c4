package steward.numerics;

/**
 * A number of about 106 bits, held as the unevaluated sum of two doubles: high + low, with {@code high} the sum rounded
 * to nearest. An instance is a register that operations change in place, so that code which keeps its registers
 * computes without allocating.
 *
 * <p>Relative errors, with u = 2^-53, as proven by M. Joldes, J.-M. Muller, V. Popescu, "Tight and Rigorous Error
 * Bounds for Basic Building Blocks of Double-Word Arithmetic" (2017), for results and intermediate products in the
 * ranges of {@link ErrorFree}:
 *
 * <pre>
 *     + double           2 u^2       (algorithm 4)          + double-double    3 u^2 + 13 u^3   (algorithm 6)
 *     * double         1.5 u^2 + 4 u^3   (algorithm 7)      * double-double    5 u^2            (algorithm 10)
 *     / double-double   15 u^2 + 56 u^3  (algorithm 17)     square root     25/8 u^2
 * </pre>
 *
 * The square root is by V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, "Accurate Calculation of Euclidean
 * Norms Using Double-Word Arithmetic" (2023), algorithm 7.
 */
public final class DoubleDouble {

    private double high;
    private double low;

    /** The number rounded to a double. */
    public double high() {
        return high;
    }

    /** The remainder, at most half a unit in the last place of {@link #high}. */
    public double low() {
        return low;
    }

    public DoubleDouble set(double value) {
        high = value;
        low = 0;
        return this;
    }

    public DoubleDouble set(DoubleDouble other) {
        high = other.high;
        low = other.low;
        return this;
    }

    /** Sets this to the exact sum of any two doubles. */
    public DoubleDouble setSum(double a, double b) {
        high = a + b;
        low = ErrorFree.sumError(a, b, high);
        return this;
    }

    /** Sets this to the exact sum of two doubles of which the first is the larger in magnitude (or 0). */
    public DoubleDouble setFastSum(double large, double small) {
        return normalize(large, small);
    }

    /** Sets this to the exact difference. */
    public DoubleDouble setDifference(double a, double b) {
        return setSum(a, -b);
    }

    /** Sets this to the exact product. */
    public DoubleDouble setProduct(double a, double b) {
        high = a * b;
        low = ErrorFree.productError(a, b, high);
        return this;
    }

    /** Multiplies by -1, exactly. */
    public DoubleDouble negate() {
        high = -high;
        low = -low;
        return this;
    }

    public DoubleDouble add(double value) {
        double sum = high + value;
        double error = ErrorFree.sumError(high, value, sum);
        return normalize(sum, low + error);
    }

    /** Adds another number, which may be this one. */
    public DoubleDouble add(DoubleDouble other) {
        return add(other.high, other.low);
    }

    public DoubleDouble subtract(DoubleDouble other) {
        return add(-other.high, -other.low);
    }

    private DoubleDouble add(double otherHigh, double otherLow) {
        double sum = high + otherHigh;
        double error = ErrorFree.sumError(high, otherHigh, sum);
        double lowSum = low + otherLow;
        double lowError = ErrorFree.sumError(low, otherLow, lowSum);
        double carry = error + lowSum;
        double head = sum + carry;
        return normalize(head, lowError + ErrorFree.fastSumError(sum, carry, head));
    }

    public DoubleDouble multiply(double value) {
        double product = high * value;
        double error = ErrorFree.productError(high, value, product);
        double lowProduct = low * value;
        double head = product + lowProduct;
        return normalize(head, ErrorFree.fastSumError(product, lowProduct, head) + error);
    }

    /** Multiplies by another number, which may be this one. */
    public DoubleDouble multiply(DoubleDouble other) {
        double product = high * other.high;
        double error = ErrorFree.productError(high, other.high, product);
        return normalize(product, error + (high * other.low + low * other.high));
    }

    /** Divides; a divisor of 0 gives an infinity or NaN in {@link #high}. */
    public DoubleDouble divide(DoubleDouble divisor) {
        double quotient = high / divisor.high;
        double product = divisor.high * quotient;
        double error = ErrorFree.productError(divisor.high, quotient, product);
        double lowProduct = divisor.low * quotient;
        double head = product + lowProduct;
        double tail = ErrorFree.fastSumError(product, lowProduct, head) + error;
        double rest = (high - head) + (low - tail);
        return normalize(quotient, rest / divisor.high);
    }

    /** Takes the square root of a number that is at least 0. */
    public DoubleDouble squareRoot() {
        if (high == 0) {
            return set(0);
        }
        double root = Math.sqrt(high);
        double square = root * root;
        double rest = ((high - square) - ErrorFree.productError(root, root, square)) + low;
        return normalize(root, rest / (2 * root));
    }

    /** Multiplies by 2^exponent: exact unless the result leaves the range; below 2^-968 the low part is dropped. */
    public DoubleDouble scale(int exponent) {
        high = Math.scalb(high, exponent);
        low = Math.abs(high) < 0x1p-968 ? 0 : Math.scalb(low, exponent);
        return this;
    }

    private DoubleDouble normalize(double head, double tail) {
        high = head + tail;
        low = ErrorFree.fastSumError(head, tail, high);
        return this;
    }

    /** -1, 0 or 1 as this is less than, equal to or greater than the other. */
    public int compareTo(DoubleDouble other) {
        return high != other.high ? high < other.high ? -1 : 1 : Double.compare(low + 0.0, other.low + 0.0);
    }
}
