package steward.game.podrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import steward.Internal;
import steward.game.AbstractGameType;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.game.ServerView;
import steward.game.TextCodec;
import steward.game.ViewWriter;
import steward.game.podrace.PlaceCheck;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.RulesEdition;
import steward.game.podrace.simulator.MatchTurn;
import steward.physics.Arena;
import steward.physics.Contacts;
import steward.physics.Wall;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** The pod race as a {@link GameType}. */
public final class PodRaceType extends AbstractGameType {

    /** The game as the program lists it. */
    public PodRaceType() {
        super("pod-race", "the official rules of pod-race", "racer", 1, MOST_PLAYERS,
            () -> PodRaceStub.LINES, () -> PodRaceStub.FRAMES);
    }

    @Override
    public int mostOnSite() {
        return 2;
    }

    @Override
    public PodRaceSetup open(Scene scene) {
        PodRaceSettings settings = PodRaceSettings.read(scene);
        checkRoom(scene, settings);
        scene.root().done();
        int bumpers = scene.field().map(field -> field.bumpers().size()).orElse(0);
        int bodies = settings.pods() + bumpers;
        Plan plan = Plan.of(scene, new Contacts(1), settings.restitution(), bumpers > 0, bodies, List.of(
            new Part("headings", true, "pods turn at most 18 degrees a turn", Part.When.COMMANDS),
            new Part("checkpoint sweeps", true, "checkpoints count along the whole path of a turn",
                Part.When.OUTCOME)));
        return new PodRaceSetup(scene, settings, plan);
    }

    @Override
    @Internal
    public Optional<ServerView> serverView() {
        return Optional.of(new PodRaceView());
    }

    @Override
    @Internal
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new PodRaceViews());
    }

    private static void checkRoom(Scene scene, PodRaceSettings settings) {
        if (scene.field().isEmpty()) {
            return;
        }
        for (Wall wall : scene.field().get().walls()) {
            if (wall instanceof Arena arena && arena.radius() <= settings.radius()) {
                throw scene.root().block("pods").error("radius", Double.toString(settings.radius()),
                    "less than the radius of the arena, " + arena.radius());
            }
        }
    }

    /**
     * A pod race with the settings of one scene.
     *
     * @param settings its blocks {@code pods} and {@code race}
     * @param plan     the parts that the scene requires
     */
    public record PodRaceSetup(Scene scene, @Internal PodRaceSettings settings, Plan plan) implements GameSetup {

        /** Made by {@link PodRaceType#open}. */
        @Internal
        public PodRaceSetup {
        }

        @Override
        public List<String> check() {
            return PlaceCheck.of(scene, settings);
        }

        @Override
        public PodRace create(long seed) {
            return new PodRace(settings, scene, plan, seed, MatchTurn::of);
        }

        /** A race on a given map, {@code [n][x, y]}, for tests against recordings and for simulators. */
        public PodRace create(double[][] checkpoints) {
            return new PodRace(settings, scene, plan, checkpoints, plan.advance(null), MatchTurn::of);
        }

        @Override
        public String edition() {
            return settings.rules() == RulesEdition.LIVE ? RulesEdition.LIVE.word() : "";
        }

        @Override
        public boolean simulate(BufferedReader in, PrintStream out) throws IOException {
            new PodRaceSimulation(this, in, out).run();
            return true;
        }

        @Override
        public GameJson codec(Game game) {
            return new PodRaceJson((PodRace) game, scene);
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> PodRacePilot.answer((PodRace) game, player, random, aim);
        }

        /** CodinGame's protocols: that of the single-pod leagues where each player has one pod. */
        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new PodRaceText((PodRace) game));
        }
    }
}
