package steward.physics.time;

import java.util.Arrays;
import steward.physics.Bodies;

/**
 * What the stored coordinates of bodies have lost by rounding: the low parts of double-double places whose high parts
 * stand in {@link Bodies}. They are kept until the bodies fly on, so that an impact can be computed from where the
 * bodies really are.
 */
public final class LowParts {

    /** By index of a body. */
    public double[] x = new double[0];
    /** By index of a body. */
    public double[] y = new double[0];

    /** Room for so many bodies. */
    public void room(int capacity) {
        if (x.length < capacity) {
            x = new double[capacity];
            y = new double[capacity];
        }
    }

    /** What the stored place of a body lacks. */
    public void set(int body, double ofX, double ofY) {
        x[body] = ofX;
        y[body] = ofY;
    }

    /** The body has been moved: where it is stored is where it is. */
    public void clear(int body) {
        x[body] = 0;
        y[body] = 0;
    }

    /** All bodies below a count are where they are stored. */
    public void clearFirst(int count) {
        Arrays.fill(x, 0, count, 0);
        Arrays.fill(y, 0, count, 0);
    }
}
