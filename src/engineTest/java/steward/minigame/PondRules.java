package steward.minigame;

import steward.game.TurnEvent;
import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/** Effects of a hunter's touch: bursts, splits, eats, or nothing. */
final class PondRules implements Reaction {

    /** A cell below twice this mass is eaten whole. */
    static final double SMALLEST_CELL = 4;
    /** How many times heavier the eater of a hunter must be. */
    static final double HEAVIER = 1.25;
    /** At this speed the halves of a cell part, in u per turn. */
    static final double PARTING = 30;

    private final Pond pond;

    PondRules(Pond pond) {
        this.pond = pond;
    }

    @Override
    public Verdict on(double time, int a, int b, Bodies bodies, TurnSink sink) {
        int hunter = bodies.kind[a] == Pond.HUNTER ? a : b;
        int other = hunter == a ? b : a;
        switch (bodies.kind[other]) {
            case Pond.BUBBLE -> {
                pond.report(TurnEvent.Kind.DEATH, time, other, "burst");
                bodies.remove(other);
                return Verdict.CHANGED;
            }
            case Pond.CELL -> {
                if (bodies.mass[other] >= 2 * SMALLEST_CELL && bodies.size() < bodies.capacity()) {
                    split(time, hunter, other, bodies);
                } else {
                    eat(time, hunter, other, bodies);
                }
                return Verdict.CHANGED;
            }
            case Pond.FOG -> {
                pond.report(TurnEvent.Kind.MARK, time, hunter, "in the fog");
                return Verdict.PASS;
            }
            default -> {
                return meet(time, hunter, other, bodies);
            }
        }
    }

    private Verdict meet(double time, int one, int other, Bodies bodies) {
        int heavy = bodies.mass[one] >= bodies.mass[other] ? one : other;
        int light = heavy == one ? other : one;
        if (bodies.mass[heavy] < HEAVIER * bodies.mass[light]) {
            return Verdict.BOUNCE;
        }
        pond.eaten(pond.ownerOf(bodies.id(light)), "eaten by player " + pond.ownerOf(bodies.id(heavy)));
        eat(time, heavy, light, bodies);
        return Verdict.CHANGED;
    }

    /** Masses and momenta add up. */
    private void eat(double time, int hunter, int prey, Bodies bodies) {
        pond.report(TurnEvent.Kind.DEATH, time, prey, "eaten");
        double mass = bodies.mass[hunter] + bodies.mass[prey];
        double vx = (bodies.mass[hunter] * bodies.vx[hunter] + bodies.mass[prey] * bodies.vx[prey]) / mass;
        double vy = (bodies.mass[hunter] * bodies.vy[hunter] + bodies.mass[prey] * bodies.vy[prey]) / mass;
        bodies.setMass(hunter, mass);
        bodies.setRadius(hunter, Pond.radiusOf(mass));
        bodies.setVelocity(hunter, vx, vy);
        pond.keepInside(hunter);
        bodies.remove(prey);
    }

    /** Two halves side by side across the touch, moving apart. */
    private void split(double time, int hunter, int cell, Bodies bodies) {
        double half = bodies.mass[cell] / 2;
        double dx = bodies.x[cell] - bodies.x[hunter];
        double dy = bodies.y[cell] - bodies.y[hunter];
        double distance = Math.sqrt(dx * dx + dy * dy);
        double acrossX = -dy / distance;
        double acrossY = dx / distance;
        double x = bodies.x[cell];
        double y = bodies.y[cell];
        double vx = bodies.vx[cell];
        double vy = bodies.vy[cell];
        pond.report(TurnEvent.Kind.DEATH, time, cell, "split");
        bodies.remove(cell);
        double apart = 1.01 * Pond.radiusOf(half);
        for (int side = -1; side <= 1; side += 2) {
            int born = pond.add(Pond.CELL, x + side * apart * acrossX, y + side * apart * acrossY, half);
            bodies.setVelocity(born, vx + side * PARTING * acrossX, vy + side * PARTING * acrossY);
            pond.keepInside(born);
            pond.report(TurnEvent.Kind.BIRTH, time, born, "half a cell");
        }
    }
}
