package steward.bots;

/** Setup frame of a race: the facts fixed for the match. Lengths in u, masses in pod masses. */
final class Race {

    int player;
    int laps = 1;
    int checkpoints;
    /** Of every checkpoint, by number. */
    double[] checkpointX = new double[8];
    double[] checkpointY = new double[8];
    double checkpointRadius = 600;
    double podRadius = 400;
    double podMass = 1;
    double minimumImpulse;
    double drag;
    int maximumThrust = 200;
    int boostThrust = 650;

    /** True if the box from (0, 0) to (width, height) has walls. */
    boolean walls;
    double width;
    double height;
    int bumpers;
    double[] bumperX = new double[4];
    double[] bumperY = new double[4];
    double[] bumperRadius = new double[4];

    /** Returns how many checkpoints a pod must pass to finish. */
    int toFinish() {
        return laps * checkpoints;
    }

    /** The number of the checkpoint after another. */
    int after(int checkpoint) {
        return checkpoint + 1 < checkpoints ? checkpoint + 1 : 0;
    }
}
