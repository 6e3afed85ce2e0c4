package steward.cli.lab;

import java.util.ArrayList;
import java.util.List;
import java.util.StringJoiner;
import java.util.regex.Matcher;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.game.podrace.protocol.PodRaceType;
import steward.lab.stability.GoldenHash;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.numerics.SplitMix64;
import steward.physics.Arithmetic;
import steward.scene.SceneFiles;

/** What the golden hash covers: worlds on every rung, and every shipped scene with every arithmetic. */
final class GoldenSuite {

    private static final String ACCURACY = "\"accuracy\"\\s*:\\s*\\{[^}]*}";

    private GoldenSuite() {
    }

    /** How many parts there are. */
    static int count() {
        return GoldenHash.WORLDS * Rung.all().size() + SceneFiles.shipped().size() * (Arithmetic.OF_SCENES.size() + 1);
    }

    /** @param after called after each part */
    static List<GoldenHash.Part> parts(RunLength size, Runnable after) {
        List<GoldenHash.Part> parts = new ArrayList<>(GoldenHash.worlds(size, after));
        int turns = size == RunLength.SMALL ? 30 : 500;
        for (String scene : SceneFiles.shipped()) {
            for (Arithmetic arithmetic : Arithmetic.OF_SCENES) {
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

    private static GoldenHash.Part play(String scene, String accuracy, String rung, int turns) {
        String text = SceneFiles.load(scene).text().replaceFirst(ACCURACY, Matcher.quoteReplacement(accuracy));
        GameSetup setup = Games.types().open(text, scene);
        int pods = ((PodRaceType.PodRaceSetup) setup).settings().podsPerPlayer();
        return GoldenHash.game(scene + ", " + rung, setup, (player, random) -> crowd(pods, random), turns);
    }

    /** Every pod heads for a random place near the middle, so that they meet; now and then one raises its shield. */
    private static String crowd(int pods, SplitMix64 random) {
        StringJoiner all = new StringJoiner(",", "{\"pods\":[", "]}");
        for (int pod = 0; pod < pods; pod++) {
            all.add("{\"x\":" + random.nextInt(6000, 10_000) + ",\"y\":" + random.nextInt(3000, 6000)
                + (random.nextInt(20) == 0 ? ",\"shield\":true}" : ",\"thrust\":" + random.nextInt(50, 100) + "}"));
        }
        return all.toString();
    }
}
