package steward.game.pokerchiprace.protocol;

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
import steward.game.pokerchiprace.ChipEating;
import steward.game.pokerchiprace.OfficialPokerChipRace;
import steward.game.pokerchiprace.PokerChipRace;
import steward.game.pokerchiprace.PokerChipRaceSettings;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.PhysicsParts;
import steward.scene.Accuracy;
import steward.scene.GameOwn;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** The Poker Chip Race as a {@link GameType}. */
public final class PokerChipRaceType extends AbstractGameType {

    /** The game as the program lists it. */
    public PokerChipRaceType() {
        super("poker-chip-race", "Poker Chip Race, the official rules, two to four players", "nibbler",
            PokerChipRaceSettings.FEWEST_PLAYERS, PokerChipRaceSettings.MOST_PLAYERS,
            () -> PokerChipRaceStub.LINES, () -> PokerChipRaceStub.FRAMES);
    }

    @Override
    @Internal
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new PokerChipRaceViews());
    }

    @Override
    public Optional<ServerView> serverView() {
        return Optional.of(new PokerChipRaceView());
    }

    @Override
    public PokerChipRaceSetup open(Scene scene) {
        PokerChipRaceSettings settings = PokerChipRaceSettings.read(scene);
        scene.root().done();
        Contacts contacts = new Contacts(1).set(0, 0, Meaning.ASK).setWall(0, Meaning.ASK);
        Plan plan = Plan.of(scene, contacts, 1, false, 0, List.of(
            new Part("pushes", true, "chips eject a fifteenth of their area", Part.When.COMMANDS),
            new Part("eating", true, "the bigger chip eats the smaller, equal ones bounce"
                + (isOfficial(scene) ? "; impacts within 1e-5 turns react together" : ""), Part.When.OUTCOME)),
            new GameOwn(OfficialPokerChipRace::new, null, ""));
        return new PokerChipRaceSetup(scene, settings, plan);
    }

    private static boolean isOfficial(Scene scene) {
        return scene.accuracy().equals(Accuracy.event(Arithmetic.OFFICIAL));
    }

    /**
     * The Poker Chip Race with the settings of one scene.
     *
     * @param settings its block {@code chips}
     * @param plan     the parts that the scene requires
     */
    public record PokerChipRaceSetup(Scene scene, PokerChipRaceSettings settings, Plan plan) implements GameSetup {

        @Override
        public PokerChipRace create(long seed) {
            return new PokerChipRace(settings, plan, seed);
        }

        @Override
        public PhysicsParts physics() {
            return plan.physics(new ChipEating());
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return new PokerChipRacePilot(aim);
        }

        @Override
        public GameJson codec(Game game) {
            return new PokerChipRaceJson((PokerChipRace) game, scene.field().orElseThrow().walls());
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new PokerChipRaceText((PokerChipRace) game));
        }
    }
}
