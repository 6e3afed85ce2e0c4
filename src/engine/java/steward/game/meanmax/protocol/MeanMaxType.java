package steward.game.meanmax.protocol;

import java.util.List;
import java.util.Map;
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
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxSettings;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.OfficialMeanMax;
import steward.game.meanmax.OilMotion;
import steward.game.meanmax.Sinking;
import steward.game.meanmax.Skill;
import steward.game.meanmax.UnitKind;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.PhysicsParts;
import steward.scene.GameOwn;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** Mean Max as a {@link GameType}. */
public final class MeanMaxType extends AbstractGameType {

    private static final int TANKERS = 3;

    /** The game as the program lists it. */
    public MeanMaxType() {
        super("mean-max", "Mean Max, the official rules, three players", "gatherer",
            MeanMaxSettings.PLAYERS, MeanMaxSettings.PLAYERS,
            () -> MeanMaxStub.LINES, () -> MeanMaxStub.FRAMES);
    }

    @Override
    @Internal
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new MeanMaxViews());
    }

    @Override
    public Optional<ServerView> serverView() {
        return Optional.of(ServerView.ofSeed("meanmax", "mean-max"));
    }

    @Override
    public String inLeague(Scene scene, int league) {
        int version = Math.min(league - 1, MeanMaxSettings.WHOLE);
        boolean already = version == MeanMaxSettings.WHOLE && !scene.root().block("harvest").contains("version");
        return already ? scene.json() : scene.root().json("harvest", Map.of("version", Integer.toString(version)));
    }

    @Override
    public MeanMaxSetup open(Scene scene) {
        MeanMaxSettings settings = MeanMaxSettings.read(scene);
        scene.root().done();
        int tanker = UnitKind.TANKER.ordinal();
        Contacts contacts = new Contacts(UnitKind.values().length)
            .set(UnitKind.DESTROYER.ordinal(), tanker, Meaning.ASK).setWall(tanker, Meaning.NONE);
        Plan plan = Plan.of(scene, contacts, MeanMaxWorld.RESTITUTION, false,
            MeanMaxSettings.PLAYERS * (UnitKind.LOOTERS + TANKERS), List.of(
                new Part("skills", settings.isActive(Skill.GRENADE), settings.isActive(Skill.TAR)
                    ? "tar, oil and grenades" : settings.isActive(Skill.GRENADE) ? "grenades" : "none in this league",
                    Part.When.COMMANDS),
                new Part("harvest", true, "reapers take water from wrecks", Part.When.OUTCOME)),
            new GameOwn(OfficialMeanMax::new, new OilMotion(), "drag 0.2 to 0.4 by kind, none in oil"));
        return new MeanMaxSetup(scene, settings, plan);
    }

    /**
     * Mean Max with the settings of one scene.
     *
     * @param settings its block {@code harvest}
     * @param plan     the parts that the scene requires
     */
    public record MeanMaxSetup(Scene scene, MeanMaxSettings settings, Plan plan) implements GameSetup {

        @Override
        public MeanMax create(long seed) {
            return new MeanMax(settings, plan, seed);
        }

        @Override
        public PhysicsParts physics() {
            return plan.physics(new Sinking());
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return new MeanMaxPilot(aim);
        }

        @Override
        public GameJson codec(Game game) {
            return new MeanMaxJson((MeanMax) game);
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new MeanMaxText((MeanMax) game));
        }
    }
}
