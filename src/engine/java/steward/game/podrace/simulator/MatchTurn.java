package steward.game.podrace.simulator;

import java.util.List;
import steward.game.podrace.Headings;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.TurnKernel;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.physics.event.OfficialAdvance;
import steward.scene.Plan;
import steward.scene.Scene;

/** Official turn of a match, played with the kernel of {@link PodRaceSimulator}; impacts are recorded if asked for. */
public final class MatchTurn implements TurnKernel {

    private static final List<Motion.Step> MOTION =
        List.of(Motion.Step.DRAG, Motion.Step.TRUNCATE_VELOCITY, Motion.Step.ROUND_POSITION);

    private final PodRaceSettings settings;
    private final double[][] checkpoints;
    private final int pods;
    private final PodTurn turn;
    private final double[] state;
    private final int[] counts;
    /** Velocities before the turn, vx and vy by pod. */
    private final double[] before;

    private MatchTurn(PodRaceSettings settings, double[][] checkpoints, OfficialAdvance advance, TurnLog log) {
        this.settings = settings;
        this.checkpoints = checkpoints;
        pods = settings.pods();
        turn = new PodTurn(checkpoints, pods, settings.podsPerPlayer(), settings.laps(), settings.rules(), advance,
            log);
        state = new double[PodTurn.NUMBERS * pods];
        counts = new int[PodTurn.COUNTS * pods];
        before = new double[2 * pods];
        for (int pod = 0; pod < pods; pod++) {
            setHeading(pod, Double.NaN);
            counts[PodTurn.COUNTS * pod + PodTurn.PASSED] = -1;
        }
    }

    /** Chooses the kernel for every scene with the official pods, motion, law and arithmetic, and without walls. */
    public static TurnKernel of(PodRaceSettings settings, Scene scene, Plan plan, double[][] checkpoints,
                                Advance advance, TurnLog log) {
        return advance instanceof OfficialAdvance official && plan.motion().steps().equals(MOTION)
            && plan.motion().getClass() == Motion.class && scene.drag() == PodTurn.DRAG
            && settings.radius() == PodTurn.RADIUS && settings.mass() == 1 && settings.restitution() == 1
            && settings.maximumThrust() == PodTurn.MAXIMUM_THRUST
            && settings.checkpointRadius() == PodTurn.CHECKPOINT_RADIUS
            ? new MatchTurn(settings, checkpoints, official, log) : null;
    }

    @Override
    public double heading(int pod) {
        return Headings.angle(state, PodTurn.NUMBERS * pod + PodTurn.HEADING);
    }

    @Override
    public void setHeading(int pod, double angle) {
        turn.setHeading(state, pod, angle);
    }

    @Override
    public MatchTurn copy(Advance advance, TurnLog log) {
        MatchTurn copy = new MatchTurn(settings, checkpoints, (OfficialAdvance) advance, log);
        System.arraycopy(state, 0, copy.state, 0, state.length);      // the rest of a turn's state is set in each turn
        return copy;
    }

    @Override
    public int play(Bodies bodies, double[] targetX, double[] targetY, int[] thrust, int[] shieldTimer,
                    boolean[] boostLeft, int[] passed) {
        load(bodies, shieldTimer, boostLeft, passed);
        int mayPass = turn.move(state, counts, targetX, targetY, thrust);
        store(bodies, shieldTimer, boostLeft);
        return mayPass;
    }

    private void load(Bodies bodies, int[] shieldTimer, boolean[] boostLeft, int[] passed) {
        double[] to = state;
        double[] velocities = before;
        int[] count = counts;
        for (int pod = 0; pod < shieldTimer.length; pod++) {
            int at = PodTurn.NUMBERS * pod;
            to[at + PodTurn.X] = bodies.x[pod];
            to[at + PodTurn.Y] = bodies.y[pod];
            to[at + PodTurn.VX] = bodies.vx[pod];
            to[at + PodTurn.VY] = bodies.vy[pod];
            velocities[2 * pod] = bodies.vx[pod];
            velocities[2 * pod + 1] = bodies.vy[pod];
            at = PodTurn.COUNTS * pod;
            count[at + PodTurn.TIMER] = bodies.mass[pod] == 1 ? shieldTimer[pod] : shieldTimer[pod] + PodTurn.HEAVY;
            count[at + PodTurn.BOOST] = boostLeft[pod] ? 1 : 0;
            if (count[at + PodTurn.PASSED] != passed[pod]) {
                count[at + PodTurn.PASSED] = passed[pod];
                count[at + PodTurn.NEXT] = (passed[pod] + 1) % checkpoints.length;
            }
        }
    }

    private void store(Bodies bodies, int[] shieldTimer, boolean[] boostLeft) {
        double[] from = state;
        int[] count = counts;
        for (int pod = 0; pod < shieldTimer.length; pod++) {
            int at = PodTurn.NUMBERS * pod;
            bodies.x[pod] = from[at + PodTurn.X];
            bodies.y[pod] = from[at + PodTurn.Y];
            bodies.vx[pod] = from[at + PodTurn.VX];
            bodies.vy[pod] = from[at + PodTurn.VY];
            at = PodTurn.COUNTS * pod;
            int timer = count[at + PodTurn.TIMER];
            boolean heavy = timer > PodTurn.TIMER_BITS;
            shieldTimer[pod] = timer & PodTurn.TIMER_BITS;
            bodies.mass[pod] = heavy ? PodTurn.SHIELD_MASS : 1;
            bodies.inverseMass[pod] = heavy ? 1 / PodTurn.SHIELD_MASS : 1;
            boostLeft[pod] = count[at + PodTurn.BOOST] != 0;
        }
    }

    @Override
    public boolean passes(int pod, double x, double y) {
        return turn.passes(pod, x, y);
    }

    @Override
    public void log() {
        for (int pod = 0; pod < pods; pod++) {
            state[PodTurn.NUMBERS * pod + PodTurn.VX] = before[2 * pod];
            state[PodTurn.NUMBERS * pod + PodTurn.VY] = before[2 * pod + 1];
        }
        turn.recordLast();
    }
}
