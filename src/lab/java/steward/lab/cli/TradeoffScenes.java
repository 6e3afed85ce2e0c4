package steward.lab.cli;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import steward.cli.shared.Games;
import steward.cli.streams.StandardFiles;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.SeededPlay;
import steward.lab.tradeoff.TradeoffScene;
import steward.lab.tradeoff.TradeoffWorlds;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.scene.SceneFiles;
import steward.text.NearestName;

/** The scenes of the trade-off measurement: its own, and any scene that a match can be played in. */
final class TradeoffScenes {

    /** Names that {@code --scene} knows. */
    static final class Names implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            Set<String> names = new LinkedHashSet<>(all().stream().map(TradeoffScene::name).toList());
            names.add(HEADINGS);
            names.addAll(SceneFiles.shipped());
            return names.iterator();
        }
    }

    static final String RACE = "official-race";
    static final String BRAWL = "brawl";
    /** Word for the measurement apart from the rungs: the cost of trigonometry. */
    static final String HEADINGS = "headings";

    private static final String OFFICIAL = "mad-pod-racing";
    private static final String WALLED = "walled-race";
    private static final long SEED = 4;
    /** For up to 4 bodies that move; a crowd has fewer, because all pairs are scanned. */
    private static final int STATES = 5000;
    private static final int LEAST_STATES = 100;
    private static final int FREE_RUNS = 9;
    private static final int FREE_TURNS = 50;
    private static final int STEPS = 1024;

    private TradeoffScenes() {
    }

    /** All of its own scenes, in the order of the table. */
    static List<TradeoffScene> all() {
        List<TradeoffScene> scenes = new ArrayList<>(List.of(named(RACE, Games::open), named(BRAWL, Games::open),
            named(WALLED, Games::open)));
        scenes.addAll(TradeoffWorlds.all());
        return scenes;
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
            return race(RACE, "states of races by the official rules", Games.open(OFFICIAL));
        }
        if (word.equals(BRAWL)) {
            GameSetup setup = Games.open(OFFICIAL);
            return played(BRAWL, "states of four pods that all want the same checkpoint, official rules", setup,
                Pilot.Aim.GATHER);
        }
        for (TradeoffScene world : TradeoffWorlds.all()) {
            if (world.name().equals(word)) {
                return world;
            }
        }
        checkKnown(word);
        GameSetup setup = opener.apply(word);
        return race(setup.scene().name(), "states of games in this scene", setup);
    }

    /** Refuses what is neither a name nor a file, and suggests similar names. */
    private static void checkKnown(String word) {
        Set<String> known = new LinkedHashSet<>(List.of(RACE, BRAWL, HEADINGS));
        TradeoffWorlds.all().forEach(world -> known.add(world.name()));
        List<String> shipped = SceneFiles.shipped();
        known.addAll(shipped);
        boolean file = StandardFiles.is(word) || word.endsWith(".json") || word.contains("/")
            || Files.exists(OutputFiles.path(word));
        if (!file && !known.contains(word)) {
            throw new InputException("--scene: found '" + word + "', expected a scene file or one of "
                + String.join(", ", known) + NearestName.question(word, known, "'"));
        }
    }

    private static TradeoffScene race(String name, String about, GameSetup setup) {
        return played(name, about, setup, Pilot.Aim.WIN);
    }

    private static TradeoffScene played(String name, String about, GameSetup setup, Pilot.Aim aim) {
        Motion motion = setup.motion();
        boolean rounds = motion.endsInWholeNumbers();
        int movable = movable(setup.create(SEED).bodies());
        int states = Math.max(LEAST_STATES, (int) (STATES * Math.min(1, 16.0 / (movable * movable))));
        SeededPlay play = new SeededPlay(setup, setup.pilot(aim), SEED);
        return new TradeoffScene(name, about, setup.scene().json(), setup.physics(), rounds ? motion : null,
            play::next, states, FREE_RUNS, FREE_TURNS, STEPS);
    }

    private static int movable(Bodies bodies) {
        int movable = 0;
        for (int k = 0; k < bodies.size(); k++) {
            movable += bodies.inverseMass[k] > 0 ? 1 : 0;
        }
        return movable;
    }
}
