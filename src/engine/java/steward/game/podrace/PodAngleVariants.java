package steward.game.podrace;

import java.util.function.Consumer;
import steward.game.AngleVariants;
import steward.numerics.SineCosine;
import steward.physics.Bodies;
import steward.physics.TurnLog;

/**
 * A turn of the pod race with the sine and cosine of every pod that has thrust a unit in the last place lower, as they
 * are, and higher: 9 directions a pod, every combination, 6,561 turns for four pods.
 */
final class PodAngleVariants implements AngleVariants {

    private static final int DIRECTIONS = 9;

    private final PodRace race;
    private final int[] power;
    private final Bodies start;
    private final Bodies bodies;
    private final double[] vx;
    private final double[] vy;
    private final TurnLog log = new TurnLog(TurnLog.RECORDED);

    /** @param race a copy between two turns with its commands, which is used up */
    PodAngleVariants(PodRace race) {
        this.race = race;
        int pods = race.settings().pods();
        power = new int[pods];
        vx = new double[pods];
        vy = new double[pods];
        for (int pod = 0; pod < pods; pod++) {
            vx[pod] = race.bodies().vx[pod];
            vy[pod] = race.bodies().vy[pod];
            power[pod] = race.steer(pod, race.thrust(pod));
        }
        start = race.bodies();
        bodies = new Bodies(start.capacity());
    }

    @Override
    public void play(Consumer<TurnLog> each) {
        play(0, each);
    }

    private void play(int pod, Consumer<TurnLog> each) {
        if (pod == power.length) {
            bodies.copyFrom(start);
            log.clear();
            race.advance().turn(bodies, log);
            each.accept(log);
            return;
        }
        double steeredX = start.vx[pod];
        double steeredY = start.vy[pod];
        SineCosine direction = new SineCosine();
        direction.turn(race.heading(pod));
        for (int k = 0; k < (power[pod] == 0 ? 1 : DIRECTIONS); k++) {
            if (power[pod] != 0) {
                double cos = moved(direction.cos(), k % 3 - 1);
                double sin = moved(direction.sin(), k / 3 - 1);
                double length = Math.sqrt(cos * cos + sin * sin);
                start.vx[pod] = vx[pod] + cos / length * power[pod];
                start.vy[pod] = vy[pod] + sin / length * power[pod];
            }
            play(pod + 1, each);
        }
        start.vx[pod] = steeredX;
        start.vy[pod] = steeredY;
    }

    private static double moved(double value, int units) {
        return units < 0 ? Math.nextDown(value) : units > 0 ? Math.nextUp(value) : value;
    }
}
