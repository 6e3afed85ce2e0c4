package steward.physics.event.pairs;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.event.flight.FreeFlights;
import steward.physics.time.LowParts;
import steward.physics.time.PreciseFlight;
import steward.physics.time.SimultaneousImpacts;

/**
 * Free flights with neighbours by all pairs: the position of a body in {@link Bodies} is that of the start of its
 * present flight.
 */
public final class PairFlights extends FreeFlights {

    /** The start of the flight of each body, as a time of the turn, and its low part if times are double-doubles. */
    double[] since = new double[0];
    double[] sinceLow = new double[0];
    private final boolean descending;
    private final PairSearch search;
    private final PreciseFlight flight = new PreciseFlight();
    /** Starts of flights while all bodies are where they are now. */
    private double[] startX = new double[0];
    private double[] startY = new double[0];

    public PairFlights(PhysicsParts parts, LowParts lows) {
        super(parts, lows);
        descending = parts.law().scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        search = new PairSearch(parts, this);
    }

    @Override
    public void startAll(double now) {
        int size = bodies.size();
        if (since.length < size) {
            since = new double[bodies.capacity()];
            sinceLow = new double[exact ? bodies.capacity() : 0];
        }
        Arrays.fill(since, 0, size, now);
        if (exact) {
            Arrays.fill(sinceLow, 0, size, nowLow);
            lows.clearFirst(size);
        }
        search.searchAll(bodies, now);
    }

    @Override
    public int next() {
        int row = search.earliest(bodies.size());
        if (row >= 0) {
            nextTime = search.time[row];
            nextPartner = search.partner[row];
            nowLow = exact ? search.timeLow[row] : 0;
        }
        return row;
    }

    @Override
    public SimultaneousImpacts simultaneous(int body) {
        return exact ? search.simultaneous(bodies, body) : null;
    }

    @Override
    public void predictAfter(int body, int partner, double now) {
        search.searchAfter(bodies, body, partner, now);
    }

    @Override
    public void predictAfter(SimultaneousImpacts together, int done, double now) {
        for (int k = 0; k < done; k++) {
            search.searchAfter(bodies, together.a(k), together.b(k), now);
        }
    }

    @Override
    public void show(int body, int partner) {
        boolean swapped = descending && partner >= 0;
        a = swapped ? partner : body;
        b = swapped ? body : partner;
    }

    @Override
    public void take() {
        // the bodies that were shown are those that fly
    }

    @Override
    public void showAll(double now) {
        if (startX.length < bodies.size()) {
            startX = new double[bodies.capacity()];
            startY = new double[bodies.capacity()];
        }
        for (int i = 0; i < bodies.size(); i++) {
            startX[i] = bodies.x[i];
            startY[i] = bodies.y[i];
            if (i != a && i != b) {
                store(i, now);
            }
        }
    }

    @Override
    public void hideAll() {
        for (int i = 0; i < bodies.size(); i++) {
            if (i != a && i != b) {
                bodies.x[i] = startX[i];
                bodies.y[i] = startY[i];
            }
        }
    }

    @Override
    public boolean mayTouchOthers(double gapShare, double now) {
        return true;                                   // to show all of few bodies costs no more than to look
    }

    @Override
    public void endAll(double now) {
        for (int i = 0; i < bodies.size(); i++) {
            store(i, now);
        }
    }

    /** Writes the position of a body at a time, without ending its flight. */
    private void store(int i, double now) {
        if (!exact) {
            double time = now - since[i];
            bodies.x[i] = bodies.x[i] + bodies.vx[i] * time;
            bodies.y[i] = bodies.y[i] + bodies.vy[i] * time;
        } else if (now - since[i] == 1 && nowLow - sinceLow[i] == 0) { // no impact in this turn: one rounding, no -0.0
            bodies.x[i] = bodies.x[i] + bodies.vx[i] + 0.0;
            bodies.y[i] = bodies.y[i] + bodies.vy[i] + 0.0;
        } else {
            double time = flight.elapsed(since[i], sinceLow[i], now, nowLow);
            bodies.x[i] = flight.coordinate(bodies.x[i], bodies.vx[i], time);
            bodies.y[i] = flight.coordinate(bodies.y[i], bodies.vy[i], time);
        }
    }

    @Override
    protected double since(int body) {
        return since[body];
    }

    @Override
    protected double sinceLow(int body) {
        return sinceLow[body];
    }

    @Override
    protected void fly(int i, double now) {
        if (!exact) {
            double time = now - since[i];
            bodies.x[i] += bodies.vx[i] * time;
            bodies.y[i] += bodies.vy[i] * time;
            since[i] = now;
            return;
        }
        double time = flight.elapsed(since[i], sinceLow[i], now, nowLow);
        since[i] = now;
        sinceLow[i] = nowLow;
        bodies.x[i] = flight.coordinate(bodies.x[i], bodies.vx[i], time);
        lows.x[i] = flight.placeLow;
        bodies.y[i] = flight.coordinate(bodies.y[i], bodies.vy[i], time);
        lows.y[i] = flight.placeLow;
    }
}
