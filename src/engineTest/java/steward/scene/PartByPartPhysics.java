package steward.scene;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import steward.game.GameSetup;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.HalfPlane;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.ImpactLaw.ScanOrder;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.TurnSink;
import steward.physics.Wall;

/**
 * The physics of a scene put together one part at a time, from an empty scene where bodies only fly: a benchmark
 * measures what each part adds. The parts that the scene has come first, each added to those before; then the parts
 * that it does not have, each added to the whole scene, with typical settings.
 *
 * <p>Caveats: a broad phase comes last and saves work; reactions are those of a game that
 * always answers {@code BOUNCE}; restitution is looked up but bodies keep their values; a batch window needs a minimum
 * impulse and a push-out, so it adds those if they are missing.
 */
public final class PartByPartPhysics {

    /** Name of the first step, in which every body flies straight. */
    public static final String EMPTY = "flying straight";

    /** The parts of the physics; one that a game has of its own has no step. */
    private static final Set<String> KNOWN = Set.of(Part.PAIR_IMPACTS, Part.WALLS, Part.RESTITUTION,
        Part.MINIMUM_IMPULSE, Part.BATCH_WINDOW, Part.PUSH_OUT, Part.INFINITE_MASSES, Part.DRAG,
        Part.VELOCITY_ROUNDING, Part.POSITION_ROUNDING, Part.REACTIONS, Part.BROAD_PHASE);

    /** A trial minimum impulse: it matters in weak impacts only. */
    private static final double SOME_IMPULSE = 1;
    /** The batch window of the official games. */
    private static final double SOME_WINDOW = 1e-5;
    private static final double SOME_PUSH_OUT = 1e-5;
    /** Distance of the trial walls in units, beyond all bodies: tested, but not touched. */
    private static final double FAR = 1e6;
    private static final List<Wall> SOME_WALLS = List.of(new HalfPlane(-FAR, 0, 1, 0, 1),
        new HalfPlane(0, -FAR, 0, 1, 1), new HalfPlane(FAR, 0, -1, 0, 1), new HalfPlane(0, FAR, 0, -1, 1));

    private final Scene scene;
    private final PhysicsParts full;
    private final int bodies;

    private boolean pairs;
    private boolean ask;
    private boolean broadPhase;
    private List<Wall> walls = List.of();
    private ImpactLaw law = ImpactLaw.PHYSICS;
    private boolean infiniteMasses;
    private final EnumSet<Motion.Of> moved = EnumSet.noneOf(Motion.Of.class);
    private final Motion wholeMotion;

    /**
     * A turn made of a subset of the parts.
     *
     * @param part    the part that the previous step (or the whole scene) does not have
     * @param in      whether the scene has it
     * @param advance made of these parts, on the scene's rung
     * @param motion  the end of a turn
     */
    public record Step(String part, boolean in, PhysicsParts parts, Advance advance, Motion motion) { }

    private PartByPartPhysics(GameSetup setup) {
        scene = setup.scene();
        bodies = setup.plan().bodies();
        boolean asks = setup.plan().parts().stream().anyMatch(part -> part.name().equals(Part.REACTIONS) && part.in());
        wholeMotion = setup.motion();
        full = setup.plan().physics(asks ? PartByPartPhysics::bounce : null);
    }

    private static Reaction.Verdict bounce(double time, int a, int b, Bodies bodies, TurnSink sink) {
        return Reaction.Verdict.BOUNCE;
    }

    public static List<Step> of(GameSetup setup) {
        List<Part> parts = setup.plan().parts().stream()
            .filter(part -> KNOWN.contains(part.name()) && (part.in() || !part.name().equals(Part.BROAD_PHASE)))
            .toList();
        PartByPartPhysics whole = new PartByPartPhysics(setup);
        List<Step> steps = new ArrayList<>();
        steps.add(whole.step(EMPTY, true));
        parts.stream().filter(Part::in).forEach(part -> {
            whole.add(part.name(), true);
            steps.add(whole.step(part.name(), true));
        });
        parts.stream().filter(part -> !part.in()).forEach(part -> {
            PartByPartPhysics more = new PartByPartPhysics(setup);
            parts.stream().filter(Part::in).forEach(in -> more.add(in.name(), true));
            more.add(part.name(), false);
            steps.add(more.step(part.name(), false));
        });
        return List.copyOf(steps);
    }

