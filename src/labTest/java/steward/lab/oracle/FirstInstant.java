package steward.lab.oracle;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Wall;

/*
 * Two times are roots of quadratics with coefficients that are multiples of a common unit. Times that differ make the
 * resultant of their quadratics at least 1 in that unit; it is the product of the four differences of roots and of the
 * squares of the leading coefficients. With coefficients up to H units and roots up to 2^20 turns that is a difference
 * of at least 2^-60 / H^4: for H = 2^64, as of places and speeds of 31 bits, more than 1e-96.
 */

/**
 * Reference computation of the first instant of a turn with simultaneous elastic impacts, in decimals of {@value
 * #PRECISION} digits. Impacts are decided from the states before and react in the order of indices, each on the
 * velocities that the previous ones have left. Times that agree to 1e-110 are equal, for numbers of at most 31 bits.
 */
public final class FirstInstant {

    private static final int PRECISION = 140;
    private static final MathContext DIGITS = new MathContext(PRECISION);
    private static final BigDecimal EQUAL = new BigDecimal("1e-110");
    private static final BigDecimal CLEAR = new BigDecimal("1e-9");

    /** A pair, or a body and {@code ~wall}. */
    private record Contact(int a, int b, BigDecimal time) {

        /** Lowest pair first, bodies before walls. */
        long rank() {
            return (long) a << 32 | (b >= 0 ? b : (1L << 31) + ~b);
        }
    }

    private final int size;
    private final BigDecimal[] x;
    private final BigDecimal[] y;
    private final BigDecimal[] vx;
    private final BigDecimal[] vy;
    private final BigDecimal[] radius;
    private final BigDecimal[] mass;
    private final List<Wall> walls;
    private final List<Contact> tied = new ArrayList<>();
    private final List<String> impacts = new ArrayList<>();
    private boolean clear = true;

