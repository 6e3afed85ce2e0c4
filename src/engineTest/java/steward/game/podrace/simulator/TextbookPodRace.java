package steward.game.podrace.simulator;

import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import steward.numerics.SineCosine;

/**
 * The textbook baseline: the official turn of the pod race as a contestant writes it from the rules: pod objects, the
 * arc tangent of {@link StrictMath}, every pair's quadratic each time. It shares no code with the engine but
 * {@link SineCosine}, the correctly rounded sine and cosine of the game's rules, which has tests of its own; so the
 * engine can be measured and checked against it. The rules are those of the live server, without elimination and
 * without the bound on impacts.
 *
 * <p>Units: u, turns, radians, pod masses.
 */
public final class TextbookPodRace {

    /** Instead of a thrust: the pod gets no command. */
    public static final int NO_COMMAND = -1;
    /** Instead of a thrust: raise the shield. */
    public static final int SHIELD = -2;
    /** Instead of a thrust: boost. */
    public static final int BOOST = -3;

    private static final double MAXIMUM_TURN = Math.PI / 10;
    private static final double TOUCH = 800;
    private static final double CHECKPOINT_RADIUS = 600;
    private static final double WINDOW = 1e-5;
    private static final double MINIMUM_IMPULSE = 120;

    /** A pod and its path in this turn. */
    public static final class Pod {
        public double x;
        public double y;
        public double vx;
        public double vy;
        /** NaN while unset. */
        public double heading = Double.NaN;
        /** 4 on the turn the shield is raised, counting down. */
        public int shieldTimer;
        public boolean boostLeft = true;
        /** Checkpoints passed since the start. */
        public int passed;

        /** 10 from the command of a shield until the next command. */
        public double mass = 1;
        private double[] pathX = new double[16];
        private double[] pathY = new double[16];
        private int path;
        private double cornerTime;

        /** One corner an impact, the place after it; a later one at the same time replaces it. */
        private void corner(double time) {
            path -= cornerTime == time ? 1 : 0;
            cornerTime = time;
            remember();
        }

        private void remember() {
            if (path == pathX.length) {
                pathX = java.util.Arrays.copyOf(pathX, 2 * path);
                pathY = java.util.Arrays.copyOf(pathY, 2 * path);
            }
            pathX[path] = x;
            pathY[path++] = y;
        }
    }

    private record Impact(double time, Pod a, Pod b) { }

    private final double[][] checkpoints;
    private final Pod[] pods;
    private final SineCosine direction = new SineCosine();

    /** @param checkpoints {@code [n][x, y]} */
    public TextbookPodRace(double[][] checkpoints, int pods) {
        this.checkpoints = checkpoints;
        this.pods = new Pod[pods];
        for (int k = 0; k < pods; k++) {
            this.pods[k] = new Pod();
        }
    }

    /** A pod, to read and write between turns. */
    public Pod pod(int k) {
        return pods[k];
    }

    /**
     * Plays one turn with a target and a thrust per pod, {@link #SHIELD}, {@link #BOOST} or {@link #NO_COMMAND}. Where
     * y is NaN, x is not a target but the degrees by which the pod turns; without a heading it then does nothing.
     */
    public void play(double[] targetX, double[] targetY, int[] thrust) {
        for (int k = 0; k < pods.length; k++) {
            pods[k].path = 0;
            pods[k].remember();
            pods[k].cornerTime = Double.NaN;
            command(pods[k], targetX[k], targetY[k], thrust[k]);
        }
        advance();
        for (Pod pod : pods) {
            pod.vx = truncate(pod.vx * (1 - 0.15));
            pod.vy = truncate(pod.vy * (1 - 0.15));
            pod.x = Math.floor(pod.x + 0.5) + 0.0;
            pod.y = Math.floor(pod.y + 0.5) + 0.0;
            pod.remember();
            int most = checkpoints.length;
            while (most-- > 0 && passes(pod, checkpoints[(pod.passed + 1) % checkpoints.length])) {
                pod.passed++;
            }
        }
    }

    private static double truncate(double value) {
        return (value < 0 ? Math.ceil(value) : Math.floor(value)) + 0.0;
    }

