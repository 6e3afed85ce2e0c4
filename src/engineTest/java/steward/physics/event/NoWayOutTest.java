package steward.physics.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Arithmetic;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;

/** Walls that leave a body no room: nothing can be right there, but nothing may become infinite either. */
class NoWayOutTest {

    /**
     * An arena just as large as the body: whatever its velocity, it leads out at once. The impulse used to be doubled
     * until the speed was infinite and the place not a number.
     */
    @Test
    void anArenaWithoutRoomEndsInRest() {
        for (double radius : new double[] {400, 399, 1}) {
            for (Arithmetic arithmetic : Arithmetic.values()) {
                Bodies bodies = new Bodies(1);
                int body = bodies.add(-100, 0, 400, 1);
                bodies.setVelocity(body, 200, 0);
                Advance advance = new EventAdvance(new PhysicsParts(ImpactLaw.PHYSICS, arithmetic, new Contacts(1),
                    List.of(new Arena(0, 0, radius, 1)), null, false));
                for (int turn = 0; turn < 20; turn++) {
                    advance.turn(bodies, TurnSink.NONE);
                    assertTrue(Double.isFinite(bodies.x[body]) && Double.isFinite(bodies.y[body]), arithmetic.name());
                    assertTrue(Math.abs(bodies.vx[body]) <= 200 && Math.abs(bodies.vy[body]) <= 200,
                        arithmetic + ": " + bodies.vx[body] + " " + bodies.vy[body]);
                }
            }
        }
    }

    /** A moving body of infinite mass that a wall asks about: the question comes, an impulse cannot. */
    @Test
    void anInfiniteMassIsAskedAboutWallsButNeverBounces() {
        int[] asked = new int[1];
        Bodies bodies = new Bodies(1);
        int body = bodies.add(5, 50, 1, Double.POSITIVE_INFINITY);
        bodies.setVelocity(body, -10, 0);
        Advance advance = new EventAdvance(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE,
            new Contacts(1).setWall(0, Contacts.Meaning.ASK), List.of(Wall.box(100, 100, 1)),
            (time, a, b, all, sink) -> {
                asked[0]++;
                return Reaction.Verdict.BOUNCE;
            }, true));
        advance.turn(bodies, TurnSink.NONE);

        assertEquals(1, asked[0]);
        assertEquals(-5, bodies.x[body]);
        assertEquals(-10, bodies.vx[body]);
    }
}
