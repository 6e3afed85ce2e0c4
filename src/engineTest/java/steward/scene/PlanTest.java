package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.ImpactLaw;
import steward.physics.ImpactLaw.Restitution;
import steward.physics.Motion;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;

/** A plan has exactly the parts that its scene and its game require. */
class PlanTest {

    private static final Contacts ALL = new Contacts(1);

    @Test
    void aBareSceneNeedsOnlyPairImpacts() {
        Plan plan = Plan.of(scene(""), ALL, 1, false, List.of());
        assertEquals("""
            in   pair impacts       bodies meet
            out  walls              no field
            out  restitution        everything has restitution 1, law of rest: none, elastic bodies do not rest
            out  minimum impulse    no minimumImpulse
            out  push-out           no body is moved apart
            out  batch window       only approach reacts, one impact at a time
            out  infinite masses    every mass is finite
            out  drag               no drag
            out  velocity rounding  velocities stay as they are
            out  position rounding  positions stay as they are
            out  reactions          no contact asks the game
            out  broad phase        advance event looks at all pairs
            """, PlanTable.of(plan, (part, line) -> line));
        assertEquals(new PhysicsParts(ImpactLaw.PHYSICS, Arithmetic.DOUBLE, ALL, List.of(), null, false),
            plan.physics(null));
        assertEquals(new Motion(false, false, false), plan.motion());
    }

    @Test
    void aFullSceneNeedsAlmostEverything() {
        Contacts ask = new Contacts(2).set(0, 1, Meaning.ASK);
        Plan plan = Plan.of(scene("""
            , "field": { "width": 9, "height": 9, "walls": "box",
                         "bumpers": [ { "x": 4, "y": 4, "radius": 1, "restitution": 0.8 } ] },
              "impacts": { "minimumImpulse": 30, "minimumImpulseAtWalls": true, "deadZone": 1.5, "batchWindow": 1e-5,
                           "separatingPairs": "react", "scanOrder": "descending", "pushOut": 1e-5 },
              "motion": { "drag": 0.15, "velocity": "truncate", "position": "round" }"""), ask, 0.9, true,
            List.of(new Part("headings", true, "pods turn"), new Part("checkpoint sweeps", false, "no race")));
        assertEquals("""
            in   pair impacts       bodies meet, scanOrder descending
            in   walls              4 walls
            in   restitution        restitution as low as 0.8, law of rest: none, minimumImpulse drives bodies apart
            in   minimum impulse    minimumImpulse 30, at walls too, deadZone 1.5
            in   push-out           pushOut 1e-5
            in   batch window       separatingPairs react, batchWindow 1e-5
            in   infinite masses    1 bumper
            in   drag               drag 0.15
            in   velocity rounding  velocity truncate
            in   position rounding  position round
            in   reactions          some contacts ask the game
            out  broad phase        advance event looks at all pairs
            in   headings           pods turn
            out  checkpoint sweeps  no race
            """, PlanTable.of(plan, (part, line) -> line));
        Reaction reaction = (time, a, b, bodies, sink) -> Reaction.Verdict.BOUNCE;
        PhysicsParts parts = plan.physics(reaction);
        assertEquals(Restitution.MINIMUM, parts.law().restitution());
        assertEquals(4, parts.walls().size());
        assertSame(reaction, parts.reaction());
        assertEquals(true, parts.infiniteMasses());
        assertEquals(new Motion(true, true, true), plan.motion());
        assertThrows(IllegalArgumentException.class, () -> plan.physics(null));
    }

    @Test
    void wallsThatNoBodyMeetsAreLeftOutWithTheirRestitution() {
        Scene scene = scene(", \"field\": { \"width\": 9, \"height\": 9, "
            + "\"walls\": { \"type\": \"box\", \"restitution\": 0.5 } }");
        Plan ghosts = Plan.of(scene, new Contacts(1).setWall(0, Meaning.NONE), 1, false, List.of());
        assertEquals(new Part("walls", false, "no kind of bodies meets walls"), ghosts.parts().get(1));
        assertEquals(new Part("restitution", false, "everything has restitution 1, law of rest: none, elastic bodies "
            + "do not rest"), ghosts.parts().get(2));
        assertEquals(Restitution.ELASTIC, ghosts.physics(null).law().restitution());
        assertEquals(List.of(), ghosts.physics(null).walls());

        Plan solid = Plan.of(scene, ALL, 1, false, List.of());
        assertEquals(new Part("restitution", true, "restitution as low as 0.5, law of rest: an impact below "
            + "2^-40 of the energy, no forces act"), solid.parts().get(2));
        assertEquals(Restitution.MINIMUM, solid.physics(null).law().restitution());
    }