    private void command(Pod pod, double targetX, double targetY, int command) {
        boolean shield = command == SHIELD;
        pod.shieldTimer = shield ? 4 : Math.max(0, pod.shieldTimer - 1);
        pod.mass = command == NO_COMMAND ? pod.mass : shield ? 10 : 1;
        int thrust = Math.max(0, command);
        if (command == BOOST) {
            thrust = pod.boostLeft ? 650 : 200;
            pod.boostLeft = false;
        }
        if (command == NO_COMMAND || targetX == pod.x && targetY == pod.y) {
            return;
        }
        if (Double.isNaN(targetY)) {
            if (Double.isNaN(pod.heading)) {
                return;
            }
            double turn = Math.abs(targetX) >= 18 ? MAXIMUM_TURN * Math.signum(targetX) : Math.toRadians(targetX);
            pod.heading = turn == 0 ? pod.heading : pod.heading + turn;
        } else {
            steer(pod, targetX, targetY);
        }
        if (pod.shieldTimer == 0) {
            direction.turn(pod.heading);
            double dx = direction.cos();
            double dy = direction.sin();
            double length = Math.sqrt(dx * dx + dy * dy);
            pod.vx += dx / length * thrust;
            pod.vy += dy / length * thrust;
        }
    }

    private static void steer(Pod pod, double targetX, double targetY) {
        double wanted = StrictMath.atan2(targetY - pod.y, targetX - pod.x);
        double delta = (wanted - pod.heading) % (2 * Math.PI);
        double r = 2 * delta % (2 * Math.PI) - delta;
        if (Math.abs(r) >= MAXIMUM_TURN) {
            pod.heading += MAXIMUM_TURN * Math.signum(r);
        } else {
            pod.heading = wanted;
        }
    }

    private void advance() {
        double now = 0;
        for (;;) {
            List<Impact> impacts = findImpacts(now);
            if (impacts.isEmpty()) {
                move(1 - now);
                return;
            }
            double first = impacts.get(0).time;
            move(first - now);
            now = first;
            for (Impact impact : impacts) {
                if (impact.time - first <= WINDOW) {
                    react(impact.a, impact.b, impact.time);
                }
            }
        }
    }

    private List<Impact> findImpacts(double now) {
        List<Impact> impacts = new ArrayList<>(0);
        for (int i = pods.length - 1; i > 0; i--) {
            for (int j = i - 1; j >= 0; j--) {
                double time = now + timeToImpact(pods[i], pods[j], 1 - now);
                if (time < Double.POSITIVE_INFINITY) {
                    int place = impacts.size();
                    while (place > 0 && impacts.get(place - 1).time > time) {
                        place--;
                    }
                    impacts.add(place, new Impact(time, pods[i], pods[j]));
                }
            }
        }
        return impacts;
    }

    private static double timeToImpact(Pod i, Pod j, double left) {
        double dx = i.x - j.x;
        double dy = i.y - j.y;
        if (Math.sqrt(dx * dx + dy * dy) <= TOUCH) {
            return 0;
        }
        double wx = i.vx - j.vx;
        double wy = i.vy - j.vy;
        double a = wx * wx + wy * wy;
        double b = dx * wx + dy * wy;
        double c = dx * dx + dy * dy - TOUCH * TOUCH;
        double discriminant = b * b - a * c;
        if (!(discriminant > 0) || a == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double root = Math.min((-b + Math.sqrt(discriminant)) / a, (-b - Math.sqrt(discriminant)) / a);
        return root > 0 && root <= left ? root : Double.POSITIVE_INFINITY;
    }

    private void move(double time) {
        for (Pod pod : pods) {
            pod.x += pod.vx * time;
            pod.y += pod.vy * time;
        }
    }

    private static void react(Pod a, Pod b, double time) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double nx = distance == 0 ? 1 : dx / distance;
        double ny = distance == 0 ? 0 : dy / distance;
        double wa = 1 / a.mass;
        double wb = 1 / b.mass;
        double f = (nx * (a.vx - b.vx) + ny * (a.vy - b.vy)) / (wa + wb);
        double impulse = f + Math.max(MINIMUM_IMPULSE, f);
        a.vx -= nx * impulse * wa;
        a.vy -= ny * impulse * wa;
        b.vx += nx * impulse * wb;
        b.vy += ny * impulse * wb;
        if (distance <= TOUCH) {
            double each = (TOUCH - distance) / 2 + WINDOW;
            a.x -= nx * each;
            a.y -= ny * each;
            b.x += nx * each;
            b.y += ny * each;
        }
        a.corner(time);
        b.corner(time);
    }

    private static boolean passes(Pod pod, double[] checkpoint) {
        for (int k = 1; k < pod.path; k++) {
            if (Line2D.ptSegDist(pod.pathX[k - 1], pod.pathY[k - 1], pod.pathX[k], pod.pathY[k], checkpoint[0],
                checkpoint[1]) < CHECKPOINT_RADIUS) {
                return true;
            }
        }
        return Point2D.distance(pod.x, pod.y, checkpoint[0], checkpoint[1]) <= CHECKPOINT_RADIUS;
    }
}
