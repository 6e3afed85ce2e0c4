package steward.lab.calibration;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import steward.game.GameTypes;
import steward.lab.timing.RungJob;
import steward.lab.timing.StateBytes;
import steward.lab.timing.TimedTurns;
import steward.physics.Bodies;
import steward.scene.SceneReader;

/**
 * A slice of a scene's turn, timed in another JVM.
 *
 * @param scene  as JSON
 * @param slice  its number among {@link PartSlices}
 * @param states the turns begin with
 */
public record PartJob(String scene, int slice, List<Bodies> states) {

    /** The first word of such a job. */
    public static final String KIND = "part";

    /** The job as it is sent. */
    public byte[] bytes() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            out.writeUTF(KIND);
            RungJob.writeText(out, scene);
            out.writeInt(slice);
            StateBytes.write(out, states);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return bytes.toByteArray();
    }

    /**
     * Reads what follows the first word.
     *
     * @throws IOException if it is cut off
     */
    public static PartJob read(DataInputStream in) throws IOException {
        return new PartJob(RungJob.readText(in), in.readInt(), StateBytes.read(in));
    }

    /** @param types to open the scene with */
    public TimedTurns open(GameTypes types) {
        return new PartSlices(SceneReader.read(scene, "the scene"), types, states).open(slice);
    }
}