    private Step step(String part, boolean in) {
        PhysicsParts parts = new PhysicsParts(law, full.arithmetic(), contacts(), walls,
            ask ? PartByPartPhysics::bounce : null, infiniteMasses);
        Accuracy rung = scene.accuracy();
        return new Step(part, in, parts, broadPhase ? rung.advance(parts, bodies) : rung.advance(parts), motion());
    }

    /** The steps so far: those of the scene in its order, and typical ones in place of those it does not have. */
    private Motion motion() {
        List<Motion.Step> steps = new ArrayList<>(wholeMotion.only(moved.toArray(new Motion.Of[0])).steps());
        for (Motion.Step typical : new Motion(true, true, true).steps()) {
            if (moved.contains(typical.about()) && wholeMotion.step(typical.about()) == null) {
                steps.add(typical);
            }
        }
        return new Motion(steps);
    }

    /** The scene's contacts; simpler ones where the scene does not ask yet, or where nothing meets. */
    private Contacts contacts() {
        Contacts from = full.contacts();
        Contacts contacts = new Contacts(from.kinds());
        for (int a = 0; a < from.kinds(); a++) {
            for (int b = a; b < from.kinds(); b++) {
                contacts.set(a, b, pairs ? meaning(from.between(a, b), from.bodiesMeet()) : Meaning.NONE);
            }
            contacts.setWall(a, meaning(from.withWall(a), from.wallsMeet()));
        }
        return contacts;
    }

    private Meaning meaning(Meaning stated, boolean anyStated) {
        Meaning meets = anyStated ? stated : Meaning.BOUNCE;
        return meets == Meaning.NONE ? Meaning.NONE
            : ask && (stated == Meaning.ASK || !full.contacts().containsAsk()) ? Meaning.ASK : Meaning.BOUNCE;
    }

    /** @param in whether the scene has the part; otherwise a typical setting is used */
    private void add(String part, boolean in) {
        ImpactLaw wanted = full.law();
        switch (part) {
            case Part.PAIR_IMPACTS -> {
                pairs = true;
                law = with(law.separatingPairsReact(), law.batchWindow(), wanted.scanOrder());
            }
            case Part.WALLS -> walls = in ? full.walls() : SOME_WALLS;
            case Part.RESTITUTION -> law = law.withRestitution(Restitution.MINIMUM);
            case Part.MINIMUM_IMPULSE -> law = in
                ? law.withMinimumImpulse(wanted.minimumImpulse(), wanted.minimumImpulseAtWalls())
                    .withDeadZone(wanted.deadZone())
                : law.withMinimumImpulse(SOME_IMPULSE, false);
            case Part.BATCH_WINDOW -> {
                law = law.minimumImpulse() > 0 ? law : law.withMinimumImpulse(SOME_IMPULSE, false);
                law = Double.isNaN(law.pushOut()) ? law.withPushOut(SOME_PUSH_OUT) : law;
                law = with(true, in ? wanted.batchWindow() : SOME_WINDOW, law.scanOrder());
            }
            case Part.PUSH_OUT -> law = law.withPushOut(in ? wanted.pushOut() : SOME_PUSH_OUT);
            case Part.INFINITE_MASSES -> infiniteMasses = true;
            case Part.DRAG -> moved.add(Motion.Of.DRAG);
            case Part.VELOCITY_ROUNDING -> moved.add(Motion.Of.VELOCITY);
            case Part.POSITION_ROUNDING -> moved.add(Motion.Of.POSITION);
            case Part.REACTIONS -> ask = true;
            case Part.BROAD_PHASE -> broadPhase = true;
            default -> throw new IllegalArgumentException("no step for the part " + part);
        }
    }

    private ImpactLaw with(boolean separatingPairsReact, double batchWindow, ScanOrder order) {
        return new ImpactLaw(law.restitution(), law.minimumImpulse(), law.minimumImpulseAtWalls(), law.deadZone(),
            separatingPairsReact, batchWindow, order, law.pushOut(), full.law().maximumImpacts(),
            law.restSpeed());
    }
}
