package steward.lab.stability.pairs;

import java.util.Locale;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;

/**
 * Stability case of a body that slides along the rim of an arena. After a turn it must have covered its speed over the
 * room for its centre, in radians, at the same distance and with the same speed.
 */
public final class SlidingCase extends StabilityCase {

    private static final long SEED = 17;
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);
    private static final double MOST_ANGLE = 1e-6;
    private static final double MOST_ENERGY = 1e-12;
    private static final int MOST_KNOTS = 256;

    public SlidingCase() {
        super("sliding",
            "along an arena's rim, at random places, with random radii, up to 6 rad a turn, restitution 0..1, "
            + "outward or inward share up to 1e-6. The arc is within 1e-6 rad, the energy within 1e-12, and the "
            + "path has at most 256 corners. On every event rung, one by one and as a crowd");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        SplitMix64 random = new SplitMix64(SEED);
        double angle = 0;
        double energy = 0;
        long most = 0;
        int slides = size.pick(200, 2_000, 100_000);
        for (int n = 0; n < slides; n++) {
            double[] seen = slide(rung, random, n % 2 == 0);
            angle = Math.max(angle, seen[0]);
            energy = Math.max(energy, seen[1]);
            most = Math.max(most, (long) seen[2]);
        }
        boolean met = angle <= MOST_ANGLE && energy <= MOST_ENERGY && most <= MOST_KNOTS;
        return Finding.of(rung.isEvent(), met, String.format(Locale.ROOT,
            "%d slides: at most %.1e rad off, energy off by %.1e, %d corners", slides, angle, energy, most));
    }

    /** @return the error of the angle, that of the energy as a share, the number of corners; infinite if limited */
    private static double[] slide(Rung rung, SplitMix64 random, boolean alone) {
        double radius = StrictMath.pow(10, 4 * random.nextDouble());
        double room = radius * (0.1 + 0.85 * random.nextDouble());
        double restitution = random.nextInt(3) == 0 ? 1 : random.nextInt(2) * random.nextDouble();
        Arena arena = new Arena(1000 * (random.nextDouble() - 0.5), 1000 * (random.nextDouble() - 0.5), radius,
            restitution);
        double from = 2 * Math.PI * random.nextDouble();
        double arc = 6 * StrictMath.pow(10, -3 * random.nextDouble()) * (random.nextInt(2) * 2 - 1);
        double speed = arc * room;
        double share = (random.nextInt(3) - 1) * StrictMath.pow(10, -6 - 8 * random.nextDouble());
        if (restitution == 1) {
            share *= Math.min(1, 100 * Math.abs(arc));         // steeper elastic contacts bounce
        }
        double cos = StrictMath.cos(from);
        double sin = StrictMath.sin(from);
        Bodies bodies = new Bodies(1);
        bodies.add(arena.x() + room * cos, arena.y() + room * sin, radius - room, 1);
        bodies.setVelocity(0, speed * (-sin - share * cos), speed * (cos - share * sin));
        double before = bodies.vx[0] * bodies.vx[0] + bodies.vy[0] * bodies.vy[0];
        TurnLog log = new TurnLog();
        (alone ? rung.advance(SOFT, arena) : rung.crowdAdvance(SOFT, arena)).turn(bodies, log);
        double after = bodies.vx[0] * bodies.vx[0] + bodies.vy[0] * bodies.vy[0];
        double reached = StrictMath.atan2(bodies.y[0] - arena.y(), bodies.x[0] - arena.x());
        double off = StrictMath.IEEEremainder(reached - from - arc, 2 * Math.PI);
        return new double[] {Math.abs(off), Math.abs(after - before) / before,
            log.limited() ? Double.POSITIVE_INFINITY : log.knots()};
    }
}
