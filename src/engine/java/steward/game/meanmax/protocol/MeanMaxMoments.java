package steward.game.meanmax.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Sinking;
import steward.game.meanmax.UnitKind;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnSink;

/** Lines of a view about the impacts of a turn and the units at its end, collected while the turn is played. */
final class MeanMaxMoments implements TurnSink {

    private final Bodies bodies;
    private final Set<Integer> known;
    private final List<String> before = new ArrayList<>();
    private final List<String> atEnd = new ArrayList<>();
    private final List<Integer> ids = new ArrayList<>();

    /** @param known ids of units that were shown before: the first line of a unit tells what it is */
    MeanMaxMoments(Bodies bodies, Set<Integer> known) {
        this.bodies = bodies;
        this.known = known;
    }

    /** Adds all units as they are, at time 1. */
    void end() {
        before.add("#1.00000");
        for (int unit = 0; unit < bodies.size(); unit++) {
            ids.add(bodies.id(unit));
            atEnd.add(unit(unit, bodies.x[unit], bodies.y[unit], bodies.vx[unit], bodies.vy[unit], ""));
        }
    }

    /** The lines up to that of the end. */
    List<String> before() {
        return before;
    }

    /** A line per unit at the end. */
    List<String> atEnd() {
        return atEnd;
    }

    int idAtEnd(int line) {
        return ids.get(line);
    }

    List<String> lines() {
        List<String> lines = new ArrayList<>(before);
        lines.addAll(atEnd);
        return lines;
    }

    private static long rounded(double value) {
        return (long) Motion.roundHalfAway(value);
    }

    private String unit(int index, double x, double y, double vx, double vy, String more) {
        boolean tanker = bodies.kind[index] == UnitKind.TANKER.ordinal();
        String what = !known.add(bodies.id(index)) ? "" : " " + bodies.kind[index] + " " + (int) bodies.radius[index]
            + (tanker ? "" : " " + (int) bodies.columns[MeanMaxWorld.OWNER][index]);
        return bodies.id(index) + (tanker ? "@" + (int) bodies.columns[MeanMaxWorld.WATER][index] : "") + " "
            + rounded(x) + " " + rounded(y) + " " + rounded(vx) + " " + rounded(vy) + what + more;
    }

    private void at(double when) {
        before.add(String.format(Locale.ROOT, "#%.5f", when));
    }

    @Override
    public void impact(double when, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                       double impulse, double energy, double massA, double massB, double vaxBefore, double vayBefore,
                       double vaxAfter, double vayAfter, double vbxBefore, double vbyBefore, double vbxAfter,
                       double vbyAfter) {
        at(when);
        before.add(unit(bodies.indexOf(a), ax, ay, vaxBefore, vayBefore, ""));
        if (b >= 0) {
            before.add(unit(bodies.indexOf(b), bx, by, vbxBefore, vbyBefore, ""));
        }
    }

    @Override
    public void fact(double when, int kind, int a, int b, double x, double y, double p, double q) {
        if (kind == Sinking.SUNK) {
            at(when);
            int index = bodies.indexOf(a);
            before.add(unit(index, x, y, bodies.vx[index], bodies.vy[index], " d"));
        } else {
            before.add(b + "@" + (int) p + " " + rounded(x) + " " + rounded(y) + " 0 0 4 " + q);
        }
    }
}
