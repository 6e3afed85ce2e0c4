package steward.game.pokerchiprace;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.PassingPairs;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;
import steward.physics.event.OfficialLoop;

/**
 * Motion of the published Poker Chip Race referee in its own expressions and their order. Impacts within 1e-5 turns of
 * the earliest react together, on the chips as they then are. A chip that was eaten in a batch may take part in later
 * impacts of the same batch, as a chip of radius -1 and mass pi: it is eaten again, or bounces off another such chip.
 *
 * <p>Chips that overlap meet once: the pair remembers its contact, in {@link Bodies#passing}, until time passes. Every
 * look first moves chips that stand in a wall into the table.
 */
public final class OfficialPokerChipRace extends OfficialLoop {

    private static final int LEFT = 0;
    private static final int TOP = 1;
    private static final int RIGHT = 2;
    private static final int BOTTOM = 3;
    private static final int PAIR = 4;

    private static final double EPSILON = 1e-5;
    private static final double EATEN_RADIUS = -1;

    private int[] ghostIds = new int[8];
    private double[][] ghostNumbers = new double[4][8];
    private int ghosts;

    /** The two chips of an impact: index or -1 for one that was eaten, its place among these; and their numbers. */
    private final int[] index = new int[2];
    private final int[] ghost = new int[2];
    private final double[] x = new double[2];
    private final double[] y = new double[2];
    private final double[] vx = new double[2];
    private final double[] vy = new double[2];
    private final double[] r = new double[2];

    /** @param parts of a scene of this game in the official arithmetic */
    public OfficialPokerChipRace(PhysicsParts parts) {
        super(parts, true);
    }

    @Override
    protected void look(Bodies bodies, double now) {
        ghosts = 0;
        double left = 1 - now;
        int size = bodies.size();
        for (int i = 0; i < size; i++) {
            lookAtWalls(bodies, i, now, left);
        }
        for (int i = size - 1; i >= 0; i--) {
            for (int j = i - 1; j >= 0; j--) {
                lookAtPair(bodies, i, j, now, left);
            }
        }
    }

    private void lookAtWalls(Bodies bodies, int i, double now, double left) {
        double radius = bodies.radius[i];
        double lowX = -ChipTable.HALF_WIDTH + radius + EPSILON;
        double highX = ChipTable.HALF_WIDTH - radius - EPSILON;
        double lowY = -ChipTable.HALF_HEIGHT + radius + EPSILON;
        double highY = ChipTable.HALF_HEIGHT - radius - EPSILON;
        if (bodies.x[i] < lowX || bodies.x[i] > highX || bodies.y[i] < lowY || bodies.y[i] > highY) {
            bodies.x[i] = Math.min(highX, Math.max(lowX, bodies.x[i]));
            bodies.y[i] = Math.min(highY, Math.max(lowY, bodies.y[i]));
        }
        double atX = bodies.x[i];
        double atY = bodies.y[i];
        double speedX = bodies.vx[i];
        double speedY = bodies.vy[i];
        int id = bodies.id(i);
        offerWall((ChipTable.HALF_HEIGHT - radius - atY) / speedY, BOTTOM, id, now, left);
        offerWall((-ChipTable.HALF_HEIGHT + radius - atY) / speedY, TOP, id, now, left);
        offerWall((ChipTable.HALF_WIDTH - radius - atX) / speedX, RIGHT, id, now, left);
        offerWall((-ChipTable.HALF_WIDTH + radius - atX) / speedX, LEFT, id, now, left);
    }

    /** @param until not a number or infinite where the speed is 0 */
    private void offerWall(double until, int wall, int id, double now, double left) {
        if (until <= left && until > 0) {
            offer(now + until, wall, id, ~wall);
        }
    }

    private void lookAtPair(Bodies bodies, int i, int j, double now, double left) {
        double dx = bodies.x[i] - bodies.x[j];
        double dy = bodies.y[i] - bodies.y[j];
        double touch = bodies.radius[i] + bodies.radius[j];
        double squared = dx * dx + dy * dy;
        int a = bodies.id(i);
        int b = bodies.id(j);
        double[] parents = bodies.columns[ChipTable.PARENT];
        boolean family = parents[i] == b || parents[j] == a;
        if (family) {
            return;
        }
        if (Math.sqrt(squared) < touch - EPSILON) {
            if (!bodies.passing().contains(a, b)) {
                offer(now, PAIR, a, b);
                bodies.passing().add(a, b);
            }
            return;
        }
        double dvx = bodies.vx[i] - bodies.vx[j];
        double dvy = bodies.vy[i] - bodies.vy[j];
        double speed = dvx * dvx + dvy * dvy;
        double approach = dx * dvx + dy * dvy;
        double gap = squared - touch * touch;
        double discriminant = approach * approach - speed * gap;
        if (discriminant <= 0 || speed == 0) {
            return;
        }
        double root = Math.sqrt(discriminant);
        double until = Math.min((-approach + root) / speed, (-approach - root) / speed);
        if (until <= left && until > 0) {
            offer(now + until, PAIR, a, b);
        }
    }

