package steward.physics.event;

import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.TurnSink;

/** The pod race's referee in its own expressions, written from its description: what the common loop is tried on. */
final class PodRaceLoop extends OfficialLoop {

    PodRaceLoop() {
        super(new PhysicsParts(ImpactLaw.OFFICIAL_POD_RACE, Arithmetic.OFFICIAL), true);
    }

    /** Offers are times within the turn. */
    @Override
    protected void look(Bodies bodies, double now) {
        for (int i = bodies.size() - 1; i > 0; i--) {
            for (int j = i - 1; j >= 0; j--) {
                double dx = bodies.x[i] - bodies.x[j];
                double dy = bodies.y[i] - bodies.y[j];
                double touch = bodies.radius[i] + bodies.radius[j];
                if (Math.sqrt(dx * dx + dy * dy) <= touch) {
                    offer(now, 0, bodies.id(i), bodies.id(j));
                    continue;
                }
                double vx = bodies.vx[i] - bodies.vx[j];
                double vy = bodies.vy[i] - bodies.vy[j];
                double a = vx * vx + vy * vy;
                double b = dx * vx + dy * vy;
                double discriminant = b * b - a * (dx * dx + dy * dy - touch * touch);
                if (discriminant <= 0 || a == 0) {
                    continue;
                }
                double root = Math.min((-b + Math.sqrt(discriminant)) / a, (-b - Math.sqrt(discriminant)) / a);
                if (root > 0 && root <= 1 - now) {
                    offer(now + root, 0, bodies.id(i), bodies.id(j));
                }
            }
        }
    }

    @Override
    protected boolean isInTurn(double now, double time) {
        return true;
    }

    @Override
    protected boolean isTogether(double earliest, double time) {
        return time - earliest <= 1e-5;
    }

    @Override
    protected double fly(Bodies bodies, double now, double time) {
        move(bodies, time - now);
        return time;
    }

    @Override
    protected void react(Bodies bodies, double now, double time, int kind, int idA, int idB, TurnSink sink) {
        int a = bodies.indexOf(idA);
        int b = bodies.indexOf(idB);
        double ax = bodies.x[a];
        double ay = bodies.y[a];
        double bx = bodies.x[b];
        double by = bodies.y[b];
        double vax = bodies.vx[a];
        double vay = bodies.vy[a];
        double vbx = bodies.vx[b];
        double vby = bodies.vy[b];
        double distance = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
        double nx = distance == 0 ? 1 : (bx - ax) / distance;      // where the referee computes no numbers
        double ny = distance == 0 ? 0 : (by - ay) / distance;
        double inverse = 1 / bodies.mass[a] + 1 / bodies.mass[b];
        double f = (nx * (vax - vbx) + ny * (vay - vby)) / inverse;
        double back = Math.max(120, f);
        double impulse = f + back;
        bodies.vx[a] += nx * -impulse * (1 / bodies.mass[a]);
        bodies.vy[a] += ny * -impulse * (1 / bodies.mass[a]);
        bodies.vx[b] += nx * impulse * (1 / bodies.mass[b]);
        bodies.vy[b] += ny * impulse * (1 / bodies.mass[b]);
        sink.impact(time, idA, idB, ax, ay, bx, by, nx, ny, impulse, inverse * (back * back - f * f) / 2,
            bodies.mass[a], bodies.mass[b], vax, vay, bodies.vx[a], bodies.vy[a], vbx, vby, bodies.vx[b], bodies.vy[b]);
        double overlap = bodies.radius[a] + bodies.radius[b] - distance;
        if (overlap >= 0) {
            bodies.x[a] += nx * -(overlap / 2 + 1e-5);
            bodies.y[a] += ny * -(overlap / 2 + 1e-5);
            bodies.x[b] += nx * (overlap / 2 + 1e-5);
            bodies.y[b] += ny * (overlap / 2 + 1e-5);
        }
    }
}
