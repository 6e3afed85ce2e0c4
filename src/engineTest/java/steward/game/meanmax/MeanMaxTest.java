package steward.game.meanmax;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GameRules;
import steward.game.GameSetup;
import steward.game.TurnEvent;
import steward.game.meanmax.protocol.MeanMaxType;
import steward.match.TestScenes;
import steward.physics.Bodies;
import steward.physics.Reaction;
import steward.physics.TurnSink;

/** The rules of Mean Max where no referee's game is at hand; those of whole games are in the vectors. */
class MeanMaxTest extends GameRules<MeanMax> {

    private static final MeanMaxType.MeanMaxSetup SETUP = (MeanMaxType.MeanMaxSetup) TestScenes.open("mean-max");

    MeanMaxTest() {
        super("mean-max");
    }

    /** A game with all looters far apart at rest, and no tankers. */
    private static MeanMax quiet(int[] rages) {
        return MeanMaxWorlds.game(SETUP.create(1), quietWorld(), new int[3], rages);
    }

    private static MeanMax drawn(int... scores) {
        return MeanMaxWorlds.game(SETUP.create(1), MeanMaxWorld.draw(SETUP.settings(), 3, 3), scores, 0, 0, 0);
    }

    private static MeanMaxWorld quietWorld() {
        MeanMaxWorld world = MeanMaxWorlds.empty(SETUP.settings(), 1, 12);
        for (int looter = 0; looter < 9; looter++) {
            UnitKind kind = UnitKind.of(looter % 3);
            int body = MeanMaxWorlds.addUnit(world, looter, kind, looter / 3, 400, kind.mass(), 0, 0);
            world.bodies().setPosition(body, 2000 * (looter % 3 - 1), 2000 * (looter / 3 - 1));
        }
        return world;
    }

    @Test
    void aThrustMovesALooterByItsMass() {
        MeanMax game = quiet(new int[3]);
        game.command(0, 0, LooterCommand.move(-2000, 5000, 1000));
        game.play();
        Bodies bodies = game.bodies();

        assertEquals(-2000 + 600, bodies.y[0], "300 at most, divided by 0.5");
        assertEquals(480, bodies.vy[0], "less 0.2");
        assertEquals(0, bodies.vx[0]);
    }

    @Test
    void aSkillCostsRageAndStaysForItsTurns() {
        MeanMax game = quiet(new int[] {100, 29, 300});
        game.command(0, 0, LooterCommand.skill(-2000, -500));
        game.command(1, 0, LooterCommand.skill(-2000, 0));
        game.command(2, 0, LooterCommand.skill(-2000, 2000 - 2001));
        game.play();

        assertEquals(70, game.rage(0));
        assertEquals(29, game.rage(1), "too dear");
        assertEquals(300, game.rage(2), "too far away");
        assertEquals(1, game.world().effects().size());
        SkillEffect tar = game.world().effects().get(0);
        assertEquals(List.of(9, Skill.TAR, 2, 0), List.of(tar.id(), tar.skill(), tar.duration(), tar.looter()));
        game.play();
        game.play();
        assertEquals(0, game.world().effects().size());
    }

    @Test
    void tarMakesHeavyAndOilKeepsSpeed() {
        MeanMax game = quiet(new int[] {300, 300, 300});
        game.command(0, 0, LooterCommand.skill(-2000, -2000));
        game.command(0, 1, LooterCommand.move(5000, -2000, 300));
        game.command(1, 2, LooterCommand.skill(2000, 0));
        game.command(1, 1, LooterCommand.move(5000, 0, 300));
        game.play();
        Bodies bodies = game.bodies();

        assertEquals(0.5, bodies.mass[0], "tar has worn off at the end of the turn");
        assertEquals(140, bodies.vx[1], "destroyer of player 0: 200 less 0.3");
        assertEquals(140, bodies.vx[4], "2000 u from the oil's centre is out of reach");
        game.command(1, 2, LooterCommand.move(2000, 5000, 300));
        game.play();
        assertEquals(300, bodies.vy[5], "in oil nothing is lost");
    }

    @Test
    void aGrenadeThrowsUnitsAway() {
        MeanMax game = quiet(new int[] {60, 0, 0});
        game.command(0, 1, LooterCommand.skill(-1000, -2000));
        game.play();
        Bodies bodies = game.bodies();

        assertEquals(-2000 - 2000, bodies.x[0], "reaper: 1000 / 0.5 to the left");
        assertEquals(0, game.world().effects().size());
        assertEquals(0, game.rage(0));
    }

