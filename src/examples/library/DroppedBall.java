import java.util.List;
import steward.physics.*;
import steward.scene.Accuracy;

public class DroppedBall {
    public static void main(String[] arguments) {
        Forces gravity = new Forces(0, 0, 0, 2);                              // 2 u per turn^2; y grows downwards
        Wall floor = new HalfPlane(0, 0, 0, -1, 0.8);                         // through (0, 0), inside above, e = 0.8
        ImpactLaw law = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);
        Bodies bodies = new Bodies(1);
        int ball = bodies.add(0, -110, 10, 1);                                // 100 u above the floor: radius 10, mass 1
        bodies.vy[ball] = -1;                                                 // at rest: half of a turn's gravity less
        Advance advance = Accuracy.event(Arithmetic.EXACT).advance(new PhysicsParts(law, Arithmetic.EXACT,
            new Contacts(1), List.of(floor), null, false).withForces(gravity), 1);
        for (int turn = 1; turn <= 100; turn++) {
            gravity.accelerate(bodies, ball, 0, 0);
            advance.turn(bodies, new TurnSink() { });
            System.out.println(turn + " " + floor.gap(bodies.x[ball], bodies.y[ball], 10));
        }
    }
}
