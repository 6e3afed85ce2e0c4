package steward.lab.oracle;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/*
 * Wanted are the velocities nearest to given ones, measured by the kinetic energy, with n.(va - vb) <= limit for each
 * condition. D. Goldfarb and A. Idnani, "A numerically stable dual method for solving strictly convex quadratic
 * programs", 1983: begin without any condition; let the one that is broken most take an impulse t, while those before
 * keep what they have reached, until it holds or the impulse of another has vanished, which then is left out. With the
 * matrix G of those before, the vector g of what the new one shares with them and r = G^-1 g, they give up t r and the
 * speed along the new one falls by t (n.n w - g.r). The energy of what is taken rises with each step, so no set comes
 * twice. If the speed does not fall and no impulse vanishes, the conditions contradict each other.
 */

/**
 * Nearest velocities under linear conditions, in the oracle's arithmetic; the conditions of Karush, Kuhn and Tucker are
 * checked at the end.
 */
final class OracleProjection {

    /** Share of a normal that is not rounding: normals that are nearer to those before depend on them. */
    private static final BigDecimal DEPENDENT = BigDecimal.ONE.movePointLeft(36);
    /** Share of the speeds up to which a condition counts as met. */
    private static final BigDecimal MET = BigDecimal.ONE.movePointLeft(44);
    /** Share of the speeds up to which a condition counts as met after all steps. */
    private static final BigDecimal CHECKED = BigDecimal.ONE.movePointLeft(38);

    /** A condition on the speed at which body a approaches b, another or {@code ~wall}. */
    static final class Condition {

        final int a;
        final int b;
        BigDecimal nx;
        BigDecimal ny;
        BigDecimal limit;
        /** True if the speed has to be the limit. */
        boolean equal;
        /** Taken from a, and given to b. */
        BigDecimal impulse = BigDecimal.ZERO;

        Condition(int a, int b, BigDecimal nx, BigDecimal ny, BigDecimal limit) {
            this.a = a;
            this.b = b;
            this.nx = nx;
            this.ny = ny;
            this.limit = limit;
        }

        BigDecimal speed(BigDecimal[] x, BigDecimal[] y) {
            return b < 0 ? Decimals.dot(nx, ny, x[a], y[a])
                : Decimals.dot(nx, ny, x[a].subtract(x[b]), y[a].subtract(y[b]));
        }
    }

    private final List<OracleBody> bodies;
    final BigDecimal[] x;
    final BigDecimal[] y;
    private final BigDecimal[] fromX;
    private final BigDecimal[] fromY;
    private final BigDecimal scale;
    private final BigDecimal[] inverse;
    private List<Condition> active;
    private List<List<BigDecimal>> inverted;

    /** @param x with y, velocities before the impulses */
    OracleProjection(List<OracleBody> bodies, BigDecimal[] x, BigDecimal[] y) {
        this.bodies = bodies;
        fromX = x;
        fromY = y;
        this.x = x.clone();
        this.y = y.clone();
        inverse = bodies.stream().map(OracleBody::inverseMass).toArray(BigDecimal[]::new);
        BigDecimal most = BigDecimal.ZERO;
        for (int k = 0; k < x.length; k++) {
            most = most.max(x[k].abs()).max(y[k].abs());
        }
        scale = most;
    }

    /** Finds the velocities. @return false if no velocities meet all conditions */
    boolean solve(List<Condition> conditions) {
        active = new ArrayList<>();
        inverted = new ArrayList<>();
        System.arraycopy(fromX, 0, x, 0, x.length);
        System.arraycopy(fromY, 0, y, 0, y.length);
        conditions.forEach(each -> each.impulse = BigDecimal.ZERO);
        for (Condition next = worst(conditions); next != null; next = worst(conditions)) {
            if (!enter(next)) {
                return false;
            }
        }
        check(conditions);
        return true;
    }

    private BigDecimal excess(Condition condition) {
        BigDecimal excess = condition.speed(x, y).subtract(condition.limit);
        return condition.equal ? excess.abs() : excess;
    }

    private Condition worst(List<Condition> conditions) {
        Condition worst = null;
        BigDecimal most = MET.multiply(scale);
        for (Condition condition : conditions) {
            BigDecimal excess = active.contains(condition) ? BigDecimal.ZERO : excess(condition);
            if (excess.compareTo(most) > 0) {
                most = excess;
                worst = condition;
            }
        }
        return worst;
    }

