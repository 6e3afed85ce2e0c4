package steward.lab.cli;

import java.io.IOException;
import steward.cli.shared.Games;
import steward.lab.timing.RungJob;
import steward.lab.timing.TimedWork;
import steward.lab.timing.TimingChild;
import steward.lab.tradeoff.GrazingPasses;
import steward.physics.PhysicsParts;
import steward.scene.SceneReader;

/** Main class of a JVM that times one kind of turns for another JVM; people do not call it. */
public final class TimingMain {

    private TimingMain() { }

    /** @throws IOException if the other JVM cannot be reached */
    public static void main(String[] arguments) throws IOException {
        TimingChild.serve(System.in, System.out, TimingMain::open);
    }

    static TimedWork open(RungJob job) {
        return job.open(parts(job.scene()));
    }

    /** @param scene a scene as JSON, or the name of the passes */
    private static PhysicsParts parts(String scene) {
        return scene.startsWith("{") ? Games.types().open(SceneReader.read(scene, "the scene")).physics()
            : GrazingPasses.parts();
    }
}
