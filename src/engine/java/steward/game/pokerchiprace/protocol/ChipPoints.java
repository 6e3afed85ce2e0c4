package steward.game.pokerchiprace.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.game.pokerchiprace.ChipEating;
import steward.game.pokerchiprace.ChipTable;
import steward.physics.Bodies;
import steward.physics.TurnSink;

/**
 * Points of the chips' paths in one turn, as the site draws them, collected while the turn is played. A point is where
 * a chip is born, hits a wall or another chip, eats or is eaten. Facts of the published referee: a point replaces one
 * of the same time; a point within 2 u of the last, with the same radius, is left out; from the ninth on, only points
 * at which the radius has changed are kept; the point behind a meal is always kept.
 */
final class ChipPoints implements TurnSink {

    private static final double NEAR = 2;
    private static final int MOST = 8;

    /** A chip on its path. @param other the chip it has eaten here or was ejected from, or -1 */
    record Point(double time, double x, double y, double radius, double rotation, int other) { }

    private final Bodies bodies;
    /** By the id of a chip the angle of its picture, in radians: where it was pushed, or where its last meal was. */
    private final Map<Integer, Double> rotations;
    private final Map<Integer, List<Point>> points = new TreeMap<>();
    private final Map<Integer, Point> lastKnot = new TreeMap<>();
    private int eater = -1;
    private int eaten = -1;

    /** @param bodies after the pushes, before anything has moved */
    ChipPoints(Bodies bodies, Map<Integer, Double> rotations) {
        this.bodies = bodies;
        this.rotations = rotations;
        for (int chip = 0; chip < bodies.size(); chip++) {
            int parent = (int) bodies.columns[ChipTable.PARENT][chip];
            if (parent >= 0) {
                of(bodies.id(chip)).add(point(bodies.id(chip), 0, bodies.x[chip], bodies.y[chip],
                    bodies.radius[chip], parent));
            }
        }
    }

    /** The points of a chip, in order; none if it has flown freely. */
    List<Point> of(int id) {
        return points.computeIfAbsent(id, chip -> new ArrayList<>());
    }

    private Point point(int id, double time, double x, double y, double radius, int other) {
        return new Point(time, x, y, radius, rotations.getOrDefault(id, 0.0), other);
    }

    @Override
    public void knot(int id, double time, double x, double y) {
        Point knot = point(id, time, x, y, bodies.radius[bodies.indexOf(id)], id == eater ? eaten : -1);
        if (id == eater) {
            of(id).add(knot);
            eater = -1;
        } else {
            add(id, knot);
        }
        lastKnot.put(id, knot);
    }

    private void add(int id, Point point) {
        List<Point> all = of(id);
        boolean radiusChanged = false;
        if (!all.isEmpty()) {
            Point last = all.get(all.size() - 1);
            if (last.time == point.time) {
                all.remove(all.size() - 1);
            } else {
                radiusChanged = last.radius != point.radius;
                double dx = point.x - last.x;
                double dy = point.y - last.y;
                if (!radiusChanged && Math.sqrt(dx * dx + dy * dy) < NEAR) {
                    return;
                }
            }
        }
        if (all.size() < MOST || radiusChanged) {
            all.add(point);
        }
    }

    /** The knots of both were told just before; that of the eater after the meal is next. */
    @Override
    public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
        if (kind != ChipEating.EATEN && kind != ChipEating.EATEN_AGAIN) {
            return;
        }
        if (kind == ChipEating.EATEN) {
            add(a, point(a, time, x, y, -1, -1));
        }
        Point at = lastKnot.get(b);
        rotations.put(b, StrictMath.atan2(y - at.y, x - at.x));
        eater = b;
        eaten = a;
    }
}
