package steward.game.podrace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;
import steward.scene.Bumper;
import steward.scene.Field;

/** The places where the centre of a pod can be, in parts that no way connects, numbered as they are met. */
final class FreePlaces {

    private final Field field;
    private final List<Obstacle> obstacles;
    private final double grown;
    private final Separation separation;
    /** A place of each part, {@code [n][x, y]}. */
    private final List<double[]> parts = new ArrayList<>();
    private long work;

    /**
     * @param grown by how much obstacles are, in u
     * @param work  how many steps may be taken
     */
    FreePlaces(Field field, List<Obstacle> obstacles, double grown, long work) {
        this.field = field;
        this.obstacles = obstacles;
        this.grown = grown;
        this.work = work;
        separation = new Separation(field, grown);
    }

    /** True if all places are one part. */
    boolean isOne() {
        return separation.size() == 0;
    }

    /** True if the steps are used up, so that parts may be missing. */
    boolean isExhausted() {
        return work < 0;
    }

    /** Adds the part of a place, if that is free. */
    void addPart(double x, double y, BitSet found) {
        if (isFree(x, y)) {
            found.set(part(x, y));
        }
    }

    /** Adds the parts that a circle goes through. */
    void addParts(double x, double y, double radius, BitSet found) {
        double[] angles = angles(x, y, radius);
        work -= obstacles.size();
        for (int k = 0; k < angles.length && work >= 0; k++) {
            double next = k + 1 < angles.length ? angles[k + 1] : angles[0] + 2 * Math.PI;
            double middle = (angles[k] + next) / 2;
            addPart(x + radius * StrictMath.cos(middle), y + radius * StrictMath.sin(middle), found);
        }
    }

    private boolean isFree(double x, double y) {
        work -= obstacles.size();
        for (Obstacle obstacle : obstacles) {
            if (obstacle.gap().of(x, y, grown) <= 0) {
                return false;
            }
        }
        return true;
    }

    private int part(double x, double y) {
        int part = 0;
        while (part < parts.size() && separation.parts(parts.get(part)[0], parts.get(part)[1], x, y)) {
            work -= separation.size();
            part++;
        }
        if (part == parts.size()) {
            parts.add(new double[] {x, y});
        }
        work -= separation.size();
        return part;
    }

    /** Returns where a circle goes into or out of an obstacle, in order; 0 if nowhere. */
    private double[] angles(double x, double y, double radius) {
        Crossings crossings = new Crossings(x, y, radius);
        for (Bumper bumper : field.bumpers()) {
            crossings.circle(bumper.x(), bumper.y(), bumper.radius() + grown);
        }
        for (Wall wall : field.walls()) {
            if (wall instanceof HalfPlane plane) {
                crossings.line(plane.x() + plane.insideX() * grown, plane.y() + plane.insideY() * grown,
                    plane.insideX(), plane.insideY());
            } else if (wall instanceof Arena arena) {
                crossings.circle(arena.x(), arena.y(), arena.radius() - grown);
            } else if (wall instanceof Segment segment) {
                crossings.circle(segment.ax(), segment.ay(), grown);
                crossings.circle(segment.bx(), segment.by(), grown);
                double acrossX = -(segment.by() - segment.ay()) / segment.length();
                double acrossY = (segment.bx() - segment.ax()) / segment.length();
                crossings.line(segment.ax() + acrossX * grown, segment.ay() + acrossY * grown, acrossX, acrossY);
                crossings.line(segment.ax() - acrossX * grown, segment.ay() - acrossY * grown, acrossX, acrossY);
            }
        }
        return crossings.sorted();
    }

    /** The angles at which one circle crosses lines and other circles. */
    private static final class Crossings {

        private final double x;
        private final double y;
        private final double radius;
        private double[] angles = new double[8];
        private int count;

        Crossings(double x, double y, double radius) {
            this.x = x;
            this.y = y;
            this.radius = radius;
        }

        /** Law of cosines in the triangle of the two centres and a crossing. */
        void circle(double otherX, double otherY, double otherRadius) {
            double dx = otherX - x;
            double dy = otherY - y;
            double square = dx * dx + dy * dy;
            double distance = Math.sqrt(square);
            if (otherRadius > 0 && distance > Math.abs(radius - otherRadius) && distance < radius + otherRadius) {
                add(dx, dy, (square + radius * radius - otherRadius * otherRadius) / (2 * distance * radius));
            }
        }

        /** @param px a place on the line */
        void line(double px, double py, double normalX, double normalY) {
            double distance = (px - x) * normalX + (py - y) * normalY;
            if (Math.abs(distance) < radius) {
                add(normalX, normalY, distance / radius);
            }
        }

        private void add(double dx, double dy, double cosine) {
            double middle = StrictMath.atan2(dy, dx);
            double half = StrictMath.acos(Math.max(-1, Math.min(1, cosine)));
            if (count + 2 > angles.length) {
                angles = Arrays.copyOf(angles, 2 * angles.length);
            }
            angles[count++] = wrapped(middle - half);
            angles[count++] = wrapped(middle + half);
        }

        private static double wrapped(double angle) {
            return angle < 0 ? angle + 2 * Math.PI : angle;
        }

        double[] sorted() {
            double[] all = Arrays.copyOf(angles, Math.max(1, count));
            Arrays.sort(all);
            return all;
        }
    }
}
