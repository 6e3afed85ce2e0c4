package steward.game.searchrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import steward.game.AbstractGameType;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.game.ServerView;
import steward.game.TextCodec;
import steward.game.ViewWriter;
import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceSettings;
import steward.physics.Contacts;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** The search race as a {@link GameType}. */
public final class SearchRaceType extends AbstractGameType {

    /** The game as the program lists it. */
    public SearchRaceType() {
        super("search-race", "the official rules and maps, one car alone against the clock", "driver", 1, 1,
            () -> SearchRaceStub.LINES, () -> SearchRaceStub.FRAMES);
    }

    @Override
    public String sceneOfLines(List<String> lines) {
        return RecordedMap.sceneOf(lines);
    }

    @Override
    public Optional<ServerView> serverView() {
        return Optional.of(new SearchRaceView());
    }

    @Override
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new SearchRaceViews());
    }

    @Override
    public SearchRaceSetup open(Scene scene) {
        refuse(scene, "field");
        refuse(scene, "impacts");
        SearchRaceSettings settings = SearchRaceSettings.read(scene);
        scene.root().done();
        Contacts contacts = new Contacts(1).set(0, 0, Contacts.Meaning.NONE).setWall(0, Contacts.Meaning.NONE);
        Plan plan = Plan.of(scene, contacts, 1, false, 1, List.of(
            new Part("headings", true, "the car turns at most 18 degrees a turn, to whole degrees", Part.When.COMMANDS),
            new Part("checkpoint times", true, "checkpoints count when the car is first in them", Part.When.OUTCOME)));
        return new SearchRaceSetup(scene, settings, plan);
    }

    private static void refuse(Scene scene, String block) {
        if (scene.root().contains(block)) {
            throw scene.root().error(block, "a block", "none: in a search race nothing meets anything");
        }
    }

    /**
     * A search race with the settings of one scene.
     *
     * @param settings its blocks {@code race} and {@code map}
     * @param plan     the parts that the scene requires
     */
    public record SearchRaceSetup(Scene scene, SearchRaceSettings settings, Plan plan) implements GameSetup {

        @Override
        public SearchRace create(long seed) {
            return new SearchRace(settings, scene, plan, seed);
        }

        /** A race on a given map, {@code [n][x, y]}, for tests and simulators. */
        public SearchRace create(double[][] checkpoints) {
            SearchRaceSettings given = new SearchRaceSettings(settings.laps(), settings.checkpointRadius(),
                settings.maximumTurns(), checkpoints);
            return new SearchRace(given, scene, plan, 0);
        }

        @Override
        public boolean simulate(BufferedReader in, PrintStream out) throws IOException {
            new SearchRaceSimulation(this, in, out).run();
            return true;
        }

        @Override
        public GameJson codec(Game game) {
            return new SearchRaceJson((SearchRace) game, scene.drag());
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new SearchRaceText((SearchRace) game));
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> SearchRacePilot.answer((SearchRace) game, random);
        }
    }
}
