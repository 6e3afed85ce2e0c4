package steward.game.pokerchiprace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GameRules;
import steward.game.GameSetup;
import steward.game.TurnEvent;
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.match.TestScenes;
import steward.physics.Bodies;

/** The rules of the Poker Chip Race where no referee's game is at hand; those of whole games are in the vectors. */
@Execution(ExecutionMode.CONCURRENT)
class PokerChipRaceTest extends GameRules<PokerChipRace> {

    private static final PokerChipRaceType.PokerChipRaceSetup SETUP =
        (PokerChipRaceType.PokerChipRaceSetup) TestScenes.open("poker-chip-race");
    private static final double[] IN = {-1, -1};

    PokerChipRaceTest() {
        super("poker-chip-race");
    }

    /** A table with a chip of each player, far from each other. */
    private static ChipTable quiet() {
        ChipTable table = ChipTables.empty(2, 20);
        table.add(0, 15, -100, 100, 0, 0);
        table.add(1, 20, 200, -100, 0, 0);
        return table;
    }

    @Test
    void aPushEjectsAFifteenthTheOtherWay() {
        PokerChipRace game = ChipTables.game(SETUP, quiet(), IN);
        game.command(0, 0, new ChipCommand(0, 100));
        double area = game.bodies().mass[0];
        game.play();
        Bodies bodies = game.bodies();

        assertEquals(3, bodies.size());
        assertEquals(-1, game.table().owner(2), "neutral");
        assertEquals(1.0 / 15, bodies.mass[2] / area, 1e-8);
        assertEquals(200.0 / 14, bodies.vx[0], 1e-5);
        assertEquals(-200, bodies.vx[2], 1e-9);
        assertEquals(area, bodies.mass[0] + bodies.mass[2], 1e-9);
        assertEquals(List.of(TurnEvent.Kind.BIRTH), game.events().stream().map(TurnEvent::kind).toList());
    }

    @Test
    void smallChipsAndNearTargetsAreNotPushed() {
        ChipTable table = quiet();
        table.add(0, ChipTable.SMALL, 0, 0, 0, 0);
        PokerChipRace game = ChipTables.game(SETUP, table, IN);
        game.command(0, 0, new ChipCommand(-100.4, 100));
        game.command(0, 1, new ChipCommand(100, 100));
        game.play();

        assertEquals(3, game.bodies().size());
    }

    @Test
    void theBiggerEatsTheSmallerAndKeepsMomentum() {
        ChipTable table = quiet();
        table.add(ChipTable.NEUTRAL, 10, 100, -100, 80, 0);
        PokerChipRace game = ChipTables.game(SETUP, table, IN);
        game.play();
        Bodies bodies = game.bodies();

        assertEquals(2, bodies.size());
        assertEquals(Math.sqrt(500), bodies.radius[1], 1e-9);
        assertEquals(16, bodies.vx[1], 1e-9);
        assertEquals(List.of(TurnEvent.Kind.DEATH), game.events().stream().map(TurnEvent::kind).toList());
    }

    @Test
    void theLastOneWithChipsWins() {
        ChipTable table = quiet();
        table.bodies().setVelocity(0, 300, -200);
        PokerChipRace game = ChipTables.game(SETUP, table, IN);
        game.play();

        assertEquals("all others are out", game.ending());
        assertEquals("its last chip was eaten", game.eliminationReason(0));
        assertTrue(game.lost(0) > 1 && game.lost(0) < 2, "turn 1 and the time within it: " + game.lost(0));
        assertEquals(List.of(1, 0), Arrays.stream(game.ranks()).boxed().toList());
        assertEquals(1 + Math.round(Math.PI * 625), game.score(1));
    }

