package steward.game.podrace.protocol;

import java.util.Arrays;
import steward.game.podrace.PodRace;
import steward.json.RawJson;
import steward.physics.Bodies;

/**
 * Cache of the JSON of pods and commands in a turn. It has pods as players see them (the owner also sees the shield and
 * the boost), pods in replays, and commands. Most of a pod's text is the same for all players and the replay, so its
 * motion and its views are written once and reused until they change.
 */
final class PodJsonCache {

    private static final double HALF_TURN_DEGREES = 180;
    private static final double FULL_TURN_DEGREES = 360;

    private static final byte[] Y = RawJson.text(",\"y\":");
    private static final byte[] VX = RawJson.text(",\"vx\":");
    private static final byte[] VY = RawJson.text(",\"vy\":");
    private static final byte[] HEADING = RawJson.text(",\"heading\":");
    private static final byte[] NEXT_CHECKPOINT = RawJson.text(",\"nextCheckpoint\":");
    private static final byte[] LAP = RawJson.text(",\"lap\":");
    private static final byte[] SHIELD_TIMER = RawJson.text(",\"shieldTimer\":");
    private static final byte[] BOOST_LEFT = RawJson.text(",\"boostLeft\":");
    private static final byte[] PASSED = RawJson.text(",\"passed\":");
    private static final byte[] OPENING = RawJson.text("[");
    private static final byte[] NO_COMMAND = RawJson.text("null");
    private static final byte[] NEXT_NO_COMMAND = RawJson.text(",null");
    private static final byte[] COMMAND = RawJson.text("{\"x\":");
    private static final byte[] NEXT_COMMAND = RawJson.text(",{\"x\":");
    private static final byte[] SHIELD = RawJson.text(",\"shield\":true}");
    private static final byte[] BOOST = RawJson.text(",\"boost\":true}");
    private static final byte[] THRUST = RawJson.text(",\"thrust\":");

    /** The cached texts of one pod, and the state from which they were written. */
    private static final class CachedPod {
        private final byte[] opening;
        private final RawJson motion = new RawJson();
        private final RawJson own = new RawJson();
        private final RawJson foreign = new RawJson();
        /** Bits of x, y, vx, vy; and of the heading. */
        private final long[] moved = new long[4];
        private long heading;
        private int passed;
        private int shieldTimer;
        private boolean boostLeft;
        private boolean anyMotion;
        private boolean anyView;

        CachedPod(int id, int player) {
            opening = RawJson.text("{\"id\":" + id + ",\"player\":" + player + ",\"x\":");
        }
    }

    private final PodRace race;
    private final CachedPod[] pods;
    private final RawJson text = new RawJson();

    PodJsonCache(PodRace race) {
        this.race = race;
        pods = new CachedPod[race.settings().pods()];
        Arrays.setAll(pods, pod -> new CachedPod(race.bodies().id(pod), race.playerOf(pod)));
    }

    /**
     * A pod as a player sees it now; valid until the next call for the same pod.
     *
     * @param own whether the view is for its owner
     */
    RawJson view(int pod, boolean own) {
        CachedPod cached = pods[pod];
        if (updateMotion(cached, pod) || !cached.anyView || isViewStale(cached, pod)) {
            writeViews(cached, pod);
        }
        return own ? cached.own : cached.foreign;
    }

    /** A pod in a replay; valid until the next call of any method. */
    RawJson state(int pod) {
        CachedPod cached = pods[pod];
        updateMotion(cached, pod);
        return text.begin(cached.motion)
            .add(HEADING).addOrNull(race.heading(pod))
            .add(SHIELD_TIMER).add(race.shieldTimer(pod))
            .add(BOOST_LEFT).add(race.boostLeft(pod))
            .add(PASSED).add(race.passed(pod)).add('}');
    }

    /** A player's command, an array; valid until the next call of any method. */
    RawJson command(int player) {
        int first = player * race.settings().podsPerPlayer();
        text.begin(OPENING);
        for (int pod = first; pod < first + race.settings().podsPerPlayer(); pod++) {
            if (race.thrust(pod) == PodRace.NO_COMMAND) {
                text.add(pod == first ? NO_COMMAND : NEXT_NO_COMMAND);
                continue;
            }
            text.add(pod == first ? COMMAND : NEXT_COMMAND).add(race.targetX(pod)).add(Y).add(race.targetY(pod));
            switch (race.thrust(pod)) {
                case PodRace.SHIELD -> text.add(SHIELD);
                case PodRace.BOOST -> text.add(BOOST);
                default -> text.add(THRUST).add(race.thrust(pod)).add('}');
            }
        }
        return text.add(']');
    }

    /**
     * Writes the motion anew if it has changed; compares bits, because -0.0 has its own text.
     *
     * @return whether it has changed
     */
    private boolean updateMotion(CachedPod cached, int pod) {
        Bodies bodies = race.bodies();
        long[] moved = cached.moved;
        long x = Double.doubleToRawLongBits(bodies.x[pod]);
        long y = Double.doubleToRawLongBits(bodies.y[pod]);
        long vx = Double.doubleToRawLongBits(bodies.vx[pod]);
        long vy = Double.doubleToRawLongBits(bodies.vy[pod]);
        if (cached.anyMotion && moved[0] == x && moved[1] == y && moved[2] == vx && moved[3] == vy) {
            return false;
        }
        cached.anyMotion = false;                     // in case a number cannot be written
        cached.anyView = false;
        cached.motion.begin(cached.opening).add(bodies.x[pod]).add(Y).add(bodies.y[pod])
            .add(VX).add(bodies.vx[pod]).add(VY).add(bodies.vy[pod]);
        moved[0] = x;
        moved[1] = y;
        moved[2] = vx;
        moved[3] = vy;
        cached.anyMotion = true;
        return true;
    }

    private boolean isViewStale(CachedPod cached, int pod) {
        return cached.heading != Double.doubleToRawLongBits(race.heading(pod)) || cached.passed != race.passed(pod)
            || cached.shieldTimer != race.shieldTimer(pod) || cached.boostLeft != race.boostLeft(pod);
    }

    private void writeViews(CachedPod cached, int pod) {
        cached.anyView = false;
        cached.own.begin(cached.motion).add(HEADING).addOrNull(degrees(race.heading(pod)))
            .add(NEXT_CHECKPOINT).add(race.nextCheckpoint(pod)).add(LAP).add(race.lap(pod));
        cached.foreign.begin(cached.own).add('}');
        cached.own.add(SHIELD_TIMER).add(race.shieldTimer(pod)).add(BOOST_LEFT).add(race.boostLeft(pod)).add('}');
        cached.heading = Double.doubleToRawLongBits(race.heading(pod));
        cached.passed = race.passed(pod);
        cached.shieldTimer = race.shieldTimer(pod);
        cached.boostLeft = race.boostLeft(pod);
        cached.anyView = true;
    }

    /** A heading as bots see it: degrees in [0, 360), NaN while unset. */
    static double degrees(double radians) {
        double degrees = radians * HALF_TURN_DEGREES / Math.PI % FULL_TURN_DEGREES;
        double wrapped = degrees < 0 ? degrees + FULL_TURN_DEGREES : degrees;
        return wrapped >= FULL_TURN_DEGREES ? 0 : wrapped + 0.0;
    }
}
