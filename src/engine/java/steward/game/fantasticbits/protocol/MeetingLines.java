package steward.game.fantasticbits.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import steward.game.ViewWriter;
import steward.game.fantasticbits.Captures;
import steward.game.fantasticbits.EntityKind;
import steward.physics.Bodies;
import steward.physics.TurnSink;

/** Lines of a view about meetings of two bodies, or of a body and a wall, collected while a turn is played. */
final class MeetingLines implements TurnSink {

    private final Bodies bodies;
    private final List<String> lines = new ArrayList<>();
    private final Set<Integer> holders = new TreeSet<>();
    /** Places of the last two knots: those of a capture are its snaffle's, before and after. */
    private String lastKnot = "";
    private String knotBefore = "";

    MeetingLines(Bodies bodies) {
        this.bodies = bodies;
    }

    /** In their order; a goal tells where its snaffle is after the turn. */
    List<String> lines() {
        return lines.stream().map(line -> line.startsWith("SNAFFLESCORE") ? line + place(Integer.parseInt(
            line.split(" ")[3])) : line).toList();
    }

    private String place(int id) {
        int index = bodies.indexOf(id);
        return " " + Math.round(bodies.x[index]) + " " + Math.round(bodies.y[index]);
    }

    /**
     * Against a wall or post the server shows the speed before; where a wizard has taken a snaffle in this turn and met
     * nothing since, the speed after: the two share theirs there until then.
     */
    @Override
    public void impact(double time, int a, int b, double ax, double ay, double bx, double by, double nx, double ny,
                       double impulse, double energy, double massA, double massB, double vaxBefore, double vayBefore,
                       double vaxAfter, double vayAfter, double vbxBefore, double vbyBefore, double vbxAfter,
                       double vbyAfter) {
        String first = " " + ViewWriter.ANY + " " + time + " " + a + " " + Math.round(ax) + " " + Math.round(ay) + " ";
        boolean shares = holders.remove(a);
        holders.remove(b);
        double vx = shares ? vaxAfter : vaxBefore;
        double vy = shares ? vayAfter : vayBefore;
        if (b < 0) {
            lines.add("WALL" + first + "0 " + Math.abs(impulse) + " " + Math.round(vx) + " " + Math.round(vy) + " "
                + (nx > 0 ? "RIGHT" : nx < 0 ? "LEFT" : ny > 0 ? "BOTTOM" : "TOP"));
            return;
        }
        boolean post = bodies.kind[bodies.indexOf(b)] == EntityKind.POST.ordinal();
        lines.add("ENTITY" + first + b + " " + Math.round(bx) + " " + Math.round(by) + " " + impulse + " "
            + Math.round(post ? vx : (vaxBefore + vbxBefore) * 0.5) + " "
            + Math.round(post ? vy : (vayBefore + vbyBefore) * 0.5));
    }

    @Override
    public void knot(int id, double time, double x, double y) {
        knotBefore = lastKnot;
        lastKnot = " " + Math.round(x) + " " + Math.round(y);
    }

    @Override
    public void fact(double time, int kind, int a, int b, double x, double y, double p, double q) {
        if (kind == Captures.GOAL) {
            lines.add("SNAFFLESCORE " + ViewWriter.ANY + " " + time + " " + a + " " + b);
        } else if (kind == Captures.CAPTURE) {
            holders.add(a);
            lines.add("SNAFFLE " + ViewWriter.ANY + " " + time + " " + b + " " + a + place(a) + knotBefore);
        }
    }
}
