package steward.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import steward.physics.Advance;
import steward.physics.Motion;
import steward.physics.PhysicsParts;

/** A turn put together part by part; and what a turn without a part is made of. */
class PartByPartPhysicsTest {

    /** The classes that search for impacts, let them happen in turn, apply them and compute their impulses. */
    private static final Set<String> ROLES = Set.of("Scan", "EventLoop", "BatchLoop", "ContactResponse", "Impulse",
        "Wall", "PairSelection");

    private static GameSetup open(String scene, String rung) {
        return new GameTypes(List.of(new PodRaceType())).open(
            SceneReader.read(SceneFiles.load(scene), Accuracy.parse(rung)));
    }

    private static List<PartByPartPhysics.Step> steps(String scene, String rung) {
        return PartByPartPhysics.of(open(scene, rung));
    }

    /** With its last part added, a scene's own engine is complete: prices are of what is really played. */
    @ParameterizedTest
    @ValueSource(strings = {"duel", "mad-pod-racing", "mad-pod-racing-silver", "walled-race"})
    void allPartsTogetherAreTheScene(String scene) {
        GameSetup setup = open(scene, "event/double");
        List<PartByPartPhysics.Step> in = steps(scene, "event/double").stream()
            .filter(PartByPartPhysics.Step::in).toList();
        PartByPartPhysics.Step whole = in.get(in.size() - 1);
        PhysicsParts wanted = setup.plan().physics(null);
        assertEquals(wanted.law(), whole.parts().law());
        assertEquals(wanted.walls(), whole.parts().walls());
        assertEquals(wanted.infiniteMasses(), whole.parts().infiniteMasses());
        assertEquals(wanted.arithmetic(), whole.parts().arithmetic());
        assertEquals(setup.plan().motion(), whole.motion());
        assertEquals(classes(setup.plan().advance(null)), classes(whole.advance()));

        List<String> names = new ArrayList<>(List.of(PartByPartPhysics.EMPTY));
        setup.plan().parts().stream().filter(part -> part.in() && part.when() == Part.When.PHYSICS)
            .forEach(part -> names.add(part.name()));
        assertEquals(names, in.stream().map(PartByPartPhysics.Step::part).toList());
    }

    /**
     * Each part of a turn brings objects into it and takes others out, seen by their classes: where a part is absent,
     * no object does its work.
     */
    @Test
    void partsThatTheSceneDoesNotHaveAreNotInTheTurn() {
        assertEquals("""
            flying straight: +Bounce +Elastic +EventLoop +PairSelection
            pair impacts: +Pairs -PairSelection
            walls: +HalfPlane +Walls
            restitution: +Restituted -Elastic
            minimum impulse: +AtLeast
            infinite masses: +PairSelection
            drag:
            velocity rounding:
            position rounding:
            push-out:
            batch window: +BatchLoop -EventLoop
            reactions: +Ask -Bounce
            """, changes(steps("walled-race", "event/double")));
    }

    /** Numbers alone say whether anything is done at the end of a turn or about an overlap. */
    @Test
    void whatIsNoObjectIsANumber() {
        for (PartByPartPhysics.Step step : steps("walled-race", "event/double").subList(0, 6)) {
            assertEquals(new Motion(false, false, false), step.motion());
            assertTrue(Double.isNaN(step.parts().law().pushOut()));
        }
    }

    private static String changes(List<PartByPartPhysics.Step> steps) {
        StringBuilder text = new StringBuilder();
        Set<String> before = new TreeSet<>();
        for (PartByPartPhysics.Step step : steps) {
            Set<String> now = classes(step.advance());
            text.append(step.part()).append(':');
            now.stream().filter(name -> !before.contains(name)).forEach(name -> text.append(" +").append(name));
            before.stream().filter(name -> !now.contains(name)).forEach(name -> text.append(" -").append(name));
            text.append('\n');
            if (step.in()) {
                before.clear();
                before.addAll(now);
            }
        }
        return text.toString();
    }

    /** Of all objects that can be reached and have one of the roles. */
    private static Set<String> classes(Advance advance) {
        Set<String> names = new TreeSet<>();
        visit(advance, Collections.newSetFromMap(new IdentityHashMap<>()), names);
        return names;
    }

    private static boolean hasRole(Class<?> type) {
        return ROLES.contains(type.getSimpleName()) || ROLES.contains(type.getSuperclass().getSimpleName())
            || Arrays.stream(type.getInterfaces()).anyMatch(each -> ROLES.contains(each.getSimpleName()));
    }

    private static void visit(Object object, Set<Object> seen, Set<String> names) {
        if (object == null || !seen.add(object)) {
            return;
        }
        Class<?> type = object.getClass();
        if (type.isArray() && !type.getComponentType().isPrimitive()) {
            for (int k = 0; k < Array.getLength(object); k++) {
                visit(Array.get(object, k), seen, names);
            }
        } else if (type.getName().startsWith("steward.physics.")) {
            if (hasRole(type)) {
                names.add(type.getSimpleName());
            }
            for (Class<?> each = type; each.getName().startsWith("steward.physics."); each = each.getSuperclass()) {
                for (Field field : each.getDeclaredFields()) {
                    if (!Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive()) {
                        field.setAccessible(true);
                        try {
                            visit(field.get(object), seen, names);
                        } catch (IllegalAccessException impossible) {
                            throw new AssertionError(impossible);
                        }
                    }
                }
            }
        }
    }
}
