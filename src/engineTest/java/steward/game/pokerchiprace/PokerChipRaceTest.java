package steward.game.pokerchiprace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.Pilot;
import steward.game.TurnEvent;
import steward.game.pokerchiprace.protocol.PokerChipRaceType;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import steward.scene.json.SceneException;

/** The rules of the Poker Chip Race where no referee's game is at hand; those of whole games are in the vectors. */
@Execution(ExecutionMode.CONCURRENT)
class PokerChipRaceTest {

    private static final PokerChipRaceType.PokerChipRaceSetup SETUP = open("official");
    private static final double[] IN = {-1, -1};

    private static PokerChipRaceType.PokerChipRaceSetup open(String arithmetic) {
        String text = SceneFiles.load("poker-chip-race").text().replace("\"official\"", "\"" + arithmetic + "\"");
        return new PokerChipRaceType().open(SceneReader.read(text, "poker-chip-race.json"));
    }

    /** A table with a chip of each player, far from each other. */
    private static ChipTable quiet() {
        ChipTable table = ChipTable.empty(2, 20);
        table.add(0, 15, -100, 100, 0, 0);
        table.add(1, 20, 200, -100, 0, 0);
        return table;
    }

    private static void command(PokerChipRace game, Pilot.Aim aim, SplitMix64 random) {
        for (int player = 0; player < game.players(); player++) {
            byte[] line = SETUP.pilot(aim).answer(game, player, random).getBytes();
            assertEquals(null, SETUP.codec(game).readAnswer(player, line, line.length));
        }
    }

    @Test
    void aPushEjectsAFifteenthTheOtherWay() {
        PokerChipRace game = SETUP.create(1).on(quiet(), IN);
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
        PokerChipRace game = SETUP.create(1).on(table, IN);
        game.command(0, 0, new ChipCommand(-100.4, 100));
        game.command(0, 1, new ChipCommand(100, 100));
        game.play();

        assertEquals(3, game.bodies().size());
    }

    @Test
    void theBiggerEatsTheSmallerAndKeepsMomentum() {
        ChipTable table = quiet();
        table.add(ChipTable.NEUTRAL, 10, 100, -100, 80, 0);
        PokerChipRace game = SETUP.create(1).on(table, IN);
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
        PokerChipRace game = SETUP.create(1).on(table, IN);
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
        ChipTable table = ChipTable.empty(2, 20);
        table.add(ChipTable.NEUTRAL, 60, 0, 0, 0, 0);
        table.add(0, 15, -200, 0, -speed, 0);
        table.add(1, 15, 200, 0, -200, 0);
        PokerChipRace game = SETUP.create(1).on(table, IN);
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
        ChipTable table = ChipTable.empty(2, 20);
        table.add(0, 15, -100, 100, 0, 0);
        PokerChipRace game = SETUP.create(1).on(table, IN);
        assertTrue(game.isIn(1));
        assertEquals(1, SETUP.textCodec(game).orElseThrow().answerLines(1));
        assertEquals(null, SETUP.textCodec(game).orElseThrow().readAnswer(1, new byte[0], 0));
        game.play();

        assertEquals("it has no chips", game.eliminationReason(1));
        assertEquals(1, game.lost(1));
        assertEquals("all others are out", game.ending());
    }

    @Test
    void aCopyGoesOnAlikeAndIndependently() {
        PokerChipRace game = SETUP.create(5);
        for (int turn = 0; turn < 10; turn++) {
            command(game, Pilot.Aim.MINGLE, new SplitMix64(turn));
            game.play();
        }
        PokerChipRace copy = game.copy();
        assertEquals(game.hash(), copy.hash());
        assertEquals(game.score(0), copy.score(0));
        for (int turn = 10; turn < 60 && !game.isOver(); turn++) {
            long before = copy.hash();
            command(game, Pilot.Aim.WIN, new SplitMix64(turn));
            game.play();
            assertEquals(before, copy.hash(), "the copy stays as it was");
            command(copy, Pilot.Aim.WIN, new SplitMix64(turn));
            copy.play();
            assertEquals(game.hash(), copy.hash(), "turn " + turn);
        }
        assertNotEquals(SETUP.create(5).hash(), SETUP.create(6).hash());
    }

    /**
     * From the same states the rungs that compute the common law end nearly every turn within 1e-3 u: the
     * referee moves chips 1e-5 u away from walls.
     */
    @ParameterizedTest
    @CsvSource({"double", "compensated", "exact"})
    void otherRungsPlayTheSameGame(String arithmetic) {
        PokerChipRaceType.PokerChipRaceSetup other = open(arithmetic);
        SplitMix64 random = new SplitMix64(2);
        PokerChipRace game = SETUP.create(8);
        int same = 0;
        int turns = 150;
        for (int turn = 0; turn < turns; turn++) {
            if (game.isOver()) {
                game = SETUP.create(8 + turn);
            }
            PokerChipRace twin = other.create(1).on(game.copy().table(), IN);
            command(game, Pilot.Aim.WIN, random);
            for (int player = 0; player < 2; player++) {
                for (int k = 0; k < game.table().owned(player); k++) {
                    twin.command(player, k, game.command(player, k));
                }
            }
            game.play();
            twin.play();
            same += isNear(game.bodies(), twin.bodies()) ? 1 : 0;
        }
        assertTrue(same >= turns * 0.9, same + " of " + turns + " turns");
    }

    private static boolean isNear(Bodies one, Bodies other) {
        boolean near = one.size() == other.size();
        for (int k = 0; near && k < one.size(); k++) {
            near = one.id(k) == other.id(k) && Math.abs(one.x[k] - other.x[k]) < 1e-3
                && Math.abs(one.y[k] - other.y[k]) < 1e-3 && Math.abs(one.radius[k] - other.radius[k]) < 1e-3;
        }
        return near;
    }

    /** Turns in which no chip comes or goes; the others allocate their events. */
    @Test
    void aTurnWithoutEventsAllocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        PokerChipRace game = SETUP.create(4);
        SplitMix64 random = new SplitMix64(4);
        int free = 0;
        int eventless = 0;
        for (int turn = 0; turn < 2500; turn++) {
            game = game.isOver() ? SETUP.create(turn) : game;
            command(game, Pilot.Aim.WIN, random);
            long before = threads.getCurrentThreadAllocatedBytes();
            game.play();
            long allocated = threads.getCurrentThreadAllocatedBytes() - before;
            if (turn > 2000 && game.events().isEmpty()) {
                eventless++;
                free += allocated == 0 ? 1 : 0;
            }
        }
        assertTrue(eventless > 50, eventless + " turns");
        // A new game's log grows in its first turns.
        assertTrue(free >= 0.8 * eventless, "nothing allocated in " + free + " of " + eventless + " turns");
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
        String text = SceneFiles.load("poker-chip-race").text();
        assertTrue(text.contains(part), part);
        String message = assertThrows(SceneException.class, () -> steward.match.TestScenes.TYPES.open(
            SceneReader.read(text.replace(part, instead), "s.json"))).getMessage();
        assertTrue(message.contains(expected), message);
    }
}
