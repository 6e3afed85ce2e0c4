package steward.physics.event;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.time.LowParts;
import steward.physics.time.PreciseFlight;

/**
 * The free flights of bodies with a local clock each: the position of a body in {@link Bodies} is that of the start of
 * its present flight, which begins at the start of the turn and at each impact of its own. So the path of a body, and
 * the time at which two meet, do not depend on what happens elsewhere, not even in the last bit.
 */
sealed class Flights permits Flights.Precise {

    /** The start of the flight of each body, as a time of the turn. */
    double[] since = new double[0];

    /** Begins a turn, or all flights anew at the present time, with the bodies where they are. */
    void startAll(Bodies bodies, double now) {
        if (since.length < bodies.size()) {
            since = new double[bodies.capacity()];
        }
        Arrays.fill(since, 0, bodies.size(), now);
    }

    /** Writes the position of a body at a time, without ending its flight. */
    void store(Bodies bodies, int i, double now) {
        double time = now - since[i];
        bodies.x[i] = bodies.x[i] + bodies.vx[i] * time;
        bodies.y[i] = bodies.y[i] + bodies.vy[i] * time;
    }

    /** Starts a new flight of a body at its position at a time. */
    void flyTo(Bodies bodies, int i, double now) {
        double time = now - since[i];
        bodies.x[i] += bodies.vx[i] * time;
        bodies.y[i] += bodies.vy[i] * time;
        since[i] = now;
    }

    /** Starts new flights of a pair at the time of its impact. */
    void flyToContact(Bodies bodies, int a, int b, double now) {
        flyTo(bodies, a, now);
        flyTo(bodies, b, now);
    }

    /** Takes the low part of the present time from a prediction; 0 where times are doubles. */
    void setNowLow(double low) {
        // here a time is a double and no more
    }

    /** The low part of the present time. */
    double nowLow() {
        return 0;
    }

    /**
     * With times in double-double. A coordinate is rounded once, when it is stored; an impact is given what is lost.
     */
    static final class Precise extends Flights {

        double[] sinceLow = new double[0];
        private double nowLow;
        private final LowParts lows;
        private final PreciseFlight flight = new PreciseFlight();

        Precise(LowParts lows) {
            this.lows = lows;
        }

        @Override
        void setNowLow(double low) {
            nowLow = low;
        }

        @Override
        double nowLow() {
            return nowLow;
        }

        @Override
        void startAll(Bodies bodies, double now) {
            super.startAll(bodies, now);
            if (sinceLow.length < bodies.size()) {
                sinceLow = new double[bodies.capacity()];
            }
            Arrays.fill(sinceLow, 0, bodies.size(), nowLow);
            lows.ensureCapacity(bodies.capacity());
            lows.clearFirst(bodies.size());
        }

        @Override
        void store(Bodies bodies, int i, double now) {
            if (now - since[i] == 1 && nowLow - sinceLow[i] == 0) { // no impact in this turn: one rounding, and no -0.0
                bodies.x[i] = bodies.x[i] + bodies.vx[i] + 0.0;
                bodies.y[i] = bodies.y[i] + bodies.vy[i] + 0.0;
            } else {
                double time = flight.elapsed(since[i], sinceLow[i], now, nowLow);
                bodies.x[i] = flight.coordinate(bodies.x[i], bodies.vx[i], time);
                bodies.y[i] = flight.coordinate(bodies.y[i], bodies.vy[i], time);
            }
        }

        @Override
        void flyTo(Bodies bodies, int i, double now) {
            double time = flight.elapsed(since[i], sinceLow[i], now, nowLow);
            since[i] = now;
            sinceLow[i] = nowLow;
            bodies.x[i] = flight.coordinate(bodies.x[i], bodies.vx[i], time);
            lows.x[i] = flight.placeLow;
            bodies.y[i] = flight.coordinate(bodies.y[i], bodies.vy[i], time);
            lows.y[i] = flight.placeLow;
        }

        /** The start of the flight of i minus that of j; its sign is exact. */
        double clockDifference(int i, int j) {
            double difference = since[i] - since[j];
            return difference != 0 ? difference : sinceLow[i] - sinceLow[j];
        }

        /**
         * The time of impact was computed from the positions at the later start of the two flights; so the other body
         * is moved to that time first: then the two touch now, to the last digit of the double-doubles.
         */
        @Override
        void flyToContact(Bodies bodies, int a, int b, double now) {
            double ahead = clockDifference(a, b);
            if (ahead != 0) {
                double kept = nowLow;
                int later = ahead > 0 ? a : b;
                nowLow = sinceLow[later];
                flyTo(bodies, ahead > 0 ? b : a, since[later]);
                nowLow = kept;
            }
            super.flyToContact(bodies, a, b, now);
        }
    }
}
