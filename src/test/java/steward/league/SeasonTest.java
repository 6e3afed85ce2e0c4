package steward.league;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.scene.Accuracy;
import steward.scene.RungLaw;

class SeasonTest {

    private static Season of(String rules) {
        return Season.of("duel", "0123456789abcdef", "1000 ms, 75 ms", rules, 2, false);
    }

    /** The rules of a season as programs wrote them before laws had versions; the scene has no rest. */
    @ParameterizedTest
    @CsvSource({"event/official", "event/double", "event/compensated", "event/exact", "step/8"})
    void aSeasonOfBeforeVersionsGoesOnWhereTheLawIsTheFirst(String rung) {
        GameSetup setup = Games.open("mad-pod-racing", Accuracy.parse(rung));
        RungLaw law = setup.plan().law();
        String before = "b8309ca632eecf63 " + rung + " CORRECTLY_ROUNDED";
        Season now = Season.of(setup, LeagueSettings.usual("mad-pod-racing", 1));
        assertEquals(law.version() == 1, before.equals(now.rules()), now.rules());
    }

    @Test
    void aSceneThatHasBeenChangedIsNamed() {
        Season one = of("rules");
        assertEquals("the scene duel has been changed",
            one.difference(Season.of("duel", "2", one.limits(), "rules", 2, false)));
        assertEquals("the scene is another one (crowd, was duel)",
            one.difference(Season.of("crowd", "2", one.limits(), "rules", 2, false)));
    }

    @Test
    void anotherLawIsSaidByItsRung() {
        Season first = of("b8309ca632eecf63 event/exact CORRECTLY_ROUNDED");
        assertEquals("the law of event/exact is another version",
            first.difference(of("0123456789abcdef event/exact CORRECTLY_ROUNDED")));
        assertEquals("the version of the rules is another one",
            first.difference(of("b8309ca632eecf63 event/double CORRECTLY_ROUNDED")));
    }
}
