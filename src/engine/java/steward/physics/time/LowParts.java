package steward.physics.time;

import java.util.Arrays;
import steward.physics.Bodies;

/**
 * Rounding errors of stored coordinates: the low parts of double-double positions whose high parts are in {@link
 * Bodies}. They are kept until the next free flight, so that an impact is computed from the positions before rounding.
 */
public final class LowParts {

    /** Low parts of x, by index of the body. */
    public double[] x = new double[0];
    /** Low parts of y, by index of the body. */
    public double[] y = new double[0];

    /** Makes room for {@code capacity} bodies. */
    public void ensureCapacity(int capacity) {
        if (x.length < capacity) {
            x = new double[capacity];
            y = new double[capacity];
        }
    }

    /** Sets the low parts of a body's position. */
    public void set(int body, double ofX, double ofY) {
        x[body] = ofX;
        y[body] = ofY;
    }

    /** Clears the low parts of a body that was moved: its stored position is exact. */
    public void clear(int body) {
        x[body] = 0;
        y[body] = 0;
    }

    public void clearFirst(int count) {
        Arrays.fill(x, 0, count, 0);
        Arrays.fill(y, 0, count, 0);
    }
}
