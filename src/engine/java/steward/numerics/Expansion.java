package steward.numerics;

import java.util.Arrays;

/**
 * An exact sum of doubles, kept as a list of doubles. Its parts do not overlap, ascend in magnitude, and none is 0, so
 * that the last one has the sign of the whole (J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
 * Robust Geometric Predicates", 1997, section 2). Operations change it in place; its array grows when necessary and
 * never shrinks.
 *
 * <p>It is exact as long as no partial product has digits below 2^-1074 or overflows (see {@link ErrorFree}).
 */
public final class Expansion {

    private double[] parts = new double[32];
    private int size;

    public Expansion clear() {
        size = 0;
        return this;
    }

    /** Adds a double (Shewchuk, figure 6 GROW-EXPANSION, theorem 10; zeros left out). */
    public Expansion add(double value) {
        if (size == parts.length) {
            parts = Arrays.copyOf(parts, 2 * size);
        }
        double carry = value;
        int kept = 0;
        for (int k = 0; k < size; k++) {
            double sum = carry + parts[k];
            double error = ErrorFree.sumError(carry, parts[k], sum);
            if (error != 0) {
                parts[kept++] = error;
            }
            carry = sum;
        }
        if (carry != 0) {
            parts[kept++] = carry;
        }
        size = kept;
        return this;
    }

    public Expansion addProduct(double a, double b) {
        double product = a * b;
        if (product != 0) {
            add(ErrorFree.productError(a, b, product)).add(product);
        }
        return this;
    }

    /** Adds the exact product of two double-doubles: four products of doubles. */
    public Expansion addProduct(DoubleDouble a, DoubleDouble b) {
        return addProduct(a, b, 1);
    }

    public Expansion subtractProduct(DoubleDouble a, DoubleDouble b) {
        return addProduct(a, b, -1);
    }

    private Expansion addProduct(DoubleDouble a, DoubleDouble b, double sign) {
        return addProduct(sign * a.low(), b.low()).addProduct(sign * a.low(), b.high())
            .addProduct(sign * a.high(), b.low()).addProduct(sign * a.high(), b.high());
    }

    public Expansion addProduct(Expansion a, Expansion b) {
        return addProduct(a, b, 1);
    }

    public Expansion subtractProduct(Expansion a, Expansion b) {
        return addProduct(a, b, -1);
    }

    private Expansion addProduct(Expansion a, Expansion b, double sign) {
        for (int i = 0; i < a.size; i++) {
            double factor = sign * a.parts[i];
            for (int k = 0; k < b.size; k++) {
                addProduct(factor, b.parts[k]);
            }
        }
        return this;
    }

    /** The exact sign: -1, 0 or 1. */
    public int sign() {
        return size == 0 ? 0 : parts[size - 1] > 0 ? 1 : -1;
    }

    /**
     * Rounds to a double-double, largest parts first: relative error below 2^-100, for each additional part 2^-105 at
     * most.
     */
    public DoubleDouble roundTo(DoubleDouble result) {
        result.set(0);
        for (int k = size - 1; k >= 0; k--) {
            result.add(parts[k]);
        }
        return result;
    }
}
