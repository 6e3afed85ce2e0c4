package steward.game.bodies.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import steward.game.AbstractGameType;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.game.TextCodec;
import steward.game.bodies.BodiesGame;
import steward.game.bodies.Body;
import steward.game.bodies.Layout;
import steward.game.bodies.PlayRules;
import steward.physics.Motion;
import steward.scene.GameOwn;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;
import steward.scene.json.Wording;

/** The game {@code bodies} as a {@link GameType}. */
public final class BodiesType extends AbstractGameType {

    /** The game as the program lists it. */
    public BodiesType() {
        super("bodies", "discs and walls that a scene lists, with or without players", null, 0, MOST_PLAYERS,
            () -> BodiesStub.LINES, () -> BodiesStub.FRAMES);
    }

    @Override
    public String about(Scene scene) {
        return switch (scene.name()) {
            case "avalanche" -> "a hundred discs slide down a slope and come to rest";
            case "billiards" -> "fifteen balls and a break, with cushions and drag";
            case "bowl" -> "two hundred discs fall into a bowl with two walls";
            case "bullets" -> "ten small fast discs among thirty large ones";
            case "cradle" -> "Newton's cradle";
            case "dense-box" -> "fifty discs that cover 60% of a box";
            case "gas" -> "a thousand discs that cover 10% of a box";
            default -> about();
        };
    }

    @Override
    public String withTurns(Scene scene, int turns) {
        return scene.root().json("play", Map.of("maximumTurns", Integer.toString(turns)));
    }

    @Override
    public GameSetup open(Scene scene) {
        BodiesReader reader = new BodiesReader(scene);
        Layout layout = reader.layout();
        PlayRules rules = reader.rules();
        scene.root().done();
        double restitution = 1;
        double drag = 0;
        boolean infinite = false;
        List<Body> kinds = new ArrayList<>(layout.listed());
        layout.fills().forEach(fill -> kinds.add(fill.like()));
        for (Body body : kinds) {
            restitution = Math.min(restitution, body.restitution());
            drag = Math.max(drag, body.drag());
            infinite |= body.mass() == Double.POSITIVE_INFINITY;
        }
        Plan plan = Plan.of(scene, rules.contacts(), restitution, infinite,
            layout.count() + layout.field().bumpers().size(), parts(rules), own(scene, drag, rules));
        return new Setup(scene, reader, layout, rules, plan);
    }

    private static List<Part> parts(PlayRules rules) {
        boolean pushed = rules.forces().act();
        int zones = rules.zones().size();
        return List.of(
            new Part("forces", pushed, pushed ? "an impulse on every body at the start of a turn"
                : "no force and no gravity", Part.When.COMMANDS),
            new Part("thrusts", rules.maximumThrust() > 0, rules.maximumThrust() > 0
                ? "players command thrusts up to " + Wording.number(rules.maximumThrust()) : "no players",
                Part.When.COMMANDS),
            new Part("zones", zones > 0, zones == 0 ? "no zones" : zones + (zones == 1 ? " zone" : " zones"),
                Part.When.OUTCOME));
    }

    /** Drag at the end of turns, also where only bodies have it and the scene's motion does not. */
    private static GameOwn own(Scene scene, double drag, PlayRules rules) {
        if (drag == 0 || scene.motion().drag()) {
            return new GameOwn(null, null, "", rules.forces());
        }
        List<Motion.Step> steps = new ArrayList<>(scene.motion().steps());
        steps.add(!steps.isEmpty() && steps.get(0).about() == Motion.Of.POSITION ? 1 : 0, Motion.Step.DRAG);
        return new GameOwn(null, new Motion(steps), "drag up to " + Wording.number(drag) + " by body", rules.forces());
    }

    /** Bodies with the settings of one scene. */
    private record Setup(Scene scene, BodiesReader reader, Layout layout, PlayRules rules, Plan plan)
        implements GameSetup {

        /** @throws steward.scene.json.SceneException if a fill does not fit by this seed */
        @Override
        public Game create(long seed) {
            try {
                return new BodiesGame(layout, rules, plan, scene.players(), seed);
            } catch (Layout.NoRoomException problem) {
                throw reader.error(problem, layout.fills().get(problem.fill()).count());
            }
        }

        @Override
        public int mostTurns() {
            return rules.maximumTurns();
        }

        /** Lays out the bodies once. */
        @Override
        public List<String> check() {
            create(0);
            return reader.warnings(layout, rules);
        }

        @Override
        public GameJson codec(Game game) {
            return new BodiesJson((BodiesGame) game, layout.field());
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new BodiesText((BodiesGame) game));
        }

        /** Pushes at random, whatever the aim. */
        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> BodiesAnswer.drawn(((BodiesGame) game).owned(player).length,
                rules.maximumThrust(), random);
        }
    }
}
