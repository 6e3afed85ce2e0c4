package steward.bots;

/**
 * A fast prediction of turns: the rules of the race as far as a bot can see them. Times of impact are exact, but every
 * body bounces perfectly elastically, because frames do not contain restitutions. Allocates nothing in a turn.
 */
final class Forecast {

    /** A pod turns by at most 18 degrees a turn. */
    static final double TURN_COSINE = 0.9510565162951535;
    static final double TURN_SINE = 0.3090169943749474;
    private static final double SHIELD_MASS_FACTOR = 10;
    private static final int SHIELD_TURNS = 4;
    /** Enough for any real turn; a dense heap of pods need not be simulated further. */
    private static final int MAXIMUM_IMPACTS = 24;

    private final Race race;
    private final double[] mass;
    private final double[] startX;
    private final double[] startY;

    private double impactTime;
    private int first;
    private int second;

    /** @param capacity the most pods that a turn will have */
    Forecast(Race race, int capacity) {
        this.race = race;
        mass = new double[capacity];
        startX = new double[capacity];
        startY = new double[capacity];
    }

    /** Simulates one turn: the pods are changed to their predicted state after it. */
    void turn(Pods pods, Commands commands) {
        for (int pod = 0; pod < pods.size; pod++) {
            startX[pod] = pods.x[pod];
            startY[pod] = pods.y[pod];
            steer(pods, pod, commands);
        }
        advance(pods);
        double keep = 1 - race.drag;
        for (int pod = 0; pod < pods.size; pod++) {
            pods.vx[pod] = (int) (pods.vx[pod] * keep);
            pods.vy[pod] = (int) (pods.vy[pod] * keep);
            pods.x[pod] = Math.floor(pods.x[pod] + 0.5);
            pods.y[pod] = Math.floor(pods.y[pod] + 0.5);
            pass(pods, pod);
        }
    }

    private void steer(Pods pods, int pod, Commands commands) {
        int thrust = commands.thrust[pod];
        mass[pod] = thrust == Commands.SHIELD ? SHIELD_MASS_FACTOR * race.podMass : race.podMass;
        if (thrust == Commands.SHIELD) {
            pods.shieldTimer[pod] = SHIELD_TURNS;
        } else if (pods.shieldTimer[pod] > 0) {
            pods.shieldTimer[pod]--;
        }
        if (thrust == Commands.BOOST) {
            thrust = pods.boostLeft[pod] ? race.boostThrust : race.maximumThrust;
            pods.boostLeft[pod] = false;
        }
        turnTo(pods, pod, commands.targetX[pod] - pods.x[pod], commands.targetY[pod] - pods.y[pod]);
        if (thrust > 0 && pods.shieldTimer[pod] == 0) {
            pods.vx[pod] += thrust * pods.headingX[pod];
            pods.vy[pod] += thrust * pods.headingY[pod];
        }
    }

    private static void turnTo(Pods pods, int pod, double dx, double dy) {
        double hx = pods.headingX[pod];
        double hy = pods.headingY[pod];
        double length = Math.sqrt(dx * dx + dy * dy);
        if (length == 0) {
            return;
        }
        if (hx == 0 && hy == 0 || hx * dx + hy * dy >= TURN_COSINE * length) {
            pods.headingX[pod] = dx / length;
            pods.headingY[pod] = dy / length;
        } else {
            double sine = hx * dy - hy * dx > 0 ? TURN_SINE : -TURN_SINE;
            pods.headingX[pod] = hx * TURN_COSINE - hy * sine;
            pods.headingY[pod] = hx * sine + hy * TURN_COSINE;
        }
    }

    private void advance(Pods pods) {
        double time = 0;
        for (int impacts = 0; impacts < MAXIMUM_IMPACTS; impacts++) {
            findImpact(pods, 1 - time);
            if (impactTime > 1 - time) {
                break;
            }
            move(pods, impactTime);
            time += impactTime;
            if (second < pods.size) {
                bounce(pods);
            } else {
                bounceOff(pods, second - pods.size);
            }
        }
        move(pods, 1 - time);
    }

    private static void move(Pods pods, double time) {
        for (int pod = 0; pod < pods.size; pod++) {
            pods.x[pod] += time * pods.vx[pod];
            pods.y[pod] += time * pods.vy[pod];
        }
    }