    /**
     * Both lose their last chip in one turn. As the referee counts, an eaten chip has the area pi until the next turn,
     * so that the players stand in their order, and only one who loses it later than those before is ahead of them.
     */
    @ParameterizedTest
    @CsvSource({"-250, 0, 1", "-150, 0, 0"})
    void twoWhoAreEatenInOneTurn(double speed, int first, int second) {
        ChipTable table = ChipTables.empty(2, 20);
        table.add(ChipTable.NEUTRAL, 60, 0, 0, 0, 0);
        table.add(0, 15, -200, 0, -speed, 0);
        table.add(1, 15, 200, 0, -200, 0);
        PokerChipRace game = ChipTables.game(SETUP, table, IN);
        game.play();

        assertEquals("all are out", game.ending());
        assertEquals(speed < -200, game.lost(1) > game.lost(0));
        assertEquals(List.of(first, second), List.of(game.score(0), game.score(1)));
    }

    @Test
    void theChipsOfAPlayerAtFaultBecomeNeutralAndThreeGoOn() {
        PokerChipRaceType.PokerChipRaceSetup three = PokerReplay.setup(3, "");
        PokerChipRace game = three.create(3);
        int own = game.table().owned(1);
        game.command(1, 0, new ChipCommand(0, 0));
        game.eliminate(1, "no answer");
        game.play();

        assertFalse(game.isOver());
        assertEquals(0, game.lost(1));
        assertEquals(0, game.table().owned(1));
        long owned = Arrays.stream(game.bodies().columns[ChipTable.OWNER], 0, game.bodies().size())
            .filter(owner -> owner == 1).count();
        assertEquals(0, owned);
        assertTrue(own > 0);
        assertTrue(game.events().stream().anyMatch(event -> event.kind() == TurnEvent.Kind.BIRTH),
            "what it had said before its fault takes effect");
        game.eliminate(0, "no answer");
        long before = game.bodies().size();
        game.play();
        assertEquals("all others are out, the turn is not played", game.ending());
        assertEquals(before, game.bodies().size());
        assertEquals(List.of(1, 2, 0), Arrays.stream(game.ranks()).boxed().toList());
    }

    /** It is asked once, for no line, and is out with the first turn. */
    @Test
    void aPlayerForWhoseChipsThereIsNoPlaceIsOut() {
        ChipTable table = ChipTables.empty(2, 20);
        table.add(0, 15, -100, 100, 0, 0);
        PokerChipRace game = ChipTables.game(SETUP, table, IN);
        assertTrue(game.isIn(1));
        assertEquals(1, SETUP.textCodec(game).orElseThrow().answerLines(1));
        assertEquals(null, SETUP.textCodec(game).orElseThrow().readAnswer(1, new byte[0], 0));
        game.play();

        assertEquals("it has no chips", game.eliminationReason(1));
        assertEquals(1, game.lost(1));
        assertEquals("all others are out", game.ending());
    }

    @Override
    protected PokerChipRace twin(GameSetup other, PokerChipRace game) {
        return ChipTables.game((PokerChipRaceType.PokerChipRaceSetup) other, game.copy().table(), IN);
    }

    @Override
    protected double alike() {
        return 0.9;
    }

    /** The referee moves chips 1e-5 u away from walls. */
    @Override
    protected double tolerance() {
        return 1e-3;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "maximumTurns": 300 | "maximumTurns": 0 | chips.maximumTurns: found 0, expected a whole number 1..1000
        "chips":       | "motion": {}, "chips": | motion: found a block motion, expected none: nothing slows a chip
        "height": 515  | "height": 500 | field: found another field, expected the table: x -400, y -257.5, width 800
        "chips":       | "impacts": { "pushOut": 1 }, "chips": | impacts: found another law of impact, expected none
        "chips":       | "pods": {}, "chips": | pods: found an unknown field
        "players": 2   | "players": 5 | players: found 5, expected 2..4
        """)
    void aSceneThatIsNoPokerChipRaceIsRefused(String part, String instead, String expected) {
        assertRefused(part, instead, expected);
    }
}
