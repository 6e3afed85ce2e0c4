package steward.bots;

/**
 * The search for one pod's command. A first move is a steering angle and a thrust (or shield, or boost), kept for a few
 * turns; after it the pod drives by rule, as all pods near it are expected to do. The number of pods and of turns
 * simulated is fixed, so that an answer takes the same short time in any race.
 */
final class MoveSearch {

    /** Instead of an angle: as {@link RuleDriver} steers. */
    private static final int BY_RULE = -1;
    /** Instead of an enemy: the pod races. */
    static final int NO_ENEMY = -1;

    /** How many pods are simulated: the pod itself, the enemy it guards and the nearest others. */
    private static final int LOOKED_AT = 6;
    private static final int TURNS = 10;
    /** Weight of a guard's own distance to its station, against the enemy's distance to its checkpoint. */
    private static final double STATION_WORTH = 0.3;
    /** Weight of every turn on the way, against the last: earlier progress counts more, so that nothing is put off. */
    private static final double EARLY_WORTH = 0.05;
    /** Cosines and sines of the angles tried: 18, 9, 0, -9, -18 degrees. */
    private static final double[] COSINES = {Forecast.TURN_COSINE, 0.9876883405951378, 1, 0.9876883405951378,
        Forecast.TURN_COSINE};
    private static final double[] SINES = {Forecast.TURN_SINE, 0.15643446504023087, 0, -0.15643446504023087,
        -Forecast.TURN_SINE};
    private static final int[] THRUST_PERCENTS = {100, 0};
    private static final int[] KEPT_TURNS = {1, 3};

    private final Race race;
    private final Forecast forecast;
    private final Pods start = new Pods();
    private final Pods pods = new Pods();
    private final Commands moves = new Commands();
    private final int[] chosen = new int[LOOKED_AT];

    private int enemy;
    private double stationX;
    private double stationY;
    private double bestWorth;
    private double bestX;
    private double bestY;
    private int bestThrust;

    MoveSearch(Race race) {
        this.race = race;
        forecast = new Forecast(race, LOOKED_AT);
    }

    /**
     * Chooses the command of a pod.
     *
     * @param guarded the enemy that it blocks, or {@link #NO_ENEMY}
     */
    void choose(Pods all, int pod, int guarded, Commands commands) {
        gather(all, pod, guarded);
        if (enemy != NO_ENEMY) {
            placeStation();
        }
        bestWorth = Double.NEGATIVE_INFINITY;
        consider(BY_RULE, 0, 0);
        if (start.headingX[0] != 0 || start.headingY[0] != 0) {
            for (int kept : KEPT_TURNS) {
                for (int angle = 0; angle < COSINES.length; angle++) {
                    for (int percent : THRUST_PERCENTS) {
                        consider(angle, race.maximumThrust * percent / 100, kept);
                    }
                }
            }
        }
        consider(BY_RULE, Commands.SHIELD, 1);
        if (start.boostLeft[0] && start.shieldTimer[0] == 0) {
            consider(BY_RULE, Commands.BOOST, 1);
        }
        commands.set(pod, bestX, bestY, bestThrust);
    }

    /** Fills {@link #start}: the pod is number 0, a guarded enemy number 1. */
    private void gather(Pods all, int pod, int guarded) {
        start.clear();
        chosen[0] = pod;
        start.add(all, pod);
        enemy = NO_ENEMY;
        if (guarded != NO_ENEMY) {
            enemy = start.size;
            chosen[start.size] = guarded;
            start.add(all, guarded);
        }
        while (start.size < Math.min(LOOKED_AT, all.size)) {
            int nearest = -1;
            double least = 0;
            for (int other = 0; other < all.size; other++) {
                double dx = all.x[other] - all.x[pod];
                double dy = all.y[other] - all.y[pod];
                double square = dx * dx + dy * dy;
                if (!isChosen(other) && (nearest < 0 || square < least)) {
                    least = square;
                    nearest = other;
                }
            }
            chosen[start.size] = nearest;
            start.add(all, nearest);
        }
    }

    private boolean isChosen(int pod) {
        for (int k = 0; k < start.size; k++) {
            if (chosen[k] == pod) {
                return true;
            }
        }
        return false;
    }

    /** The checkpoint that the enemy passes next, or the one after it if the enemy reaches that before the guard. */
    private void placeStation() {
        int checkpoint = start.next[enemy];
        double dx = race.checkpointX[checkpoint] - start.x[0];
        double dy = race.checkpointY[checkpoint] - start.y[0];
        if (start.toNext(race, enemy) < Math.sqrt(dx * dx + dy * dy)
            && start.passed[enemy] + 1 < race.toFinish()) {
            checkpoint = race.after(checkpoint);
        }
        stationX = race.checkpointX[checkpoint];
        stationY = race.checkpointY[checkpoint];
    }

    /** Simulates one first move and keeps it if it is the best so far. */
    private void consider(int angle, int thrust, int kept) {
        pods.set(start);
        double x = 0;
        double y = 0;
        int power = 0;
        double worth = 0;
        for (int turn = 0; turn < TURNS; turn++) {
            for (int pod = 1; pod < pods.size; pod++) {
                RuleDriver.race(race, pods, pod, moves);
            }
            if (turn >= kept || angle == BY_RULE) {
                byRule();
            } else {
                moves.turn(pods, 0, COSINES[angle], SINES[angle], 0);
            }
            if (turn < kept) {
                moves.thrust[0] = thrust;
            }
            if (turn == 0) {
                x = moves.targetX[0];
                y = moves.targetY[0];
                power = moves.thrust[0];
            }
            forecast.turn(pods, moves);
            worth += EARLY_WORTH * worth();
        }
        worth += worth();
        if (worth > bestWorth) {
            bestWorth = worth;
            bestX = x;
            bestY = y;
            bestThrust = power;
        }
    }

    private void byRule() {
        if (enemy == NO_ENEMY) {
            RuleDriver.race(race, pods, 0, moves);
        } else {
            RuleDriver.steer(race, pods, 0, stationX, stationY, moves);
        }
    }

    private double worth() {
        if (enemy == NO_ENEMY) {
            return pods.progress(race, 0);
        }
        double dx = stationX - pods.x[0];
        double dy = stationY - pods.y[0];
        return -pods.progress(race, enemy) - STATION_WORTH * Math.sqrt(dx * dx + dy * dy);
    }
}
