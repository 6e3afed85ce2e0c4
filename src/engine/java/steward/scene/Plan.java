package steward.scene;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import steward.Internal;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.physics.Wall;
import steward.physics.event.QueueAdvance;
import steward.scene.json.Wording;

/** Plan of a scene: the parts of the engine that it needs and why, and the physics built from just these. */
public final class Plan {

    private final Scene scene;
    private final Contacts contacts;
    private final int bodies;
    private final double lowestRestitution;
    private final boolean infiniteMasses;
    private final List<Wall> walls;
    private final List<Part> parts;
    private final GameOwn own;

    private Plan(Scene scene, Contacts contacts, double lowestOfBodies, boolean infiniteBodies, int bodies,
                 List<Part> gameParts, GameOwn own) {
        this.scene = scene;
        this.own = own;
        this.contacts = contacts;
        this.bodies = bodies;
        List<Bumper> bumpers = scene.field().map(Field::bumpers).orElse(List.of());
        walls = contacts.wallsMeet() ? scene.field().map(Field::walls).orElse(List.of()) : List.of();
        infiniteMasses = infiniteBodies || !bumpers.isEmpty();
        lowestRestitution = DoubleStream.concat(DoubleStream.of(lowestOfBodies),
            DoubleStream.concat(walls.stream().mapToDouble(Wall::restitution),
                bumpers.stream().mapToDouble(Bumper::restitution))).min().getAsDouble();
        parts = Stream.concat(Stream.of(
            pairImpacts(), walls(), restitution(), minimumImpulse(), pushOut(), batchWindow(),
            infiniteMasses(bumpers.size()), drag(), velocityRounding(), positionRounding(), reactions(),
            broadPhase()), gameParts.stream()).toList();
    }

    /**
     * @param contacts          what contacts between the game's kinds of bodies mean, bumpers included
     * @param lowestRestitution of the game's bodies, without bumpers and walls
     * @param infiniteMasses    whether bodies of the game can have infinite mass; bumpers count without it
     * @param gameParts         the parts of the game itself, needed or left out
     */
    public static Plan of(Scene scene, Contacts contacts, double lowestRestitution, boolean infiniteMasses,
                          List<Part> gameParts) {
        return of(scene, contacts, lowestRestitution, infiniteMasses, 0, gameParts);
    }

    /**
     * Plans a game that may have many bodies.
     *
     * @param bodies number of bodies, bumpers included; where it changes, the maximum
     */
    public static Plan of(Scene scene, Contacts contacts, double lowestRestitution, boolean infiniteMasses, int bodies,
                          List<Part> gameParts) {
        return of(scene, contacts, lowestRestitution, infiniteMasses, bodies, gameParts, GameOwn.NOTHING);
    }

    /**
     * Plans a game that brings its own official expressions or its own motion.
     *
     * @param own what it brings
     */
    public static Plan of(Scene scene, Contacts contacts, double lowestRestitution, boolean infiniteMasses, int bodies,
                          List<Part> gameParts, GameOwn own) {
        return new Plan(scene, contacts, lowestRestitution, infiniteMasses, bodies, gameParts, own);
    }

    /** The number of bodies, bumpers included, or its maximum; 0 if it was not stated. */
    public int bodies() {
        return bodies;
    }

    /** All parts, those of the game last. */
    public List<Part> parts() {
        return parts;
    }

    /**
     * @param reaction answers {@code ASK} contacts; {@code null} if there are none
     * @throws IllegalArgumentException if there are {@code ASK} contacts without a reaction, or a reaction without them
     */
    public PhysicsParts physics(Reaction reaction) {
        return new PhysicsParts(impacts(), arithmetic(), contacts, walls, reaction, infiniteMasses, own.official(),
            own.forces());
    }

    private ImpactLaw impacts() {
        return scene.law().withRestitution(lowestRestitution < 1 ? Restitution.MINIMUM : Restitution.ELASTIC);
    }

    @Internal
    public RungLaw law() {
        return RungLaw.of(scene.accuracy(), impacts(), own.forces().act());
    }

    /** The version of the law that a match is recorded with. */
    public int lawVersion() {
        return law().version();
    }

    /**
     * The advance that the scene's accuracy requires.
     *
     * @param reaction as in {@link #physics}
     */
    public Advance advance(Reaction reaction) {
        return advance(reaction, UnaryOperator.identity());
    }

    /**
     * The advance that the scene's accuracy requires, in a frame of the game's.
     *
     * @param reaction as in {@link #physics}
     * @param frame    returns an advance around another one
     */
    public Advance advance(Reaction reaction, UnaryOperator<Advance> frame) {
        PhysicsParts physics = physics(reaction);
        Advance advance = scene.accuracy().advance(physics, bodies);
        return scene.observer().observe(physics, frame.apply(advance));
    }

    /** The rung that the scene is computed on, and why that one. */
    public AccuracyChoice accuracy() {
        return scene.choice();
    }

    /** Returns the rules for speeds and positions at the end of a turn. */
    public Motion motion() {
        return own.motion() == null ? scene.motion() : own.motion();
    }

    private Arithmetic arithmetic() {
        return scene.accuracy().arithmetic();
    }

    private Part pairImpacts() {
        boolean in = contacts.bodiesMeet();
        boolean descending = scene.law().scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        return new Part(Part.PAIR_IMPACTS, in, !in ? "no two kinds of bodies meet"
            : descending ? "bodies meet, scanOrder descending" : "bodies meet");
    }

