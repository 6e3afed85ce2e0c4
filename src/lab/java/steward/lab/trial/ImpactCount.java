package steward.lab.trial;

import steward.physics.TurnSink;

/** Observer of turns that stores none: it counts impacts. */
public class ImpactCount implements TurnSink {

    /** Impacts so far. */
    public long impacts;

    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                       double j, double energy, double massA, double massB, double vax, double vay, double vaxAfter,
                       double vayAfter, double vbx, double vby, double vbxAfter, double vbyAfter) {
        impacts++;
    }
}
