package steward.game.podrace;

import steward.game.podrace.protocol.PodRaceType;
import steward.game.podrace.simulator.PodCommands;
import steward.game.podrace.simulator.PodRaceSimulator;
import steward.game.podrace.simulator.TextbookPodRace;
import steward.match.TestScenes;
import steward.physics.event.EventAdvance;

/** Races on maps made for one question, and pods in states made for it. */
public final class Races {

    /** Far from everything, so that nobody passes one by accident. */
    public static final double[][] FAR = {{-1e6, -1e6}, {1e6, 1e6}};

    private Races() {
    }

    /** The rules of the live server on a given map; pods are far apart and at rest, headings unset. */
    public static PodRace official(double[][] checkpoints) {
        return apart(Recordings.official().create(checkpoints));
    }

    /** Returns a race on a given map by the rules of the contest. */
    static PodRace contest(double[][] checkpoints) {
        return apart(Recordings.contest().create(checkpoints));
    }

    private static PodRace apart(PodRace race) {
        for (int pod = 0; pod < 4; pod++) {
            put(race, pod, 100_000 * (pod + 1), 50_000, 0, 0);
        }
        return race;
    }

    public static PodRaceType.PodRaceSetup setup(String scene) {
        return (PodRaceType.PodRaceSetup) TestScenes.open(scene);
    }

    /** The duel of one pod each for another number of players, on a given map. */
    static PodRace duel(int players, double[][] checkpoints) {
        return ((PodRaceType.PodRaceSetup) TestScenes.duel(players)).create(checkpoints);
    }

    /** A fresh pod at a place, heading unset, nothing passed. */
    static void put(PodRace race, int pod, double x, double y, double vx, double vy) {
        race.setPod(pod, new PodState(x, y, vx, vy, Double.NaN, 0, true, 0));
    }

    static void put(PodRace race, int pod, double x, double y, int passed) {
        race.setPod(pod, new PodState(x, y, 0, 0, Double.NaN, 0, true, passed));
    }

    /** Fresh pods at rest from pod 0 on. @param rows x, y and the checkpoints passed */
    static void put(PodRace race, double[][] rows) {
        for (int pod = 0; pod < rows.length; pod++) {
            put(race, pod, rows[pod][0], rows[pod][1], (int) rows[pod][2]);
        }
    }

    /** Gives all pods of a race the commands of a simulator. */
    public static void give(PodRace race, PodCommands commands) {
        for (int pod = 0; pod < commands.pods(); pod++) {
            race.command(pod, commands.targetX(pod), commands.targetY(pod), commands.thrust(pod));
        }
    }

    /** Puts a pod into a simulator. */
    public static void put(PodRaceSimulator race, int pod, PodState state) {
        race.setPod(pod, state.x(), state.y(), state.vx(), state.vy(), state.heading(), state.shieldTimer(),
            state.boostLeft(), state.passed());
    }

    /** The state of a simulator's pod. */
    public static PodState state(PodRaceSimulator race, int pod) {
        return state(race, pod, race.heading(pod));
    }

    /** The state of a simulator's pod, whose heading is not asked for. */
    public static PodState state(PodRaceSimulator race, int pod, double heading) {
        return new PodState(race.x(pod), race.y(pod), race.vx(pod), race.vy(pod), heading, race.shieldTimer(pod),
            race.boostLeft(pod), race.passed(pod));
    }

    /** Puts a textbook's pod into a state. */
    public static void put(TextbookPodRace race, int k, PodState state) {
        TextbookPodRace.Pod pod = race.pod(k);
        pod.x = state.x();
        pod.y = state.y();
        pod.vx = state.vx();
        pod.vy = state.vy();
        pod.heading = state.heading();
        pod.shieldTimer = state.shieldTimer();
        pod.boostLeft = state.boostLeft();
        pod.passed = state.passed();
    }

    /** The state of a textbook's pod. */
    public static PodState state(TextbookPodRace race, int k) {
        TextbookPodRace.Pod pod = race.pod(k);
        return new PodState(pod.x, pod.y, pod.vx, pod.vy, pod.heading, pod.shieldTimer, pod.boostLeft, pod.passed);
    }

    /** A race by the event loop of every scene. */
    public static PodRace plain(PodRaceType.PodRaceSetup setup, double[][] map) {
        return new PodRace(setup.settings(), setup.scene(), setup.plan(), map,
            new EventAdvance(setup.plan().physics(null)));
    }

    /** Plays turns without any command. */
    static void coast(PodRace race, int turns) {
        for (int k = 0; k < turns; k++) {
            race.play();
        }
    }
}