    @Override
    protected boolean isInTurn(double now, double time) {
        return true;
    }

    @Override
    protected boolean isTogether(double earliest, double time) {
        return time <= earliest + EPSILON;
    }

    @Override
    protected boolean isOver(double now) {
        return !(now < 1);
    }

    /** Contacts are forgotten as soon as time passes. */
    @Override
    protected double fly(Bodies bodies, double now, double time) {
        double step = time - now;
        if (step > 0) {
            pass(bodies, step);
        }
        return now + step;
    }

    @Override
    protected void flyToEnd(Bodies bodies, double now) {
        pass(bodies, 1 - now);
    }

    private static void pass(Bodies bodies, double time) {
        PassingPairs pairs = bodies.passing();
        while (!pairs.isEmpty()) {
            pairs.remove(pairs.size() - 1);
        }
        move(bodies, time);
    }

    @Override
    protected void react(Bodies bodies, double now, double time, int kind, int a, int b, TurnSink sink) {
        load(bodies, a, 0);
        if (kind != PAIR) {
            reactWall(bodies, time, kind, a, sink);
            return;
        }
        load(bodies, b, 1);
        if (r[0] == r[1]) {
            bounce(bodies, time, a, b, sink);
        } else {
            eat(bodies, time, a, b, r[0] > r[1] ? 0 : 1, sink);
        }
    }

    private void reactWall(Bodies bodies, double time, int wall, int a, TurnSink sink) {
        double beforeX = vx[0];
        double beforeY = vy[0];
        switch (wall) {
            case TOP -> vy[0] = Math.abs(vy[0]);
            case BOTTOM -> vy[0] = -Math.abs(vy[0]);
            case LEFT -> vx[0] = Math.abs(vx[0]);
            default -> vx[0] = -Math.abs(vx[0]);
        }
        if (index[0] < 0) {
            sink.fact(time, ChipEating.WALL_OF_EATEN, a, ~wall, x[0], y[0], 0, 0);
        } else {
            double nx = wall == LEFT ? -1 : wall == RIGHT ? 1 : 0;
            double ny = wall == TOP ? -1 : wall == BOTTOM ? 1 : 0;
            double mass = bodies.mass[index[0]];
            double impulse = mass * ((beforeX - vx[0]) * nx + (beforeY - vy[0]) * ny);
            sink.impact(time, a, ~wall, x[0], y[0], x[0] + nx * r[0], y[0] + ny * r[0], nx, ny, impulse, 0, mass,
                Double.POSITIVE_INFINITY, beforeX, beforeY, vx[0], vy[0], 0, 0, 0, 0);
            sink.knot(a, time, x[0], y[0]);
        }
        store(bodies, 0);
    }

    private void bounce(Bodies bodies, double time, int a, int b, TurnSink sink) {
        double beforeAx = vx[0];
        double beforeAy = vy[0];
        double beforeBx = vx[1];
        double beforeBy = vy[1];
        double nx = x[1] - x[0];
        double ny = y[1] - y[0];
        double length = Math.sqrt(nx * nx + ny * ny);
        nx = length == 0 ? 0 : nx / length;
        ny = length == 0 ? 0 : ny / length;
        double massA = ChipTable.area(r[0]);
        double massB = ChipTable.area(r[1]);
        double inverseA = 1 / massA;
        double inverseB = 1 / massB;
        double impulse = -2 * (nx * (vx[0] - vx[1]) + ny * (vy[0] - vy[1])) / (inverseA + inverseB);
        double jx = nx * impulse;
        double jy = ny * impulse;
        if (nx * jx + ny * jy <= 0) {
            vx[0] += jx * inverseA;
            vy[0] += jy * inverseA;
            vx[1] += jx * -1 * inverseB;
            vy[1] += jy * -1 * inverseB;
        } else {
            impulse = 0;
        }
        if (index[0] < 0 && index[1] < 0) {
            sink.fact(time, ChipEating.BOUNCE_OF_EATEN, a, b, x[0], y[0], 0, 0);
        } else {
            sink.impact(time, a, b, x[0], y[0], x[1], y[1], nx, ny, impulse == 0 ? 0 : -impulse, 0, massA, massB,
                beforeAx, beforeAy, vx[0], vy[0], beforeBx, beforeBy, vx[1], vy[1]);
            sink.knot(a, time, x[0], y[0]);
            sink.knot(b, time, x[1], y[1]);
        }
        store(bodies, 0);
        store(bodies, 1);
    }

