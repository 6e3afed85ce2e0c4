package steward.physics;

/**
 * Turn sink that passes everything on to two others.
 *
 * @param other who looks on, and hears everything first
 */
public record TeeSink(TurnSink target, TurnSink other) implements TurnSink {

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                       double normalX, double normalY, double impulse, double energy, double massA, double massB,
                       double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                       double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
        other.impact(time, a, b, ax, ay, bx, by, normalX, normalY, impulse, energy, massA, massB, vaxBefore, vayBefore,
            vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
        target.impact(time, a, b, ax, ay, bx, by, normalX, normalY, impulse, energy, massA, massB, vaxBefore, vayBefore,
            vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
    }

    @Override
    public void knot(int bodyId, double time, double x, double y) {
        other.knot(bodyId, time, x, y);
        target.knot(bodyId, time, x, y);
    }

    @Override
    public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
        other.fact(time, kind, a, b, x, y, p, q);
        target.fact(time, kind, a, b, x, y, p, q);
    }

    @Override
    public void rest(double time, double energy) {
        other.rest(time, energy);
        target.rest(time, energy);
    }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        other.impactLimit(time, bodyIds);
        target.impactLimit(time, bodyIds);
    }
}