    /** Lets a condition take an impulse until it is met. */
    private boolean enter(Condition next) {
        boolean opens = next.speed(x, y).compareTo(next.limit) < 0;
        for (;;) {
            BigDecimal[] shared = active.stream().map(each -> coupling(each, next)).toArray(BigDecimal[]::new);
            BigDecimal[] given = new BigDecimal[shared.length];
            BigDecimal own = coupling(next, next);
            BigDecimal falls = own;
            for (int k = 0; k < given.length; k++) {
                BigDecimal sum = BigDecimal.ZERO;
                for (int l = 0; l < given.length; l++) {
                    sum = sum.add(inverted.get(k).get(l).multiply(shared[l]));
                }
                given[k] = Decimals.round(sum);
                falls = falls.subtract(given[k].multiply(shared[k]));
            }
            falls = Decimals.round(falls);
            boolean depends = falls.compareTo(own.multiply(DEPENDENT)) <= 0;
            BigDecimal step = depends ? null : Decimals.divide(excess(next), falls);
            int leaves = -1;
            for (int k = 0; k < given.length; k++) {
                BigDecimal gives = opens ? given[k].negate() : given[k];
                if (gives.compareTo(DEPENDENT) > 0 && !active.get(k).equal) {
                    BigDecimal until = Decimals.divide(active.get(k).impulse, gives);
                    if (step == null || until.compareTo(step) < 0) {
                        step = until;
                        leaves = k;
                    }
                }
            }
            if (step == null) {
                return false;
            }
            BigDecimal signed = opens ? step.negate() : step;
            take(next, signed);
            for (int k = 0; k < given.length; k++) {
                take(active.get(k), signed.multiply(given[k]).negate());
            }
            if (leaves < 0) {
                border(next, given, falls);
                return true;
            }
            leave(leaves);
        }
    }

    private void take(Condition condition, BigDecimal impulse) {
        condition.impulse = Decimals.round(condition.impulse.add(impulse));
        push(condition, condition.a, impulse.negate(), x, y);
        if (condition.b >= 0) {
            push(condition, condition.b, impulse, x, y);
        }
    }

    private void push(Condition along, int body, BigDecimal impulse, BigDecimal[] ofX, BigDecimal[] ofY) {
        BigDecimal change = impulse.multiply(inverse[body]);
        ofX[body] = Decimals.round(ofX[body].add(change.multiply(along.nx)));
        ofY[body] = Decimals.round(ofY[body].add(change.multiply(along.ny)));
    }

    /** The change of speed along one condition by an impulse of 1 along another. */
    private BigDecimal coupling(Condition one, Condition other) {
        BigDecimal weight = share(one, one.a, other).subtract(one.b < 0 ? BigDecimal.ZERO : share(one, one.b, other));
        return Decimals.round(weight.multiply(Decimals.dot(one.nx, one.ny, other.nx, other.ny)));
    }

    private BigDecimal share(Condition one, int body, Condition other) {
        return body == other.a ? inverse[body] : body == other.b ? inverse[body].negate() : BigDecimal.ZERO;
    }

    /** Adds a row and a column to the inverse of the matrix of the active conditions. */
    private void border(Condition next, BigDecimal[] given, BigDecimal falls) {
        List<BigDecimal> last = new ArrayList<>();
        for (int k = 0; k < given.length; k++) {
            BigDecimal part = Decimals.divide(given[k], falls);
            for (int l = 0; l < given.length; l++) {
                inverted.get(k).set(l, Decimals.round(inverted.get(k).get(l).add(part.multiply(given[l]))));
            }
            inverted.get(k).add(part.negate());
            last.add(part.negate());
        }
        last.add(Decimals.divide(BigDecimal.ONE, falls));
        inverted.add(last);
        active.add(next);
    }

    private void leave(int j) {
        active.remove(j).impulse = BigDecimal.ZERO;
        List<BigDecimal> gone = inverted.remove(j);
        BigDecimal pivot = gone.remove(j);
        for (int k = 0; k < inverted.size(); k++) {
            BigDecimal part = Decimals.divide(inverted.get(k).remove(j), pivot);
            for (int l = 0; l < gone.size(); l++) {
                inverted.get(k).set(l, Decimals.round(inverted.get(k).get(l).subtract(part.multiply(gone.get(l)))));
            }
        }
    }

    /** Checks that velocities are those of the impulses, conditions hold, and impulses push and do so in contact. */
    private void check(List<Condition> conditions) {
        BigDecimal[] ofX = fromX.clone();
        BigDecimal[] ofY = fromY.clone();
        BigDecimal most = CHECKED.multiply(scale);
        for (Condition each : conditions) {
            push(each, each.a, each.impulse.negate(), ofX, ofY);
            if (each.b >= 0) {
                push(each, each.b, each.impulse, ofX, ofY);
            }
            boolean slack = each.speed(x, y).subtract(each.limit).abs().compareTo(most) > 0;
            require(excess(each).compareTo(most) <= 0 && (each.impulse.signum() == 0 || !slack)
                && (each.equal || each.impulse.signum() >= 0), each.a);
        }
        for (int k = 0; k < x.length; k++) {
            require(ofX[k].subtract(x[k]).abs().max(ofY[k].subtract(y[k]).abs()).compareTo(most) <= 0, k);
        }
    }

    private void require(boolean met, int body) {
        if (!met) {
            throw new IllegalStateException("the nearest velocities of a heap of " + bodies.size()
                + " are not those of its impulses, at body " + body);
        }
    }
}
