package steward.bots.searchrace;

import java.util.Arrays;

/** Setup frame of a race: the facts fixed for the match. */
final class Course {

    int checkpoints;
    double[] x = new double[16];
    double[] y = new double[16];
    int laps = 3;
    double radius = 600;
    double drag = 0.15;

    void clear() {
        checkpoints = 0;
    }

    void add(double checkpointX, double checkpointY) {
        if (checkpoints == x.length) {
            x = Arrays.copyOf(x, 2 * checkpoints);
            y = Arrays.copyOf(y, 2 * checkpoints);
        }
        x[checkpoints] = checkpointX;
        y[checkpoints++] = checkpointY;
    }

    int toFinish() {
        return laps * checkpoints;
    }

    /** Index of the checkpoint that comes next when so many have been passed. */
    int next(int passed) {
        return (passed + 1) % checkpoints;
    }
}
