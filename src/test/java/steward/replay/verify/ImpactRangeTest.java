package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import steward.game.AngleVariants;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/** How far a unit in the last place of sines and cosines reaches. */
class ImpactRangeTest {

    private static PodRace race() {
        PodRace race = (new PodRaceType().open(SceneReader.read(
            SceneFiles.load("mad-pod-racing"), null))).create(new double[][] {{-1e6, -1e6}, {1e6, 1e6}});
        race.setPod(0, new PodState(6604, 3176, -95, -300, 3.126392304229368, 3, true, 0));
        race.setPod(1, new PodState(7041, 5398, -127, -82, -1.7994764356989612, 0, true, 0));
        race.setPod(2, new PodState(6242, 3987, 59, -340, -0.36645592449386627, 0, true, 0));
        race.setPod(3, new PodState(9828, 4559, -266, -432, -2.5305662822948003, 0, true, 0));
        race.command(0, -2922, 6218, 198);
        race.command(1, 8081, -4548, 197);
        race.command(2, 8573, 2099, 200);
        race.command(3, 5999, 4229, 50);
        return race;
    }

    private static ImpactRange range(PodRace race) {
        AngleVariants variants = race.angleVariants();
        race.play();
        return new ImpactRange(race, variants);
    }

    /** Sines and cosines of fdlibm (StrictMath) gave these values for the turn: one of them is a unit off. */
    @Test
    void anotherLibrarysValuesAreWithinTheRange() {
        PodRace race = race();
        ImpactRange range = range(race);
        int impact = 0;
        while (race.log().impact(impact).a() != 2 || race.log().impact(impact).b() != 0) {
            impact++;
        }
        assertEquals(0.32874234638560124, race.log().impact(impact).time());
        assertTrue(range.holdsTime(impact, 0.32874234638560124));
        assertTrue(range.holdsImpulse(impact, 257.5044991122482));
        assertTrue(range.holdsTime(impact, 0.32874234638560107));
        assertTrue(range.holdsImpulse(impact, 257.50449911224814));
        assertFalse(range.holdsTime(impact, 0.3287423463));
        assertFalse(range.holdsTime(impact, 0.3287423464));
        assertFalse(range.holdsImpulse(impact, 257.50449));
        assertFalse(range.holdsImpulse(impact, 257.5045));
    }

    @Test
    void theTurnItselfIsPlayedAsWithoutVariants() {
        PodRace race = race();
        PodRace other = race();
        other.play();
        range(race);

        assertEquals(other.hash(), race.hash());
    }

    @Test
    void everyCombinationIsPlayed() {
        int[] count = {0};
        race().angleVariants().play(log -> count[0]++);

        assertEquals(9 * 9 * 9, count[0], "three pods have thrust, the shield of pod 0 cools down");
    }
}
