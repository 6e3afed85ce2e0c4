package steward.lab.calibration;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.lab.timing.TimedTurns;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.HalfPlane;
import steward.physics.Motion;
import steward.physics.TurnLog;
import steward.physics.Wall;
import steward.scene.Scene;

/*
 * In this order: turns in which nothing is computed, the steps of PartByPartPhysics, the ends of turns alone, the
 * game's own parts without commands and with them. The last two are measured in games whose bodies do not move.
 */

/** The slices of a turn whose differences are the prices of parts. */
final class PartSlices {

    /** Turns of a slice, long enough for the clock. */
    private static final int TURNS = 1024;
    private static final int GAMES = 64;
    private static final long SEED = 1;
    /** Distance of the trial half-planes, as a multiple of the farthest point of any state: tested, but not touched. */
    private static final double FAR = 2;

    private final GameTypes types;
    private final GameSetup setup;
    private final Bodies[] states;
    private final List<PartByPartPhysics.Step> steps;

    PartSlices(Scene scene, GameTypes types, List<Bodies> states) {
        this.types = types;
        this.states = states.toArray(new Bodies[0]);
        setup = types.open(scene);
        steps = PartByPartPhysics.of(setup, box(this.states));
    }

    GameSetup setup() {
        return setup;
    }

    List<PartByPartPhysics.Step> steps() {
        return steps;
    }

    /** The slice of a step of the physics; -1 for that in which nothing is computed. */
    int ofStep(int step) {
        return 1 + step;
    }

    /** The slice of the ends of turns alone. */
    int motion() {
        return 1 + steps.size();
    }

    /** The slice of what the game does after its bodies have flown. */
    int outcome() {
        return motion() + 1;
    }

    /** The slice of what the game does before and after. */
    int commands() {
        return motion() + 2;
    }

    /** Returns the number of slices. */
    int count() {
        return commands() + 1;
    }

    TimedTurns open(int slice) {
        if (slice >= outcome()) {
            GameSetup still = types.open(setup.scene().withObserver((parts, advance) -> (bodies, sink) -> { }));
            return new RulesOnlyTurns(still, slice == outcome() ? null : setup.pilot(Pilot.Aim.WIN), GAMES, SEED);
        }
        if (slice == 0 || slice == motion()) {
            return flights((bodies, sink) -> { }, slice == 0 ? new Motion(false, false, false) : setup.motion());
        }
        PartByPartPhysics.Step step = steps.get(slice - 1);
        return flights(step.advance(), step.motion());
    }

    /** Distant walls on all sides of all states. */
    static List<Wall> box(Bodies[] states) {
        double far = 0;
        for (Bodies bodies : states) {
            for (int k = 0; k < bodies.size(); k++) {
                far = Math.max(far, Math.abs(bodies.x[k]) + Math.abs(bodies.y[k]) + bodies.radius[k]
                    + Math.abs(bodies.vx[k]) + Math.abs(bodies.vy[k]));
            }
        }
        far *= FAR;
        return List.of(new HalfPlane(-far, 0, 1, 0, 1), new HalfPlane(0, -far, 0, 1, 1),
            new HalfPlane(far, 0, -1, 0, 1), new HalfPlane(0, far, 0, -1, 1));
    }

    /** Turns of one set of bodies after the other in the same place, as in a match; each copies its state first. */
    private TimedTurns flights(Advance advance, Motion motion) {
        Bodies[] played = alike();
        TurnLog log = new TurnLog();
        return new TimedTurns() {
            @Override
            public void run() {
                for (int turn = 0; turn < TURNS; turn++) {
                    Bodies bodies = played[turn % states.length];
                    bodies.copyFrom(states[turn % states.length]);
                    log.clear();
                    advance.turn(bodies, log);
                    motion.endTurn(bodies);
                }
            }

            @Override
            public int turns() {
                return TURNS;
            }
        };
    }

    /** For each state the bodies that take copies of it; states of one capacity, as most scenes have, share theirs. */
    private Bodies[] alike() {
        Map<Integer, Bodies> shared = new HashMap<>();
        return Arrays.stream(states).map(state -> shared.computeIfAbsent(state.capacity(), capacity -> state.copy()))
            .toArray(Bodies[]::new);
    }
}