    @Test
    void bodiesThatMeetOnlyBumpersStillHavePairImpacts() {
        Contacts contacts = new Contacts(2).set(0, 0, Meaning.NONE).set(1, 1, Meaning.NONE);
        assertEquals(true, Plan.of(scene(""), contacts, 1, false, List.of()).parts().get(0).in());
        contacts.set(0, 1, Meaning.NONE);
        assertEquals(new Part("pair impacts", false, "no two kinds of bodies meet"),
            Plan.of(scene(""), contacts, 1, false, List.of()).parts().get(0));
    }

    @Test
    void oneBumperOrBodyMakesInfiniteMasses() {
        Plan plan = Plan.of(scene(", \"field\": { \"width\": 9, \"height\": 9, "
            + "\"bumpers\": [ { \"x\": 1, \"y\": 1, \"radius\": 1 } ] }"), ALL, 1, false, List.of());
        assertEquals(new Part("walls", false, "the field has no walls"), plan.parts().get(1));
        assertEquals(new Part("infinite masses", true, "1 bumper"), plan.parts().get(6));
        assertEquals(true, plan.physics(null).infiniteMasses());
        assertNull(plan.physics(null).reaction());
        assertEquals(new Part("infinite masses", true, "bodies of mass \"infinite\""),
            Plan.of(scene(""), ALL, 1, true, List.of()).parts().get(6));
    }

    @Test
    void manyBodiesGetCellsUnlessTheirLawLooksAtAllPairs() {
        assertEquals("out advance event looks at all pairs of 23 bodies", broadPhase("", 23));
        assertEquals("in 24 bodies: cells and an event queue", broadPhase("", 24));
        assertEquals("out advance event looks at all pairs, because impacts within batchWindow react together",
            broadPhase("""
                , "impacts": { "minimumImpulse": 120, "separatingPairs": "react", "batchWindow": 1e-5 }""", 99));
    }

    @Test
    void theOfficialLawAmongFewHasALoopOfItsOwn() {
        String official = """
            , "impacts": { "minimumImpulse": 120, "separatingPairs": "react", "batchWindow": 1e-5, "pushOut": 1e-5,
              "scanOrder": "descending" }""";
        assertEquals("in pairs of 11 that cannot meet are set aside", broadPhase("official", official, 11));
        assertEquals("out advance event looks at all pairs of 12 bodies", broadPhase("official", official, 12));
        assertEquals("out advance event looks at all pairs of 4 bodies",
            broadPhase("exact", official, 4));
        assertEquals("out advance event looks at all pairs of 4 bodies",
            broadPhase("official", official.replace("120", "119"), 4));
        assertEquals("out advance event looks at all pairs", broadPhase("official", official, 0));
    }

    private static String broadPhase(String blocks, int bodies) {
        return broadPhase("double", blocks, bodies);
    }

    private static String broadPhase(String arithmetic, String blocks, int bodies) {
        Plan plan = Plan.of(scene(arithmetic, blocks), ALL, 1, false, bodies, List.of());
        Part part = plan.parts().stream().filter(p -> p.name().equals(Part.BROAD_PHASE)).findFirst().orElseThrow();
        assertEquals(part.in(), !(plan.advance(null) instanceof steward.physics.event.EventAdvance));
        return (part.in() ? "in " : "out ") + part.why();
    }

    @Test
    void theCallerMayColourTheLinesOfATable() {
        Plan plan = Plan.of(scene(""), ALL, 1, false, List.of());
        String second = PlanTable.of(plan, (part, line) -> (part.in() ? "+" : "-") + line).lines().toList().get(1);
        assertEquals("-out  walls              no field", second);
    }

    private static Scene scene(String more) {
        return scene("double", more);
    }

    private static Scene scene(String arithmetic, String more) {
        return SceneReader.read("""
            { "name": "s", "game": "g", "players": 2, "time": { "firstAnswerMs": 1000, "answerMs": 75 },
              "accuracy": { "advance": "event", "arithmetic": \"""" + arithmetic + "\" }" + more + " }", "s.json");
    }
}
