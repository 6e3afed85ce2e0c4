package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Effects of a command on its pod: shield, boost, heading, thrust; and how a turn ends for it. */
class CommandsTest {

    private final PodRace race = Races.official(Races.FAR);

    /** Pod 0 is told to fly to the right, with a thrust; returns how fast it does. */
    private double right(int thrust) {
        race.command(0, 1e9, race.pod(0).y(), thrust);
        race.play();
        assertEquals(0, race.pod(0).vy());
        return race.pod(0).vx();
    }

    @Test
    void aThrustIsAddedThenDragTakesAShareThenTheRestIsCut() {
        assertEquals(170, right(200));                    // 200 * 0.85
        assertEquals(100_200, race.pod(0).x());
        assertEquals(229, right(100));                    // 270 * 0.85 = 229.5
        assertEquals(194, right(0));                      // 229 * 0.85 = 194.65
    }

    @Test
    void aShieldTakesTheThrustOfItsTurnAndTheNextThree() {
        assertEquals(0, right(PodRace.SHIELD));
        assertEquals(10, race.bodies().mass[0]);
        for (int timer = 3; timer >= 1; timer--) {
            assertEquals(timer + 1, race.pod(0).shieldTimer());
            assertEquals(0, right(200));
            assertEquals(1, race.bodies().mass[0]);
        }
        assertEquals(170, right(200));
        assertEquals(0, race.pod(0).shieldTimer());
    }

    @Test
    void aShieldDuringTheCooldownStartsItAnewAndIsHeavyAgain() {
        right(PodRace.SHIELD);
        right(200);
        assertEquals(0, right(PodRace.SHIELD));
        assertEquals(10, race.bodies().mass[0]);
        assertEquals(4, race.pod(0).shieldTimer());
        assertEquals(0, right(200));
        assertEquals(0, right(200));
        assertEquals(0, right(200));
        assertEquals(170, right(200));
    }

    @Test
    void aPodWithoutACommandCoolsDownToo() {
        right(PodRace.SHIELD);
        Races.coast(race, 4);
        assertEquals(0, race.pod(0).shieldTimer());
        assertEquals(10, race.bodies().mass[0], "as it was commanded last");
        right(0);
        assertEquals(1, race.bodies().mass[0]);
    }

    @Test
    void aPodStillTurnsDuringTheCooldown() {
        right(PodRace.SHIELD);
        race.command(0, race.pod(0).x(), 1e9, 200);
        race.play();
        assertEquals(Math.PI / 10, race.pod(0).heading());
    }

    @Test
    void aBoostIsThereOncePerPod() {
        assertEquals(552, right(PodRace.BOOST));          // 650 * 0.85 = 552.5
        assertFalse(race.pod(0).boostLeft());
        assertEquals(639, right(PodRace.BOOST));          // (552 + 200) * 0.85 = 639.2
        for (int pod = 1; pod < 4; pod++) {
            assertTrue(race.pod(pod).boostLeft());
            race.command(pod, 1e9, race.pod(pod).y(), PodRace.BOOST);
        }
        race.play();
        for (int pod = 1; pod < 4; pod++) {
            assertEquals(552, race.pod(pod).vx());
            assertFalse(race.pod(pod).boostLeft());
        }
    }

