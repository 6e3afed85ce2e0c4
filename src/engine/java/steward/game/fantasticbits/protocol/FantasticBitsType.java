package steward.game.fantasticbits.protocol;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
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
import steward.game.fantasticbits.Captures;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.FantasticBitsSettings;
import steward.game.fantasticbits.OfficialFantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Variant;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.scene.GameOwn;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;
import steward.scene.json.Block;

/** Fantastic Bits as a {@link GameType}. */
public final class FantasticBitsType extends AbstractGameType {

    /** The game as the program lists it. */
    public FantasticBitsType() {
        super("fantastic-bits", "Fantastic Bits, the official rules, two players", "chaser",
            FantasticBitsSettings.PLAYERS, FantasticBitsSettings.PLAYERS,
            () -> FantasticBitsStub.LINES, () -> FantasticBitsStub.FRAMES);
    }

    @Override
    public String about(Scene scene) {
        return open(scene).settings().variant() == Variant.CONTEST
            ? "Fantastic Bits as it was in the contest of 2016, two players" : about();
    }

    @Override
    @Internal
    public Optional<ServerView> serverView() {
        return Optional.of(ServerView.ofSeed(FantasticBitsViews.TITLE, "fantastic-bits"));
    }

    @Override
    @Internal
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new FantasticBitsViews());
    }

    /** Bludgers come with the second league, spells with the third. */
    @Override
    public String inLeague(Scene scene, int league) {
        Block match = scene.root().block("match");
        boolean already = league > 2 && !match.contains("bludgers") && !match.contains("spells");
        return already ? scene.json() : scene.root().json("match", new TreeMap<>(Map.of(
            "bludgers", Boolean.toString(league > 1), "spells", Boolean.toString(league > 2))));
    }

    @Override
    public FantasticBitsSetup open(Scene scene) {
        FantasticBitsSettings settings = FantasticBitsSettings.read(scene);
        scene.root().done();
        Plan plan = Plan.of(scene, contacts(), 1, false,
            Pitch.WIZARDS + Pitch.MOST_SNAFFLES + Pitch.BLUDGERS + Pitch.POSTS.size(), List.of(
                new Part("spells", settings.spells(), settings.spells() ? "variant " + settings.variant().text()
                    : "none in this league", Part.When.COMMANDS),
                new Part("captures", true, "wizards take and throw snaffles", Part.When.COMMANDS),
                new Part("goals", true, "snaffles leave between the posts", Part.When.OUTCOME)),
            new GameOwn(OfficialFantasticBits::new, new Motion(Pitch.endOfTurn()), "drag 0.1 or 0.25 by kind"));
        return new FantasticBitsSetup(scene, settings, plan);
    }

    /** Bludgers meet all; held snaffles and those out of play meet only them. */
    private static Contacts contacts() {
        int wizard = EntityKind.WIZARD.ordinal();
        int snaffle = EntityKind.SNAFFLE.ordinal();
        int bludger = EntityKind.BLUDGER.ordinal();
        int post = EntityKind.POST.ordinal();
        Contacts contacts = new Contacts(EntityKind.values().length)
            .set(wizard, wizard, Meaning.ASK).set(wizard, bludger, Meaning.ASK).set(wizard, post, Meaning.ASK)
            .set(snaffle, snaffle, Meaning.ASK).askWithin(wizard, snaffle, Captures.REACH)
            .setWall(wizard, Meaning.ASK).setWall(snaffle, Meaning.ASK).setWall(post, Meaning.NONE);
        for (EntityKind absent : List.of(EntityKind.HELD_SNAFFLE, EntityKind.LOST_SNAFFLE)) {
            for (EntityKind other : EntityKind.values()) {
                if (other != EntityKind.BLUDGER) {
                    contacts.set(absent.ordinal(), other.ordinal(), Meaning.NONE);
                }
            }
            contacts.setWall(absent.ordinal(), Meaning.NONE);
        }
        return contacts;
    }

    /**
     * Fantastic Bits with the settings of one scene.
     *
     * @param settings its block {@code match}
     * @param plan     the parts that the scene requires
     */
    public record FantasticBitsSetup(Scene scene, FantasticBitsSettings settings, Plan plan) implements GameSetup {

        @Override
        public FantasticBits create(long seed) {
            return new FantasticBits(settings, plan, seed);
        }

        @Override
        public PhysicsParts physics() {
            return plan.physics(new Captures());
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return new FantasticBitsPilot(aim);
        }

        @Override
        public GameJson codec(Game game) {
            return new FantasticBitsJson((FantasticBits) game);
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new FantasticBitsText((FantasticBits) game));
        }
    }
}