    /** @param eater 0 or 1: never a chip that was eaten, which has the least radius of all */
    private void eat(Bodies bodies, double time, int a, int b, int eater, TurnSink sink) {
        int eaten = 1 - eater;
        int id = eater == 0 ? a : b;
        int eatenId = eater == 0 ? b : a;
        double mass = ChipTable.area(r[eater]);
        double other = ChipTable.area(r[eaten]);
        boolean again = index[eaten] < 0;
        sink.knot(id, time, x[eater], y[eater]);
        if (!again) {
            sink.knot(eatenId, time, x[eaten], y[eaten]);
        }
        sink.fact(time, again ? ChipEating.EATEN_AGAIN : ChipEating.EATEN, eatenId, id, x[eaten], y[eaten],
            again ? ChipTable.NEUTRAL : bodies.columns[ChipTable.OWNER][index[eaten]], 0);
        double share = 1 / (other + mass);
        x[eater] = (x[eater] * mass + x[eaten] * other) * share;
        y[eater] = (y[eater] * mass + y[eaten] * other) * share;
        vx[eater] = (vx[eater] * mass + vx[eaten] * other) * share;
        vy[eater] = (vy[eater] * mass + vy[eaten] * other) * share;
        store(bodies, eater);
        ChipTable.setArea(bodies, index[eater], mass + other);
        sink.knot(id, time, x[eater], y[eater]);
        if (!again) {
            addGhost(eatenId, eaten);
            bodies.remove(index[eaten]);
            forget(bodies.passing(), eatenId);
        }
    }

    /** A chip that was eaten is in no pair. */
    private static void forget(PassingPairs pairs, int id) {
        for (int k = pairs.size() - 1; k >= 0; k--) {
            if (pairs.first(k) == id || pairs.second(k) == id) {
                pairs.remove(k);
            }
        }
    }

    private void load(Bodies bodies, int id, int slot) {
        int chip = bodies.indexOf(id);
        index[slot] = chip;
        if (chip >= 0) {
            x[slot] = bodies.x[chip];
            y[slot] = bodies.y[chip];
            vx[slot] = bodies.vx[chip];
            vy[slot] = bodies.vy[chip];
            r[slot] = bodies.radius[chip];
            return;
        }
        int of = 0;
        while (ghostIds[of] != id) {
            of++;
        }
        ghost[slot] = of;
        x[slot] = ghostNumbers[0][of];
        y[slot] = ghostNumbers[1][of];
        vx[slot] = ghostNumbers[2][of];
        vy[slot] = ghostNumbers[3][of];
        r[slot] = EATEN_RADIUS;
    }

    /** Gives a chip the numbers of its impact; in play it forgets what it was ejected from. */
    private void store(Bodies bodies, int slot) {
        int chip = index[slot];
        if (chip < 0) {
            ghostNumbers[2][ghost[slot]] = vx[slot];
            ghostNumbers[3][ghost[slot]] = vy[slot];
            return;
        }
        bodies.x[chip] = x[slot];
        bodies.y[chip] = y[slot];
        bodies.vx[chip] = vx[slot];
        bodies.vy[chip] = vy[slot];
        bodies.columns[ChipTable.PARENT][chip] = -1;
    }

    private void addGhost(int id, int slot) {
        if (ghosts == ghostIds.length) {
            ghostIds = Arrays.copyOf(ghostIds, 2 * ghosts);
            for (int k = 0; k < ghostNumbers.length; k++) {
                ghostNumbers[k] = Arrays.copyOf(ghostNumbers[k], 2 * ghosts);
            }
        }
        ghostIds[ghosts] = id;
        ghostNumbers[0][ghosts] = x[slot];
        ghostNumbers[1][ghosts] = y[slot];
        ghostNumbers[2][ghosts] = vx[slot];
        ghostNumbers[3][ghosts] = vy[slot];
        ghosts++;
    }
}
