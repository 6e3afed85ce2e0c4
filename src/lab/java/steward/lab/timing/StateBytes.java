package steward.lab.timing;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import steward.physics.Bodies;
import steward.physics.PassingPairs;

/** Serialised states: one JVM draws them, others time turns that begin with them. */
final class StateBytes {

    private StateBytes() { }

    /** @throws IOException if they cannot be written */
    static void write(DataOutputStream out, List<Bodies> states) throws IOException {
        out.writeInt(states.size());
        for (Bodies bodies : states) {
            out.writeInt(bodies.capacity());
            out.writeInt(bodies.columns.length);
            out.writeInt(bodies.size());
            for (int k = 0; k < bodies.size(); k++) {
                out.writeInt(bodies.id(k));
                out.writeInt(bodies.kind[k]);
                for (double value : new double[] {bodies.x[k], bodies.y[k], bodies.radius[k], bodies.mass[k],
                    bodies.vx[k], bodies.vy[k], bodies.restitution[k], bodies.drag[k]}) {
                    out.writeDouble(value);
                }
                for (double[] column : bodies.columns) {
                    out.writeDouble(column[k]);
                }
            }
            out.writeInt(bodies.nextId());
            PassingPairs passing = bodies.passing();
            out.writeInt(passing.size());
            for (int k = 0; k < passing.size(); k++) {
                out.writeInt(passing.first(k));
                out.writeInt(passing.second(k));
            }
        }
    }

    /** @throws IOException if they cannot be read */
    static List<Bodies> read(DataInputStream in) throws IOException {
        List<Bodies> states = new ArrayList<>();
        for (int left = in.readInt(); left > 0; left--) {
            Bodies bodies = new Bodies(in.readInt(), in.readInt());
            for (int size = in.readInt(); size > 0; size--) {
                readBody(in, bodies);
            }
            takeIds(bodies, in.readInt());
            for (int pairs = in.readInt(); pairs > 0; pairs--) {
                bodies.passing().add(in.readInt(), in.readInt());
            }
            states.add(bodies);
        }
        return states;
    }

    private static void readBody(DataInputStream in, Bodies bodies) throws IOException {
        takeIds(bodies, in.readInt());
        int kind = in.readInt();
        double x = in.readDouble();
        double y = in.readDouble();
        double radius = in.readDouble();
        double mass = in.readDouble();
        int body = radius > 0 ? bodies.add(x, y, radius, mass) : bodies.addPoint(x, y, mass);
        bodies.setKind(body, kind);
        bodies.setVelocity(body, in.readDouble(), in.readDouble());
        bodies.setRestitution(body, in.readDouble());
        bodies.setDrag(body, in.readDouble());
        for (double[] column : bodies.columns) {
            column[body] = in.readDouble();
        }
    }

    private static void takeIds(Bodies bodies, int until) {
        while (bodies.nextId() < until) {
            bodies.takeId();
        }
    }
}
