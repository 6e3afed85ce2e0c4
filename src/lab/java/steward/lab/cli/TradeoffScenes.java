package steward.lab.cli;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import steward.cli.shared.Games;
import steward.cli.streams.StandardFiles;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.Calibration;
import steward.lab.calibration.SeededPlay;
import steward.lab.tradeoff.GrazingPasses;
import steward.lab.tradeoff.TradeoffScene;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.scene.SceneFiles;
import steward.text.NearestName;

/** Scenes of the trade-off measurement: built-in ones, and any scene in which a match can be played. */
final class TradeoffScenes {

    /** Names that {@code --scene} knows. */
    static final class Names implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return known().iterator();
        }
    }

    static final String RACE = "official-race";
    static final String BRAWL = "brawl";

    private static final String OFFICIAL = "mad-pod-racing";
    /** The shipped scenes among its own. */
    private static final List<String> SHIPPED = List.of("walled-race", "dense-box", "gas", "bullets", "avalanche",
        "bowl");
    private static final long SEED = 4;
    /** Of a game without players every seventh turn gives a state, so that few states are from all of it. */
    private static final int STRIDE = 7;

    /** All of its own scenes, in the order of the table. */
    static List<TradeoffScene> all() {
        List<String> words = new ArrayList<>(List.of(RACE, BRAWL));
        words.addAll(SHIPPED);
        words.add(GrazingPasses.NAME);
        return of(words, Games::open);
    }

    /**
     * The scenes that were asked for.
     *
     * @param words  names of its own scenes or of shipped ones, or files
     * @param opener opens those that are not its own
     * @throws InputException                if there is no such scene
     * @throws steward.scene.json.SceneException if a file cannot be used
     */
    static List<TradeoffScene> of(List<String> words, Function<String, GameSetup> opener) {
        return new LinkedHashSet<>(words).stream().map(word -> named(word, opener)).toList();
    }

    private static TradeoffScene named(String word, Function<String, GameSetup> opener) {
        if (word.equals(RACE)) {
            return played(RACE, "states of races by the official rules", Games.open(OFFICIAL), Pilot.Aim.WIN);
        }
        if (word.equals(BRAWL)) {
            return played(BRAWL, "states of four pods that all want the same checkpoint, official rules",
                Games.open(OFFICIAL), Pilot.Aim.GATHER);
        }
        if (word.equals(GrazingPasses.NAME)) {
            return GrazingPasses.scene();
        }
        checkKnown(word);
        GameSetup setup = opener.apply(word);
        return played(setup.scene().name(), "states of games in this scene", setup, Pilot.Aim.WIN);
    }

    private static Set<String> known() {
        Set<String> known = new LinkedHashSet<>(List.of(RACE, BRAWL, GrazingPasses.NAME));
        known.addAll(SceneFiles.shipped());
        return known;
    }

    /** Refuses what is neither a name nor a file, and suggests similar names. */
    private static void checkKnown(String word) {
        Set<String> known = known();
        boolean file = StandardFiles.is(word) || word.endsWith(".json") || word.contains("/")
            || Files.exists(OutputFiles.path(word));
        if (!file && !known.contains(word)) {
            throw new InputException("--scene: found '" + word + "', expected a scene file or one of "
                + String.join(", ", known) + NearestName.question(word, known, "'"));
        }
    }

    private static TradeoffScene played(String name, String about, GameSetup setup, Pilot.Aim aim) {
        Motion motion = setup.motion();
        boolean rounds = motion.endsInWholeNumbers();
        int movable = movable(setup.create(SEED).bodies());
        Amount amount = Amount.of(movable);
        SeededPlay play = new SeededPlay(setup, setup.pilot(aim), SEED);
        return new TradeoffScene(name, about, setup.scene().json(), setup.physics(), rounds ? motion : null,
            setup.scene().players() > 0 ? play::next : () -> sparse(play), amount.states, amount.freeRuns,
            amount.freeTurns, Calibration.mostSteps(movable));
    }

    private static Bodies sparse(SeededPlay play) {
        for (int turn = 1; turn < STRIDE; turn++) {
            play.next();
        }
        return play.next();
    }

    /** Extent of a measurement; less of a crowd, because the truth looks at all pairs. */
    private record Amount(int states, int freeRuns, int freeTurns) {

        private static final int FEW = 16;
        private static final int SOME = 64;
        private static final int MANY = 300;

        static Amount of(int movable) {
            return movable <= FEW ? new Amount(
                Math.max(200, (int) (5000 * Math.min(1, 16.0 / (movable * movable)))), 9, 50)
                : movable <= SOME ? new Amount(150, 5, 40)
                : movable <= MANY ? new Amount(20, 1, 5) : new Amount(20, 1, 10);
        }
    }

    private static int movable(Bodies bodies) {
        return (int) IntStream.range(0, bodies.size()).filter(k -> bodies.inverseMass[k] > 0).count();
    }
}
