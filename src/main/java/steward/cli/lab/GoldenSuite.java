package steward.cli.lab;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.stability.GoldenHash;
import steward.lab.trial.RunLength;
import steward.physics.Arithmetic;
import steward.scene.SceneFiles;

/** What the golden hash covers: worlds on every rung, and every shipped scene with every arithmetic. */
final class GoldenSuite {

    private static final String ACCURACY = "\"accuracy\"\\s*:\\s*\\{[^}]*}";

    private GoldenSuite() {
    }

    static List<GoldenHash.Part> parts(RunLength size) {
        List<GoldenHash.Part> parts = new ArrayList<>(GoldenHash.worlds(size));
        int turns = size == RunLength.SMALL ? 30 : 500;
        for (String scene : SceneFiles.shipped()) {
            for (Arithmetic arithmetic : Arithmetic.OF_SCENES) {
                parts.add(play(scene, "\"accuracy\": {\"advance\": \"event\", \"arithmetic\": \"" + arithmetic.text()
                    + "\"}", arithmetic.text(), turns));
            }
            parts.add(play(scene,
                "\"accuracy\": {\"advance\": \"step\", \"steps\": 16, \"arithmetic\": \"double\"}", "step/16", turns));
        }
        return parts;
    }

    private static GoldenHash.Part play(String scene, String accuracy, String rung, int turns) {
        String text = SceneFiles.load(scene).text().replaceFirst(ACCURACY, Matcher.quoteReplacement(accuracy));
        GameSetup setup = Games.types().open(text, scene);
        return GoldenHash.game(scene + ", " + rung, setup, setup.pilot(Pilot.Aim.MINGLE), turns);
    }
}
