package steward.physics.event.flight;

import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.time.LowParts;
import steward.physics.time.SimultaneousImpacts;

/**
 * Free flights of all bodies, with the predicted next impact of each, as the event loop sees them. Each body has a
 * local clock: its flight begins at the start of the turn and at each impact of its own, and only then it is moved. So
 * the path of a body, and the time at which two meet, do not depend on impacts elsewhere, not even in the last bit. If
 * a heap comes to rest, or a reaction of the scene alters others than its two, all flights begin anew. A way to find
 * neighbours has its own layout of bodies, and numbers them as it likes.
 *
 * <p>In the arithmetic {@code EXACT} times are double-doubles, and a coordinate is rounded once, when it is stored; an
 * impact gets the rounding error.
 */
public abstract class FreeFlights {

    /** The low part of the present time; 0 where times are doubles. */
    public double nowLow;
    /** The time of the next impact, and the partner of the body that has it: another body, or {@code ~wall}. */
    public double nextTime;
    public int nextPartner;
    /** True if times are double-doubles. */
    protected final boolean exact;
    /** Low parts that rounding took from the coordinates of the two that {@link #show} shows. */
    protected final LowParts lows;
    protected Bodies bodies;
    /** Bodies that the two of an impact are shown in, and their indices there, in the order in which they react. */
    protected Bodies shown;
    protected int a;
    protected int b;

    protected FreeFlights(PhysicsParts parts, LowParts lows) {
        exact = parts.arithmetic().isExact();
        this.lows = lows;
    }

    /** Begins a turn. @return the sink for impacts of bodies as {@link #show} shows them */
    public TurnSink begin(Bodies ofTurn, TurnSink sink) {
        bodies = ofTurn;
        shown = ofTurn;
        if (exact) {
            lows.ensureCapacity(ofTurn.capacity());
        }
        return sink;
    }

    /** Starts the flights of all bodies where they are, and predicts their impacts. */
    public abstract void startAll(double now);

    /** Makes the earliest impact the next. @return a body that has it, or -1 if there is none */
    public abstract int next();

    /**
     * The impacts at the time of the next one, which a body has, where that has to be decided by other means than the
     * order of times: {@code null} for one alone.
     */
    public abstract SimultaneousImpacts simultaneous(int body);

    /** Predicts the impacts of two bodies after theirs. @param partner a body, or negative */
    public abstract void predictAfter(int body, int partner, double now);

    /** Predicts the impacts of all bodies of simultaneous impacts, of which the first {@code done} have happened. */
    public abstract void predictAfter(SimultaneousImpacts together, int done, double now);

    /**
     * Shows the two of an impact, which have been moved to it, to the law of impact: see {@link #shown}.
     *
     * @param partner a body, or {@code ~wall}
     */
    public abstract void show(int body, int partner);

    /** Bodies among which are the two that were shown last. */
    public final Bodies shown() {
        return shown;
    }

    /** The index in {@link #shown} of the body that reacts first. */
    public final int a() {
        return a;
    }

    /** The index in {@link #shown} of the other, or {@code ~wall}. */
    public final int b() {
        return b;
    }

    /** Continues the flights of the two that were shown as an impact has left them. */
    public abstract void take();

    /** Moves all other bodies of the turn to the present time. */
    public abstract void showAll(double now);

    /** Continues the flights of all but the two, which were shown. */
    public abstract void hideAll();

    /** True if anything but the two may be within a small gap of one of them, as a share of the radii. */
    public abstract boolean mayTouchOthers(double gapShare, double now);

    /** Moves all bodies of the turn to a time. */
    public abstract void endAll(double now);

    /** The start of a flight. */
    protected abstract double since(int body);

    /** The low part of the start of a flight. */
    protected abstract double sinceLow(int body);

    /** Starts a new flight of a body at its place at the present time. */
    protected abstract void fly(int body, double now);

    /** The start of the flight of i minus that of j; its sign is exact. */
    public final double clockDifference(int i, int j) {
        double difference = since(i) - since(j);
        return difference != 0 || !exact ? difference : sinceLow(i) - sinceLow(j);
    }

    /**
     * Starts new flights of two bodies at their impact. Where positions are rounded once, its time was computed from
     * the positions at the later start of the two flights; so the other body is moved to that time first: then the two
     * touch now, to the last digit of the double-doubles.
     *
     * @param partner a body, or negative
     */
    public final void flyToImpact(int body, int partner, double now) {
        if (exact && partner >= 0) {
            double ahead = clockDifference(body, partner);
            if (ahead != 0) {
                double kept = nowLow;
                int later = ahead > 0 ? body : partner;
                nowLow = sinceLow(later);
                fly(ahead > 0 ? partner : body, since(later));
                nowLow = kept;
            }
        }
        fly(body, now);
        if (partner >= 0) {
            fly(partner, now);
        }
    }
}
