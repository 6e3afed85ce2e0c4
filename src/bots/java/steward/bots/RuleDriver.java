package steward.bots;

/**
 * Drives one pod along the course by rule: it aims at the checkpoint less a few turns of its own velocity, so that the
 * drift carries it there, and turns towards the checkpoint after the next as soon as coasting alone will pass the next.
 */
final class RuleDriver {

    /** How many turns of velocity the aim is moved back; 3 lost races to the plain bot, 4 to 6 were about equal. */
    static final double DRIFT_TURNS = 5;
    /** How many turns of coasting are predicted. */
    private static final int COAST_TURNS = 6;
    /** Share of the checkpoint radius within which a predicted pass must lie. */
    private static final double SURE_SHARE = 0.85;
    /** Cosine of the angle to the aim above which the engine runs at full thrust: 75 degrees. */
    private static final double THRUST_COSINE = 0.26;

    private RuleDriver() {
    }

    /** Gives a pod its command. */
    static void race(Race race, Pods pods, int pod, Commands commands) {
        int next = pods.next[pod];
        if (pods.passed[pod] + 1 < race.toFinish() && coastsThrough(race, pods, pod, next)) {
            next = race.after(next);
        }
        steer(race, pods, pod, race.checkpointX[next], race.checkpointY[next], commands);
    }

    /** Steers a pod towards a place, its drift taken into account. */
    static void steer(Race race, Pods pods, int pod, double x, double y, Commands commands) {
        double aimX = x - DRIFT_TURNS * pods.vx[pod];
        double aimY = y - DRIFT_TURNS * pods.vy[pod];
        double dx = aimX - pods.x[pod];
        double dy = aimY - pods.y[pod];
        double along = pods.headingX[pod] * dx + pods.headingY[pod] * dy;
        boolean unset = pods.headingX[pod] == 0 && pods.headingY[pod] == 0;
        boolean facing = unset || along > 0 && along * along >= THRUST_COSINE * THRUST_COSINE * (dx * dx + dy * dy);
        commands.set(pod, aimX, aimY, facing ? race.maximumThrust : 0);
    }

    private static boolean coastsThrough(Race race, Pods pods, int pod, int checkpoint) {
        double reach = SURE_SHARE * race.checkpointRadius;
        double x = pods.x[pod] - race.checkpointX[checkpoint];
        double y = pods.y[pod] - race.checkpointY[checkpoint];
        double vx = pods.vx[pod];
        double vy = pods.vy[pod];
        double keep = 1 - race.drag;
        for (int turn = 0; turn < COAST_TURNS; turn++) {
            x += vx;
            y += vy;
            if (x * x + y * y < reach * reach) {
                return true;
            }
            vx *= keep;
            vy *= keep;
        }
        return false;
    }
}
