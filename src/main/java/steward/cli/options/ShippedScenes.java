package steward.cli.options;

import java.util.Iterator;
import steward.scene.SceneFiles;

/** Names of the scenes that come with the program, for help and completion. */
public final class ShippedScenes implements Iterable<String> {

    @Override
    public Iterator<String> iterator() {
        return SceneFiles.shipped().iterator();
    }
}
