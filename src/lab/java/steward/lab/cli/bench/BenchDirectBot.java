package steward.lab.cli.bench;

import steward.game.Game;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.match.DirectBot;

/**
 * Pod-race bot for measurements that reads the race directly. Every pod steers at its next checkpoint less one turn of
 * its own speed, slowly, so that a match takes about as many turns as official ones.
 */
public final class BenchDirectBot implements DirectBot {

    static final int THRUST = 60;

    private PodRace race;
    private PodSeat seat;
    private double[][] checkpoints;

    @Override
    public void start(Game game, int player) {
        race = (PodRace) game;
        seat = new PodSeat(race, player);
        checkpoints = race.checkpoints();
    }

    @Override
    public void turn() {
        for (int pod = seat.first(); pod < seat.end(); pod++) {
            double[] next = checkpoints[seat.nextCheckpoint(pod)];
            seat.thrust(pod, next[0] - race.bodies().vx[pod], next[1] - race.bodies().vy[pod], THRUST);
        }
    }
}