    /** @param walls half-planes and arenas */
    public FirstInstant(Bodies bodies, List<Wall> walls) {
        size = bodies.size();
        x = exact(bodies.x);
        y = exact(bodies.y);
        vx = exact(bodies.vx);
        vy = exact(bodies.vy);
        radius = exact(bodies.radius);
        mass = exact(bodies.mass);
        this.walls = walls;
        List<Contact> all = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            for (int j = i + 1; j < size; j++) {
                add(all, i, j, root(x[i].subtract(x[j]), y[i].subtract(y[j]), vx[i].subtract(vx[j]),
                    vy[i].subtract(vy[j]), radius[i].add(radius[j]), -1));
            }
            for (int w = 0; w < walls.size(); w++) {
                add(all, i, ~w, wallTime(walls.get(w), i));
            }
        }
        all.sort(Comparator.comparing(Contact::time));
        for (Contact contact : all) {
            BigDecimal later = contact.time.subtract(all.get(0).time);
            if (later.compareTo(EQUAL) < 0) {
                tied.add(contact);
            } else {
                clear &= later.compareTo(CLEAR) > 0;
                break;
            }
        }
        tied.sort(Comparator.comparingLong(Contact::rank));
        react();
    }

    /** Number of contacts that begin at the first instant. */
    public int contacts() {
        return tied.size();
    }

    /** Pairs that have an impact, as {@code "a b"} or {@code "a ~wall"}. */
    public List<String> impacts() {
        return List.copyOf(impacts);
    }

    /** True if no decision is close: all times that differ do so by 1e-9, and nothing separates by less than that. */
    public boolean isClear() {
        return clear;
    }

    private BigDecimal[] exact(double... values) {
        return Arrays.stream(values, 0, size).mapToObj(BigDecimal::new).toArray(BigDecimal[]::new);
    }

    private static void add(List<Contact> all, int a, int b, BigDecimal time) {
        if (time != null && time.signum() >= 0 && time.compareTo(BigDecimal.ONE) < 0) {
            all.add(new Contact(a, b, time));
        }
    }

    /** A root of |d + v t| = s, or {@code null}; 0 for two that touch. */
    private static BigDecimal root(BigDecimal dx, BigDecimal dy, BigDecimal ux, BigDecimal uy, BigDecimal s, int sign) {
        BigDecimal a = ux.multiply(ux).add(uy.multiply(uy));
        BigDecimal b = dx.multiply(ux).add(dy.multiply(uy));
        BigDecimal c = dx.multiply(dx).add(dy.multiply(dy)).subtract(s.multiply(s));
        BigDecimal d = b.multiply(b).subtract(a.multiply(c));
        if (d.signum() <= 0 || sign < 0 && b.signum() >= 0) {
            return null;
        }
        if (sign < 0 && c.signum() <= 0) {
            return BigDecimal.ZERO;
        }
        return b.negate().add(d.sqrt(DIGITS).multiply(BigDecimal.valueOf(sign))).divide(a, DIGITS);
    }

    private BigDecimal wallTime(Wall wall, int i) {
        if (wall instanceof Arena arena) {
            return root(x[i].subtract(new BigDecimal(arena.x())), y[i].subtract(new BigDecimal(arena.y())), vx[i],
                vy[i], new BigDecimal(arena.radius()).subtract(radius[i]), 1);
        }
        HalfPlane plane = (HalfPlane) wall;
        BigDecimal nx = new BigDecimal(plane.insideX());
        BigDecimal ny = new BigDecimal(plane.insideY());
        BigDecimal closing = vx[i].multiply(nx).add(vy[i].multiply(ny)).negate();
        BigDecimal gap = x[i].subtract(new BigDecimal(plane.x())).multiply(nx)
            .add(y[i].subtract(new BigDecimal(plane.y())).multiply(ny)).subtract(radius[i]);
        return closing.signum() <= 0 ? null : gap.divide(closing, DIGITS);
    }

    private void react() {
        if (tied.isEmpty()) {
            return;
        }
        BigDecimal time = tied.get(0).time;
        for (int k = 0; k < size; k++) {
            x[k] = x[k].add(vx[k].multiply(time), DIGITS);
            y[k] = y[k].add(vy[k].multiply(time), DIGITS);
        }
        for (Contact contact : tied) {
            if (contact.b < 0) {
                atWall(contact.a, ~contact.b);
            } else {
                between(contact.a, contact.b);
            }
        }
    }

    private void between(int i, int j) {
        BigDecimal nx = x[j].subtract(x[i]);
        BigDecimal ny = y[j].subtract(y[i]);
        BigDecimal length = nx.multiply(nx).add(ny.multiply(ny)).sqrt(DIGITS);
        nx = nx.divide(length, DIGITS);
        ny = ny.divide(length, DIGITS);
        BigDecimal approach = vx[i].subtract(vx[j]).multiply(nx).add(vy[i].subtract(vy[j]).multiply(ny));
        if (!approaches(approach)) {
            return;
        }
        impacts.add(i + " " + j);
        BigDecimal impulse = approach.multiply(BigDecimal.valueOf(2)).multiply(mass[i]).multiply(mass[j])
            .divide(mass[i].add(mass[j]), DIGITS);
        push(i, nx, ny, impulse.negate());
        push(j, nx, ny, impulse);
    }

    private void atWall(int i, int w) {
        BigDecimal nx;
        BigDecimal ny;
        if (walls.get(w) instanceof Arena arena) {
            nx = x[i].subtract(new BigDecimal(arena.x()));
            ny = y[i].subtract(new BigDecimal(arena.y()));
            BigDecimal length = nx.multiply(nx).add(ny.multiply(ny)).sqrt(DIGITS);
            nx = nx.divide(length, DIGITS);
            ny = ny.divide(length, DIGITS);
        } else {
            HalfPlane plane = (HalfPlane) walls.get(w);
            nx = new BigDecimal(-plane.insideX());
            ny = new BigDecimal(-plane.insideY());
        }
        BigDecimal approach = vx[i].multiply(nx).add(vy[i].multiply(ny));
        if (approaches(approach)) {
            impacts.add(i + " " + ~w);
            push(i, nx, ny, approach.multiply(BigDecimal.valueOf(-2)).multiply(mass[i]));
        }
    }

    private boolean approaches(BigDecimal approach) {
        clear &= approach.abs().compareTo(CLEAR) > 0;
        return approach.signum() > 0;
    }

    private void push(int i, BigDecimal nx, BigDecimal ny, BigDecimal impulse) {
        vx[i] = vx[i].add(nx.multiply(impulse).divide(mass[i], DIGITS), DIGITS);
        vy[i] = vy[i].add(ny.multiply(impulse).divide(mass[i], DIGITS), DIGITS);
    }
}