    /** A destroyer sinks a tanker and goes on through; the reaper in the wreck takes a water each turn. */
    @Test
    void aSunkenTankerIsHarvested() {
        MeanMaxWorld world = quietWorld();
        int tanker = MeanMaxWorlds.addUnit(world, 9, UnitKind.TANKER, 2, 600, 3.5, 2, 4);
        world.bodies().setPosition(tanker, 1000, -2600);
        world.bodies().setPosition(1, -10, -2600);
        world.bodies().setPosition(0, 1000, -3650);
        MeanMax game = MeanMaxWorlds.game(SETUP.create(1), world, new int[3], new int[3]);
        game.command(0, 1, LooterCommand.move(5000, -2600, 300));
        game.command(0, 0, LooterCommand.move(1000, 0, 300));
        game.play();

        assertEquals(1, game.world().wrecks().size());
        Wreck wreck = game.world().wrecks().get(0);
        assertEquals(List.of(10, 1000.0, -2600.0, 600.0), List.of(wreck.id(), wreck.x(), wreck.y(), wreck.radius()));
        assertEquals(1, game.score(0), "at once");
        assertEquals(11, game.bodies().id(9), "a new tanker comes");
        assertEquals(2, (int) game.bodies().columns[MeanMaxWorld.OWNER][9], "for the same player");
        assertEquals(List.of(TurnEvent.Kind.DEATH, TurnEvent.Kind.BIRTH),
            game.events().stream().map(TurnEvent::kind).toList());
    }

    @Test
    void tarSavesATankerFromSinking() {
        Bodies bodies = new Bodies(2, 3);
        bodies.add(0, 0, 400, 1.5);
        bodies.setKind(0, UnitKind.DESTROYER.ordinal());
        bodies.add(1000, 0, 600, 13.5);
        bodies.setKind(1, UnitKind.TANKER.ordinal());

        assertEquals(Reaction.Verdict.BOUNCE,
            new Sinking().on(0.5, 0, 1, bodies, TurnSink.NONE));
        bodies.setMass(1, 3.5);
        assertEquals(Reaction.Verdict.CHANGED,
            new Sinking().on(0.5, 0, 1, bodies, TurnSink.NONE));
        assertEquals(1, bodies.size());
        assertEquals(3, bodies.nextId(), "the wreck has taken an id");
    }

    /** Two pass 1 in the same turn: they tie before the third. */
    @Test
    void equalScoresTie() {
        MeanMax game = drawn(4, 7, 7);

        assertEquals(List.of(2, 0, 0), Arrays.stream(game.ranks()).boxed().toList());
    }

    @Test
    void theLastOneLeftMustBeAhead() {
        MeanMax behind = firstAlone(4);
        assertFalse(behind.isOver());
        MeanMax ahead = firstAlone(8);
        assertEquals("all others are out and behind", ahead.ending());
    }

    /** A turn later, of scores n, 7 and 2, whose last two are out. */
    private static MeanMax firstAlone(int score) {
        MeanMax game = drawn(score, 7, 2);
        game.eliminate(1, "test");
        game.eliminate(2, "test");
        game.play();
        return game;
    }

    @Override
    protected MeanMax twin(GameSetup other, MeanMax game) {
        return MeanMaxWorlds.game((MeanMax) other.create(1), game.copy().world(),
            new int[] {game.score(0), game.score(1), game.score(2)}, game.rage(0), game.rage(1), game.rage(2));
    }

    @Override
    protected double alike() {
        return 0.95;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "winningScore": 50 | "winningScore": 0 | harvest.winningScore: found 0, expected a whole number 1..1000
        "harvest":         | "motion": {}, "harvest": | motion: found a block motion, expected none
        "radius": 6000     | "radius": 5000 | field: found another field, expected the arena of Mean Max
        "pushOut": 1e-5    | "pushOut": 1 | impacts: found another law of impact, expected that of the scene mean-max
        "harvest":         | "pods": {}, "harvest": | pods: found an unknown field
        """)
    void aSceneThatIsNotMeanMaxIsRefused(String part, String instead, String expected) {
        assertRefused(part, instead, expected);
    }
}
