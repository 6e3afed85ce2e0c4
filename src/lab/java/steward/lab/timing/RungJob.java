package steward.lab.timing;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.scene.Accuracy;

/**
 * Work to be timed in this JVM or in another: the flights of one turn on a rung.
 *
 * @param scene  what the other JVM needs to make the physics: a scene as JSON, or a name
 * @param rung   to time
 * @param bodies for how many the advance is chosen
 * @param states the turns begin with
 */
public record RungJob(String scene, Accuracy rung, int bodies, List<Bodies> states) {

    /** @throws IOException if the job cannot be written */
    void write(DataOutputStream out) throws IOException {
        byte[] text = scene.getBytes(StandardCharsets.UTF_8);      // a text of any length
        out.writeInt(text.length);
        out.write(text);
        out.writeUTF(rung.text());
        out.writeInt(bodies);
        StateBytes.write(out, states);
    }

    /** @throws IOException if the job is cut off */
    static RungJob read(DataInputStream in) throws IOException {
        return new RungJob(new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8),
            Accuracy.parse(in.readUTF()), in.readInt(), StateBytes.read(in));
    }

    /** @param parts the physics of the scene */
    public TimedWork open(PhysicsParts parts) {
        return new StateTurns(states, rung.advance(parts.withArithmetic(rung.arithmetic()), bodies));
    }
}
