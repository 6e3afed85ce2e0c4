package steward.lab.timing;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.physics.Bodies;
import steward.physics.PhysicsParts;
import steward.scene.Accuracy;

/**
 * The flights of a turn on a rung, timed in another JVM.
 *
 * @param scene  what the other JVM needs to make the physics: a scene as JSON, or a name
 * @param rung   to time
 * @param bodies for how many the advance is chosen
 * @param states the turns begin with
 */
public record RungJob(String scene, Accuracy rung, int bodies, List<Bodies> states) {

    /** The job as it is sent. */
    public byte[] bytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            writeText(out, scene);
            out.writeUTF(rung.text());
            out.writeInt(bodies);
            StateBytes.write(out, states);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    /**
     * Reads a job.
     *
     * @throws IOException if it is cut off
     */
    public static RungJob read(DataInputStream in) throws IOException {
        return new RungJob(readText(in), Accuracy.parse(in.readUTF()), in.readInt(), StateBytes.read(in));
    }

    /** @param parts the physics of the scene */
    public TimedTurns open(PhysicsParts parts) {
        return new StateTurns(states, rung.advance(parts.withArithmetic(rung.arithmetic()), bodies));
    }

    /** Writes a text of any length. */
    private static void writeText(DataOutputStream out, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    private static String readText(DataInputStream in) throws IOException {
        return new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
    }
}
