package steward.game.bodies;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Reaction;
import steward.physics.TurnLog;
import steward.physics.TurnSink;

/*
 * A turn is played, and its paths are looked at. If one enters a pocket, the turn is played again from its start: the
 * same bits up to that entry, and from the last impact before it on the disc is of another kind, LEAVING, which asks at
 * each contact. The first that it comes to makes it GONE: it meets nothing any more, and all is predicted anew. A later
 * entry is found in the turn as it then is. So a turn is played once more for each disc that is taken out in it, and
 * once where none is. A disc that is leaving belongs to no heap that comes to rest before its entry. If another zone
 * ends the game first, the disc is still there at the end of the turn, and may overlap.
 */

/**
 * Zones that remove discs during a turn: from its entry on a disc has no impacts. The disc itself flies on to the end
 * of the turn, where the game removes it.
 */
final class Pockets implements Reaction {

    private static final int DISC = 0;
    private static final int LEAVING = 1;
    private static final int GONE = 2;

    private final ZonePassings passings;
    /** All impacts of the turn, since what it tells has to wait until nobody leaves. */
    private final TurnLog log = new TurnLog();
    private final Bodies start;
    /** Times of the impacts and knots of the turn, in their order. */
    private double[] told = new double[16];
    private int tellings;
    /** Ids of discs that leave in this turn, when, and after how many impacts and knots. */
    private final int[] leavers;
    private final double[] times;
    private final int[] after;
    private int leaving;
    private Bodies turning;
    private final TurnSink recorder = new TurnSink() {
        @Override
        public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                           double normalX, double normalY, double impulse, double energy, double massA, double massB,
                           double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                           double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
            log.impact(time, a, b, ax, ay, bx, by, normalX, normalY, impulse, energy, massA, massB, vaxBefore,
                vayBefore, vaxAfter, vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter);
            count(time);
        }

        @Override
        public void knot(int bodyId, double time, double x, double y) {
            log.knot(bodyId, time, x, y);
            count(time);
        }

        @Override
        public void rest(double time, double energy) {
            log.rest(time, energy);
        }

        @Override
        public void impactLimit(double time, int[] bodyIds) {
            log.impactLimit(time, bodyIds);
        }
    };

    /**
     * @param zones of which some take discs out on their way
     * @param like  as many bodies as there are
     * @param discs how many of them are discs
     */
    Pockets(Zone[] zones, Bodies like, int discs) {
        passings = new ZonePassings(Arrays.stream(zones).filter(Zone::isPocket).toArray(Zone[]::new), discs);
        start = like.copy();
        leavers = new int[discs];
        times = new double[discs];
        after = new int[discs];
    }

    /** Meanings of contacts in a scene with pockets. */
    static Contacts contacts() {
        Contacts contacts = new Contacts(GONE + 1);
        for (int kind = DISC; kind <= GONE; kind++) {
            contacts.set(LEAVING, kind, Contacts.Meaning.ASK);
        }
        for (int kind = DISC; kind <= GONE; kind++) {
            contacts.set(GONE, kind, Contacts.Meaning.NONE);
        }
        return contacts.setWall(LEAVING, Contacts.Meaning.ASK).setWall(GONE, Contacts.Meaning.NONE);
    }

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        if (bodies.kind[a] == LEAVING) {
            bodies.setKind(a, GONE);
        }
        if (b >= 0 && bodies.kind[b] == LEAVING) {
            bodies.setKind(b, GONE);
        }
        return Verdict.CHANGED;
    }

    /** An advance in whose turns discs that have left meet nothing. @param first true in the first turn of a game */
    Advance around(Advance inner, BooleanSupplier first) {
        return (bodies, sink) -> {
            start.copyFrom(bodies);
            leaving = 0;
            play(inner, bodies, first.getAsBoolean());
            while (findNext()) {
                bodies.copyFrom(start);
                play(inner, bodies, first.getAsBoolean());
            }
            for (int k = 0; k < leaving; k++) {
                bodies.setKind(bodies.indexOf(leavers[k]), DISC);
            }
            tell(sink);
        };
    }

    private void play(Advance inner, Bodies bodies, boolean first) {
        log.clear();
        tellings = 0;
        turning = bodies;
        passings.begin(bodies, first);
        letLeave();
        inner.turn(bodies, recorder);
        passings.follow(log);
        passings.end(bodies);
    }

    private void count(double time) {
        if (tellings == told.length) {
            told = Arrays.copyOf(told, 2 * tellings);
        }
        told[tellings++] = time;
        letLeave();
    }

    /** Makes leaving discs of those that have had their last impact. */
    private void letLeave() {
        for (int k = 0; k < leaving; k++) {
            int body = turning.indexOf(leavers[k]);
            if (after[k] == tellings && turning.kind[body] == DISC) {
                turning.setKind(body, LEAVING);
            }
        }
    }

    /** Finds the earliest entry of a disc that is not known to leave. @return false if there is none */
    private boolean findNext() {
        for (int k = 0; k < passings.size(); k++) {
            int disc = passings.disc(k);
            boolean isKnown = false;
            for (int other = 0; other < leaving; other++) {
                isKnown |= leavers[other] == disc;
            }
            if (!isKnown) {
                int before = 0;
                while (before < tellings && told[before] <= passings.time(k)) {
                    before++;
                }
                leavers[leaving] = disc;
                times[leaving] = passings.time(k);
                after[leaving++] = before;
                return true;
            }
        }
        return false;
    }

    /** Tells what happened; of a path that has ended, nothing that is behind its end. */
    private void tell(TurnSink sink) {
        for (int k = 0; k < log.impacts(); k++) {
            sink.impact(log.impactTime(k), log.impactA(k), log.impactB(k), log.impactNumber(k, 0),
                log.impactNumber(k, 1), log.impactNumber(k, 2), log.impactNumber(k, 3), log.impactNumber(k, 4),
                log.impactNumber(k, 5), log.impactNumber(k, 6), log.impactNumber(k, 7), log.impactNumber(k, 8),
                log.impactNumber(k, 9), log.impactNumber(k, 10), log.impactNumber(k, 11), log.impactNumber(k, 12),
                log.impactNumber(k, 13), log.impactNumber(k, 14), log.impactNumber(k, 15), log.impactNumber(k, 16),
                log.impactNumber(k, 17));
        }
        for (int k = 0; k < log.knots(); k++) {
            if (log.knotTime(k) <= end(log.knotBody(k))) {
                sink.knot(log.knotBody(k), log.knotTime(k), log.knotX(k), log.knotY(k));
            }
        }
        if (log.restEnergy() != 0) {
            sink.rest(1, log.restEnergy());
        }
        if (log.limited()) {
            sink.impactLimit(log.limitTime(), log.limitBodies());
        }
    }

    /** Returns when the path of a body ends in this turn. */
    private double end(int id) {
        for (int k = 0; k < leaving; k++) {
            if (leavers[k] == id) {
                return times[k];
            }
        }
        return 1;
    }
}
