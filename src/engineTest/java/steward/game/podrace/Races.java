package steward.game.podrace;

import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;

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

    /** Plays turns without any command. */
    static void coast(PodRace race, int turns) {
        for (int k = 0; k < turns; k++) {
            race.play();
        }
    }
}
