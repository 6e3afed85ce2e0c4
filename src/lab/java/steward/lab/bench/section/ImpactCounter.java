package steward.lab.bench.section;

import steward.physics.TurnSink;

/** Counts impacts and stores none. */
final class ImpactCounter implements TurnSink {

    private long impacts;

    long impacts() {
        return impacts;
    }

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                       double normalX, double normalY, double impulse, double energy, double massA, double massB,
                       double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                       double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
        impacts++;
    }

    @Override
    public void knot(int bodyId, double time, double x, double y) {
        return;
    }

    @Override
    public void impactLimit(double time, int[] bodyIds) {
        throw new IllegalStateException("a turn reached the bound on impacts");
    }
}