    private Part walls() {
        String absent = scene.field().isEmpty() ? "no field"
            : scene.field().get().walls().isEmpty() ? "the field has no walls" : "no kind of bodies meets walls";
        return new Part(Part.WALLS, !walls.isEmpty(), walls.isEmpty() ? absent : count(walls.size(), "wall"));
    }

    private Part restitution() {
        boolean in = lowestRestitution < 1;
        return new Part(Part.RESTITUTION, in,
            in ? "restitution as low as " + Wording.number(lowestRestitution) + ", law of rest: " + rest()
                : "everything has restitution 1, law of rest: none, elastic bodies do not rest");
    }

    /** The law of rest, and why it is that one. */
    private String rest() {
        ImpactLaw law = impacts();
        if (!law.bodiesRest()) {
            return "none, minimumImpulse drives bodies apart";
        }
        if (law.separatingPairsReact()) {
            return "none, separatingPairs react";
        }
        if (scene.accuracy().way() == Accuracy.Way.STEP) {
            return "none, fixed steps have none";
        }
        if (!Double.isNaN(law.restSpeed())) {
            return "a rebound at up to restSpeed " + Wording.number(law.restSpeed());
        }
        return own.forces().act() ? "a rebound that takes less than a turn, forces act"
            : "an impact below 2^-40 of the energy, no forces act";
    }

    private Part minimumImpulse() {
        ImpactLaw law = scene.law();
        if (!(law.minimumImpulse() > 0)) {
            return new Part(Part.MINIMUM_IMPULSE, false, "no minimumImpulse");
        }
        return new Part(Part.MINIMUM_IMPULSE, true, "minimumImpulse " + Wording.number(law.minimumImpulse())
            + (law.minimumImpulseAtWalls() ? ", at walls too" : "")
            + (Double.isNaN(law.deadZone()) ? "" : ", deadZone " + Wording.number(law.deadZone())));
    }

    private Part batchWindow() {
        ImpactLaw law = scene.law();
        boolean in = law.separatingPairsReact();
        return new Part(Part.BATCH_WINDOW, in, !in ? "only approach reacts, one impact at a time"
            : "separatingPairs react" + (law.batchWindow() > 0
                ? ", batchWindow " + Wording.number(law.batchWindow()) : ""));
    }

    private Part pushOut() {
        double pushOut = scene.law().pushOut();
        boolean in = !Double.isNaN(pushOut);
        return new Part(Part.PUSH_OUT, in, in ? "pushOut " + Wording.number(pushOut) : "no body is moved apart");
    }

    private Part infiniteMasses(int bumpers) {
        String why = bumpers > 0 ? count(bumpers, "bumper") : "bodies of mass \"infinite\"";
        return new Part(Part.INFINITE_MASSES, infiniteMasses, infiniteMasses ? why : "every mass is finite");
    }

    private Part drag() {
        boolean in = motion().drag();
        String why = own.motion() == null ? "drag " + Wording.number(scene.drag()) : own.drag();
        return new Part(Part.DRAG, in, in ? why : "no drag");
    }

    private Part velocityRounding() {
        Motion.Step step = motion().step(Motion.Of.VELOCITY);
        return new Part(Part.VELOCITY_ROUNDING, step != null,
            step == null ? "velocities stay as they are" : "velocity " + step.text());
    }

    private Part positionRounding() {
        Motion.Step step = motion().step(Motion.Of.POSITION);
        boolean first = step != null && motion().steps().size() > 1 && motion().steps().get(0) == step;
        return new Part(Part.POSITION_ROUNDING, step != null,
            step == null ? "positions stay as they are" : "position " + step.text() + (first ? ", first" : ""));
    }

    private Part reactions() {
        boolean in = contacts.containsAsk();
        return new Part(Part.REACTIONS, in, in ? "some contacts ask the game" : "no contact asks the game");
    }

    private Part broadPhase() {
        Accuracy rung = scene.accuracy();
        if (own.official() != null && rung.way() == Accuracy.Way.EVENT && arithmetic().isOfficial()) {
            return new Part(Part.BROAD_PHASE, false, "the referee's own loop looks at all pairs"
                + (bodies == 0 ? "" : " of " + count(bodies, "body", "bodies")));
        }
        if (rung.usesCells(scene.law(), bodies)) {
            return new Part(Part.BROAD_PHASE, true, bodies + " bodies: cells and an event queue");
        }
        if (!contacts.containsAsk() && rung.usesOfficialLoop(physics(null), bodies)) {
            return new Part(Part.BROAD_PHASE, true, "pairs of " + bodies + " that cannot meet are set aside");
        }
        String all = "advance " + rung.way().text() + " looks at all pairs";
        if (bodies < Accuracy.FEWEST_FOR_CELLS || rung.way() == Accuracy.Way.STEP) {
            String of = bodies == 0 ? "" : " of " + count(bodies, "body", "bodies");
            return new Part(Part.BROAD_PHASE, false, all + of);
        }
        return new Part(Part.BROAD_PHASE, false, all + ", because " + QueueAdvance.refusal(scene.law()));
    }

    private static String count(int number, String what) {
        return count(number, what, what + "s");
    }

    private static String count(int number, String one, String many) {
        return number + " " + (number == 1 ? one : many);
    }
}