    @Test
    void aBoostDuringTheCooldownIsLost() {
        right(PodRace.SHIELD);
        assertEquals(0, right(PodRace.BOOST));
        assertFalse(race.pod(0).boostLeft());
        right(0);
        right(0);
        assertEquals(170, right(PodRace.BOOST));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 200, PodRace.BOOST})
    void aTargetInTheOwnPlaceIsNoTurnAndNoThrust(int thrust) {
        race.setPod(0, new PodState(100, 200, 100, 0, 1.25, 0, true, 0));
        race.command(0, 100, 200, thrust);
        race.play();

        assertEquals(1.25, race.pod(0).heading());
        assertEquals(85, race.pod(0).vx());
        assertEquals(0, race.pod(0).vy());
    }

    @Test
    void aTargetInTheOwnPlaceLeavesTheHeadingUnset() {
        race.command(0, race.pod(0).x(), race.pod(0).y(), 200);
        race.play();

        assertTrue(Double.isNaN(race.pod(0).heading()));
    }

    @Test
    void aShieldIsRaisedAlsoWithATargetInTheOwnPlace() {
        race.command(0, race.pod(0).x(), race.pod(0).y(), PodRace.SHIELD);
        race.play();

        assertEquals(4, race.pod(0).shieldTimer());
        assertEquals(10, race.bodies().mass[0]);
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "-1, 0", "0, 1", "0, -1", "-3, -4", "-1, -0.0", "12345.678, -0.001"})
    void anUnsetHeadingTurnsToAnyTargetAtOnce(double dx, double dy) {
        Races.put(race, 0, 0, 0, 0, 0);
        race.command(0, dx, dy, 0);
        race.play();

        assertEquals(StrictMath.atan2(dy, dx), race.pod(0).heading());
    }

    /**
     * From heading 0. A target just within 18 degrees is looked at exactly; further ones are approached by 18 degrees
     * on the shorter way. Straight behind, the expression (2d % 2pi) - d decides: d = pi turns back, d = -pi forth.
     */
    @ParameterizedTest
    @CsvSource({"100, 0, 0", "100, 10, 0.09966865249116204", "100, -10, -0.09966865249116204",
        "0, 100, 0.3141592653589793", "0, -100, -0.3141592653589793", "-100, 1, 0.3141592653589793",
        "-100, -1, -0.3141592653589793", "-100, 0, -0.3141592653589793", "-100, -0.0, 0.3141592653589793"})
    void aHeadingTurnsAtMostEighteenDegrees(double dx, double dy, double heading) {
        race.setPod(0, new PodState(0, 0, 0, 0, 0, 0, true, 0));
        race.command(0, dx, dy, 0);
        race.play();

        assertEquals(heading, race.pod(0).heading());
    }

    @Test
    void aHeadingIsNotNormalised() {
        race.setPod(0, new PodState(0, 0, 0, 0, 3.1, 0, true, 0));
        race.command(0, -100, -50, 0);                    // at atan2 = -2.678, that is 3.605
        race.play();
        assertEquals(3.1 + Math.PI / 10, race.pod(0).heading());
        race.command(0, -100, -50, 0);
        race.play();
        assertEquals(StrictMath.atan2(-50, -100), race.pod(0).heading(), "within 18 degrees it is the raw angle");
    }

    @Test
    void theThrustGoesWhereThePodThenLooks() {
        race.setPod(0, new PodState(0, 0, 0, 0, 0, 0, true, 0));
        race.command(0, 0, 1000, 200);
        race.play();

        // 18 degrees: 200 cos = 190.2, 200 sin = 61.8; the place is rounded, the speed loses 15% and is cut.
        assertEquals(new PodState(190, 62, 161, 52, Math.PI / 10, 0, true, 0), race.pod(0));
    }

    /** Speeds are cut toward zero, where minus zero is zero; places are rounded with halves up. */
    @ParameterizedTest
    @CsvSource({"-1, 0.0, -1", "1, 0.0, 1", "-1.1, 0.0, -1", "-0.0, 0.0, 0.0", "1.2, 1, 1", "-1.2, -1, -1",
        "-100, -85, -100", "141.2, 120, 141", "0.5, 0.0, 1", "1.5, 1, 2", "-0.5, 0.0, 0.0", "-1.5, -1, -1",
        "-0.4, 0.0, 0.0", "0.49, 0.0, 0.0", "-0.51, 0.0, -1", "2.5, 2, 3"})
    void speedsAreCutAndPlacesAreRounded(double before, double speed, double place) {
        Races.put(race, 0, 0, 0, before, before);
        race.play();

        assertEquals(new PodState(place, place, speed, speed, Double.NaN, 0, true, 0), race.pod(0));
    }

    @Test
    void aCommandHoldsForOneTurn() {
        right(200);
        race.play();
        assertEquals(144, race.pod(0).vx());              // 170 * 0.85 = 144.5
    }
}
