package steward.lab.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.stability.GoldenHash;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.physics.Arithmetic;
import steward.scene.SceneFiles;

/** Turns that the golden hash covers: worlds on every rung, and every shipped scene with every arithmetic. */
final class GoldenSuite {

    /** Turns of the short form; scenes of hundreds of bodies play fewer, which end before the bodies lie in piles. */
    private static final int SHORT = 30;
    private static final int SHORT_OF_BODIES = 12;
    private static final String ACCURACY = "\"accuracy\"\\s*:\\s*\\{[^}]*}";

    /** Returns the number of parts, of all games. */
    static int count() {
        return GoldenHash.WORLDS * Rung.all().size() + SceneFiles.shipped().size() * (Arithmetic.values().length + 1);
    }

    /**
     * The worlds and the scenes of the first game, whose hash no further game changes.
     *
     * @param after called after each part
     */
    static List<GoldenHash.Part> parts(RunLength size, Runnable after) {
        List<GoldenHash.Part> parts = new ArrayList<>(GoldenHash.worlds(size, after));
        parts.addAll(parts(Games.FIRST, size, after));
        return parts;
    }

    /**
     * The scenes of a game.
     *
     * @param after called after each part
     */
    static List<GoldenHash.Part> parts(String game, RunLength size, Runnable after) {
        List<GoldenHash.Part> parts = new ArrayList<>();
        List<String> scenes = SceneFiles.shipped().stream()
            .filter(scene -> Games.open(scene).scene().gameId().equals(game)).toList();
        for (String scene : scenes) {
            int turns = turns(scene, size);
            for (Arithmetic arithmetic : Arithmetic.values()) {
                parts.add(play(scene, "\"accuracy\": {\"advance\": \"event\", \"arithmetic\": \"" + arithmetic.text()
                    + "\"}", arithmetic.text(), turns));
                after.run();
            }
            parts.add(play(scene,
                "\"accuracy\": {\"advance\": \"step\", \"steps\": 16, \"arithmetic\": \"double\"}", "step/16", turns));
            after.run();
        }
        return parts;
    }

    private static int turns(String scene, RunLength size) {
        int few = Games.open(scene).scene().players() == 0 ? SHORT_OF_BODIES : SHORT;
        return size.pick(few, 500, 500);
    }

    private static GoldenHash.Part play(String scene, String accuracy, String rung, int turns) {
        String text = SceneFiles.load(scene).text().replaceFirst(ACCURACY, Matcher.quoteReplacement(accuracy));
        GameSetup setup = Games.types().open(text, scene);
        return GoldenHash.game(scene + ", " + rung, setup, setup.pilot(Pilot.Aim.MINGLE), turns);
    }
}
