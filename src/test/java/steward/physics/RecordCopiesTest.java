package steward.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.contest.KeptReplays;
import steward.league.LeagueBot;
import steward.league.LeagueSettings;
import steward.match.Protocol;
import steward.match.TestScenes;
import steward.replay.ReplayHeader;
import steward.scene.Scene;
import steward.scene.Time;

/** Copies of records with other values: what a method is not given stays as it was. */
class RecordCopiesTest {

    private static final ImpactLaw LAW = new ImpactLaw(ImpactLaw.Restitution.MINIMUM, 0, true, 0.5, false, 0,
        ImpactLaw.ScanOrder.DESCENDING, 0.25, 77, 3);

    /** One of each record that has such methods, no component of it the usual one. */
    static List<Record> records() {
        Scene scene = TestScenes.open("walled-race").scene();
        return List.of(LAW, new PhysicsParts(LAW, Arithmetic.DOUBLE, new Contacts(2), Arrays.asList(Wall.box(9, 9, 1)),
            null, true), scene, new ReplayHeader("g", "{}", 3, List.of("a"), List.of("b"), List.of(Protocol.JSON), 2, 4,
            "s", "light", "j", Map.of(0, new Time(5, 6))), LeagueSettings.usual("duel", 5)
            .with("a", 3, KeptReplays.values()[1]));
    }

    @ParameterizedTest
    @MethodSource("records")
    void aCopyDiffersOnlyInWhatItIsGiven(Record original) throws ReflectiveOperationException {
        int copies = 0;
        for (Method method : original.getClass().getDeclaredMethods()) {
            if (Modifier.isStatic(method.getModifiers()) || method.getReturnType() != original.getClass()
                || !method.getName().matches("with.*|ofLaw|signedBy")) {
                continue;
            }
            method.setAccessible(true);
            Object[] values = Arrays.stream(method.getParameterTypes()).map(RecordCopiesTest::another).toArray();
            Object copy = method.invoke(original, values);
            int changed = 0;
            for (RecordComponent component : original.getClass().getRecordComponents()) {
                component.getAccessor().setAccessible(true);
                changed += Objects.deepEquals(component.getAccessor().invoke(original),
                    component.getAccessor().invoke(copy)) ? 0 : 1;
            }
            assertTrue(changed <= values.length, method + " changes " + changed + " components");
            copies++;
        }
        assertTrue(copies > 0, original.getClass() + " has no such methods");
    }

    /** A value of a type that is none of those above. */
    private static Object another(Class<?> type) {
        return type == double.class ? (Object) 0.0 : type == int.class ? (Object) 6 : type == boolean.class
            ? (Object) false : type == String.class ? "another" : type.isEnum() ? type.getEnumConstants()[0]
            : type == List.class ? List.of()
            : type == LeagueBot.class ? new LeagueBot("another", "./bot", null, false, false) : null;
    }

    @Test
    void theRestSpeedSurvivesAnotherBoundOnImpacts() {
        assertEquals(LAW.restSpeed(), LAW.withMaximumImpacts(5).restSpeed());
    }
}
