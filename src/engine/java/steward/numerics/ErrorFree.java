package steward.numerics;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.lang.management.ManagementFactory;

/**
 * Rounding error of a sum or a product, which is itself a double. {@code a + b = s + sumError(a, b, s)} and
 * {@code a b = p + productError(a, b, p)} hold exactly.
 *
 * <p>Ranges. The sum's error is exact unless the sum overflows. The product's is exact if the product is 0 or its
 * magnitude is from 2^-968 up to the largest double (below, the error has digits under 2^-1074 and is rounded to them).
 * For every finite product the result has the same bits whether the processor has a fused multiply-add or not; the
 * error of a product that overflows is not finite.
 *
 * <p>Whether the instruction is used is a matter of speed alone, and is decided once, from a flag of the JVM: without
 * it, {@code Math.fma} takes microseconds, and splitting the factors takes 17 operations.
 */
public final class ErrorFree {

    /** 2^27 + 1: with c = SPLITTER * a, c - (c - a) is the upper 26 bits of a (Dekker 1971, section 5). */
    private static final double SPLITTER = 0x1p27 + 1;
    /** Factors up to here can be split without overflow. */
    private static final double LARGEST_SPLIT = 0x1p995;
    /** For products from this magnitude on, the error is not below the smallest double. */
    private static final double SMALLEST_PRODUCT = 0x1p-968;

    private static final boolean FAST_FMA = hasFastFma();

    private ErrorFree() { }

    /*
     * Sum (O. Moller 1965; D. E. Knuth, "The Art of Computer Programming" 2, 4.2.2, theorem B). With s = RN(a + b) the
     * part of s that came from b is b' = RN(s - a), that from a is a' = RN(s - b'); a - a' and b - b' are exact, and so
     * is their sum, the error.
     */

    /** The error of {@code s = a + b}. */
    public static double sumError(double a, double b, double s) {
        double fromB = s - a;
        double fromA = s - fromB;
        return (a - fromA) + (b - fromB);
    }

    /** The error of {@code s = a + b} where {@code |a| >= |b|} or a is 0 (Dekker 1971). */
    public static double fastSumError(double a, double b, double s) {
        return b - (s - a);
    }

    /** The error of {@code p = a * b}. */
    public static double productError(double a, double b, double p) {
        return FAST_FMA ? Math.fma(a, b, -p) : productErrorBySplit(a, b, p);
    }

    /*
     * Product (T. J. Dekker, "A Floating-Point Technique for Extending the Available Precision", 1971, theorem 5.12;
     * G. W. Veltkamp). Split a = ah + al, b = bh + bl into halves of 26 and 26 bits (with signs); then all four partial
     * products are exact, and so are the sums of their differences from p, taken largest first.
     */

    /** As {@link #productError}, by Dekker's algorithm. */
    static double productErrorBySplit(double a, double b, double p) {
        double size = Math.abs(p);
        if (!(size >= SMALLEST_PRODUCT && size < Double.POSITIVE_INFINITY
            && Math.abs(a) <= LARGEST_SPLIT && Math.abs(b) <= LARGEST_SPLIT)) {
            return productErrorScaled(a, b, p);
        }
        return split(a, b, p);
    }

    private static double split(double a, double b, double p) {
        double c = SPLITTER * a;
        double ah = c - (c - a);
        double al = a - ah;
        c = SPLITTER * b;
        double bh = c - (c - b);
        double bl = b - bh;
        return al * bl - (((p - ah * bh) - al * bh) - ah * bl) + 0.0;      // an error of 0 is +0.0, as from fma
    }

    /** Scales both factors to magnitudes from 1 to 2; scaling the result back rounds once, as fma does. */
    private static double productErrorScaled(double a, double b, double p) {
        if (a == 0 || b == 0 || !Double.isFinite(p)) {
            return a * b - p;
        }
        int exponentA = exponent(a);
        int exponentB = exponent(b);
        double scaledA = Math.scalb(a, -exponentA);
        double scaledB = Math.scalb(b, -exponentB);
        double product = scaledA * scaledB;
        double wanted = Math.scalb(p, -exponentA - exponentB);
        double error = (product - wanted) + split(scaledA, scaledB, product);
        return Math.scalb(error, exponentA + exponentB);
    }

    /** The exponent of the leading bit, also of a subnormal number. */
    private static int exponent(double value) {
        int exponent = Math.getExponent(value);
        return exponent >= Double.MIN_EXPONENT ? exponent : Math.getExponent(value * 0x1p54) - 54;
    }

    /**
     * True if {@code Math.fma} is compiled to one instruction: HotSpot's flag {@code UseFMA}, which the JVM sets from
     * the processor and the command line. False where the flag is unknown. Takes some milliseconds; call it once.
     */
    static boolean hasFastFma() {
        try {
            HotSpotDiagnosticMXBean hotSpot = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
            return hotSpot != null && Boolean.parseBoolean(hotSpot.getVMOption("UseFMA").getValue());
        } catch (IllegalArgumentException | LinkageError | SecurityException unknown) {
            return false;
        }
    }
}
