package steward.minigame;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.game.GameSetup;
import steward.game.GameTypes;

/** Scenes of the games that are only there for tests. */
public final class MiniScenes {

    /** The pond alone. */
    static final GameTypes POND = new GameTypes(List.of(new PondType()));

    private MiniScenes() {
    }

    /** The pond's scene with some texts, each of which must be there, replaced. */
    public static GameSetup pond(String... fromTo) {
        return open(POND, "pond.json", fromTo);
    }

    /** A scene with some texts, each of which must be there, replaced. */
    public static GameSetup open(GameTypes types, String file, String... fromTo) {
        String text;
        try (InputStream in = MiniScenes.class.getResourceAsStream("/minigame/" + file)) {
            text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        for (int k = 0; k < fromTo.length; k += 2) {
            if (!text.contains(fromTo[k])) {
                throw new IllegalArgumentException("no " + fromTo[k]);
            }
            text = text.replace(fromTo[k], fromTo[k + 1]);
        }
        return types.open(text, file);
    }
}
