package steward.lab.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.trial.RunLength;
import steward.numerics.StateHash;
import steward.physics.Arithmetic;
import steward.scene.SceneFiles;

/**
 * Program that prints the golden hash and its parts: worlds on every rung, every shipped scene with every arithmetic.
 * {@code ./gradlew golden} runs it in several JVMs.
 */
public final class GoldenSuite {

    /** Turns of the short form; scenes of hundreds of bodies play fewer, which end before the bodies lie in piles. */
    private static final int SHORT = 30;
    private static final int SHORT_OF_BODIES = 12;
    private static final String ACCURACY = "\"accuracy\"\\s*:\\s*\\{[^}]*}";

    private GoldenSuite() { }

    /** @param arguments the word of a {@link RunLength}; normal if there is none */
    public static void main(String[] arguments) {
        RunLength size = RunLength.of(arguments.length == 0 ? "normal" : arguments[0]);
        for (String game : Games.ids()) {
            if (!game.equals(Games.FIRST)) {
                print(parts(game, size), "all of " + game);
            }
        }
        List<GoldenHash.Part> parts = new ArrayList<>(GoldenHash.worlds(size));   // no further game changes their hash
        parts.addAll(parts(Games.FIRST, size));
        print(parts, "all");
    }

    private static void print(List<GoldenHash.Part> parts, String all) {
        parts.forEach(part -> System.out.println(StateHash.toHex(part.hash()) + "  " + part.name()));
        System.out.println(StateHash.toHex(GoldenHash.total(parts)) + "  " + all);
    }

    private static List<GoldenHash.Part> parts(String game, RunLength size) {
        List<GoldenHash.Part> parts = new ArrayList<>();
        List<String> scenes = SceneFiles.shipped().stream()
            .filter(scene -> Games.open(scene).scene().gameId().equals(game)).toList();
        for (String scene : scenes) {
            int few = Games.open(scene).scene().players() == 0 ? SHORT_OF_BODIES : SHORT;
            int turns = size.pick(few, 500, 500);
            for (Arithmetic arithmetic : Arithmetic.values()) {
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