    /**
     * Finds the first impact; fixed objects are numbered after the pods: bumpers, then left, right, top, bottom wall.
     */
    private void findImpact(Pods pods, double limit) {
        impactTime = Double.POSITIVE_INFINITY;
        for (int one = 0; one < pods.size; one++) {
            double x = pods.x[one];
            double y = pods.y[one];
            double vx = pods.vx[one];
            double vy = pods.vy[one];
            for (int other = one + 1; other < pods.size; other++) {
                offer(one, other, limit, circles(pods.x[other] - x, pods.y[other] - y, vx - pods.vx[other],
                    vy - pods.vy[other], 2 * race.podRadius, limit));
            }
            int standing = pods.size;
            for (int bumper = 0; bumper < race.bumpers; bumper++) {
                offer(one, standing++, limit, circles(race.bumperX[bumper] - x, race.bumperY[bumper] - y, vx, vy,
                    race.podRadius + race.bumperRadius[bumper], limit));
            }
            if (race.walls) {
                offer(one, standing, limit, wall(x - race.podRadius, -vx));
                offer(one, standing + 1, limit, wall(race.width - race.podRadius - x, vx));
                offer(one, standing + 2, limit, wall(y - race.podRadius, -vy));
                offer(one, standing + 3, limit, wall(race.height - race.podRadius - y, vy));
            }
        }
    }

    private void offer(int one, int other, double limit, double time) {
        if (time <= limit && time < impactTime) {
            impactTime = time;
            first = one;
            second = other;
        }
    }

    /** Returns when two circles at distance (dx, dy) with relative velocity (vx, vy) touch; never unless they approach.
     */
    private static double circles(double dx, double dy, double vx, double vy, double reach, double limit) {
        double approach = dx * vx + dy * vy;
        double gap = dx * dx + dy * dy - reach * reach;
        if (approach <= 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (gap <= 0) {
            return 0;
        }
        double speed = vx * vx + vy * vy;
        // They touch when gap - 2·approach·t + speed·t² = 0, so not before t = gap / (2·approach).
        double root = approach * approach - speed * gap;
        if (gap > 2 * approach * limit || root <= 0) {
            return Double.POSITIVE_INFINITY;
        }
        return gap / (approach + Math.sqrt(root));
    }

    private static double wall(double gap, double speed) {
        return speed > 0 ? Math.max(0, gap / speed) : Double.POSITIVE_INFINITY;
    }

    private void bounce(Pods pods) {
        double dx = pods.x[second] - pods.x[first];
        double dy = pods.y[second] - pods.y[first];
        double distance = Math.max(1, Math.sqrt(dx * dx + dy * dy));
        double nx = dx / distance;
        double ny = dy / distance;
        double stop = (nx * (pods.vx[first] - pods.vx[second]) + ny * (pods.vy[first] - pods.vy[second]))
            / (1 / mass[first] + 1 / mass[second]);
        double impulse = stop + Math.max(race.minimumImpulse, stop);
        pods.vx[first] -= impulse / mass[first] * nx;
        pods.vy[first] -= impulse / mass[first] * ny;
        pods.vx[second] += impulse / mass[second] * nx;
        pods.vy[second] += impulse / mass[second] * ny;
    }

    private void bounceOff(Pods pods, int standing) {
        int pod = first;
        int wall = standing - race.bumpers;
        double nx = wall >= 2 ? 0 : wall == 0 ? -1 : 1;
        double ny = wall < 2 ? 0 : wall == 2 ? -1 : 1;
        if (wall < 0) {
            double dx = race.bumperX[standing] - pods.x[pod];
            double dy = race.bumperY[standing] - pods.y[pod];
            double distance = Math.max(1, Math.sqrt(dx * dx + dy * dy));
            nx = dx / distance;
            ny = dy / distance;
        }
        double speed = nx * pods.vx[pod] + ny * pods.vy[pod];
        double change = speed + Math.max(race.minimumImpulse / mass[pod], speed);
        pods.vx[pod] -= change * nx;
        pods.vy[pod] -= change * ny;
    }

    /** Counts the checkpoint if the straight path of this turn came near enough to it. */
    private void pass(Pods pods, int pod) {
        double ax = startX[pod] - race.checkpointX[pods.next[pod]];
        double ay = startY[pod] - race.checkpointY[pods.next[pod]];
        double dx = pods.x[pod] - startX[pod];
        double dy = pods.y[pod] - startY[pod];
        double square = dx * dx + dy * dy;
        double share = square == 0 ? 0 : Math.max(0, Math.min(1, -(ax * dx + ay * dy) / square));
        double nearX = ax + share * dx;
        double nearY = ay + share * dy;
        if (nearX * nearX + nearY * nearY <= race.checkpointRadius * race.checkpointRadius) {
            pods.passed[pod]++;
            pods.next[pod] = race.after(pods.next[pod]);
        }
    }
}
