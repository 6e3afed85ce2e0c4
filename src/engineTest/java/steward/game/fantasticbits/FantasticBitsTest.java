package steward.game.fantasticbits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GameRules;
import steward.game.GameSetup;
import steward.game.TurnEvent;
import steward.game.fantasticbits.protocol.FantasticBitsType;
import steward.match.TestScenes;
import steward.physics.Bodies;

/** The rules of Fantastic Bits where no referee's game is at hand; those of whole games are in the vectors. */
class FantasticBitsTest extends GameRules<FantasticBits> {

    private static final FantasticBitsType.FantasticBitsSetup SETUP =
        (FantasticBitsType.FantasticBitsSetup) TestScenes.open("fantastic-bits");

    FantasticBitsTest() {
        super("fantastic-bits");
    }

    /** A game with five snaffles (4 to 8) in the upper left corner's reach of no wizard, and bludgers (9, 10). */
    private static FantasticBits quiet(int magic) {
        Pitch pitch = new Pitch(5, 2);
        for (int k = 0; k < 5; k++) {
            pitch.bodies().setPosition(4 + k, 3000 + 1000 * k, 7000);
        }
        return Pitches.game(SETUP.create(1), pitch, new int[2], new int[] {magic, magic});
    }

    @Test
    void aThrustMovesAWizardAndFrictionSlowsIt() {
        FantasticBits game = quiet(0);
        game.command(0, 0, WizardCommand.move(5000, 5250, 150));
        game.play();

        assertEquals(1150, game.bodies().x[0]);
        assertEquals(113, game.bodies().vx[0], "150 less 0.25, rounded");
        assertEquals(1, game.magic(0));
    }

    /**
     * Wizard 0 at (1000, 5250) takes a snaffle, carries it, throws it and takes none in the turn of the throw and the
     * next.
     */
    @Test
    void aSnaffleIsTakenCarriedAndThrown() {
        FantasticBits game = quiet(0);
        Bodies bodies = game.bodies();
        bodies.setPosition(4, 1450, 5250);
        game.command(0, 0, WizardCommand.move(5000, 5250, 100));
        game.play();
        assertEquals(4, game.pitch().held(0));
        assertEquals(List.of(1100.0, 75.0), List.of(bodies.x[4], bodies.vx[4]), "at the wizard, with its speed");

        assertEquals("found a throw without a snaffle in hand, expected a move or a spell",
            game.refusal(0, 1, WizardCommand.toss(0, 0, 1)));
        game.command(0, 0, WizardCommand.toss(1100, 0, 500));
        game.play();
        assertEquals(-1, game.pitch().held(0));
        assertEquals(List.of(1175.0, 4250.0), List.of(bodies.x[4], bodies.y[4]), "1000 u upward, 75 along");
        assertEquals(2.0, bodies.columns[Pitch.WAIT][0]);
    }

    /** Without a throw the snaffle is dropped and has the wizard's speed; the wizard may take it again later. */
    @Test
    void withoutAThrowASnaffleIsLetGo() {
        FantasticBits game = quiet(0);
        game.bodies().setPosition(4, 1300, 5250);
        game.play();
        assertEquals(4, game.pitch().held(0));
        game.command(0, 0, WizardCommand.move(1000, 5250, 0));
        game.play();
        assertEquals(-1, game.pitch().held(0));
        game.play();
        assertEquals(-1, game.pitch().held(0));
        game.play();
        assertEquals(4, game.pitch().held(0), "able again two turns later");
    }

    /** Snaffle 4 flies to the right wall, at this height. */
    private static FantasticBits shot(double y) {
        FantasticBits game = quiet(0);
        game.bodies().setPosition(4, 15500, y);
        game.bodies().setVelocity(4, 1000, 0);
        return game;
    }

    @Test
    void aSnaffleBetweenThePostsScoresAndGoesOn() {
        FantasticBits game = shot(3000);
        game.play();

        assertEquals(1, game.score(0));
        assertEquals(EntityKind.LOST_SNAFFLE, game.pitch().kind(4));
        assertEquals(16500, game.bodies().x[4]);
        TurnEvent goal = game.events().get(0);
        assertEquals(List.of(TurnEvent.Kind.DEATH, 0.5, 4, "goal for player 0"),
            List.of(goal.kind(), goal.time(), goal.body(), goal.text()));
        assertFalse(game.isOver());
    }

    @Test
    void aSnaffleBesideAGoalBounces() {
        FantasticBits game = shot(1000);
        game.play();

        assertEquals(0, game.score(0));
        assertEquals(15850 - 650, game.bodies().x[4]);
        assertEquals(-750, game.bodies().vx[4]);
    }

    @Test
    void aSpellIsPaidAtOnceAndWorksInTheTurnsAfter() {
        FantasticBits game = quiet(20);
        game.bodies().setVelocity(4, 100, 0);
        game.command(0, 0, WizardCommand.cast(Spell.PETRIFICUS, 4));
        game.command(1, 0, WizardCommand.cast(Spell.OBLIVIATE, 9));
        game.play();
        assertEquals(11, game.magic(0));
        assertEquals(16, game.magic(1));
        assertEquals(75, game.bodies().vx[4]);
        game.play();
        assertEquals(0, game.bodies().vx[4]);
        assertEquals(4, game.pitch().spells().turns(2, Spell.OBLIVIATE));
        game.command(0, 0, WizardCommand.cast(Spell.FLIPENDO, 5));
        game.play();
        assertEquals(13, game.magic(0), "too dear: nothing");
        assertNull(game.pitch().spells().cast(0));
    }

    @ParameterizedTest
    @CsvSource({"OBLIVIATE, 4, a bludger", "ACCIO, 2, a bludger or a snaffle in play", "FLIPENDO, 1, a bludger, a",
        "PETRIFICUS, 0, a bludger, a", "ACCIO, 99, a bludger", "ACCIO, -1, a bludger", "ACCIO, 8, a bludger",
        "OBLIVIATE, 12, a bludger"})
    void aTargetMustSuitTheSpell(Spell spell, int target, String expected) {
        FantasticBits game = quiet(100);
        game.bodies().setKind(8, EntityKind.LOST_SNAFFLE.ordinal());
        String wrong = game.refusal(0, 0, WizardCommand.cast(spell, target));
        assertTrue(wrong.startsWith("target: found " + target + ", ") && wrong.contains(", expected " + expected),
            wrong);
        assertNull(game.refusal(1, 0, WizardCommand.cast(Spell.FLIPENDO, 1)), "of the other team");
    }

    /** The game ends with this turn; the first line of the one that failed still counts, and a goal of its does not. */
    @Test
    void aPlayerAtFaultHasMinusOne() {
        FantasticBits game = shot(3000);
        game.command(0, 0, WizardCommand.move(5000, 5250, 150));
        game.eliminate(0, "test");
        assertEquals(-1, game.scores()[0]);
        game.play();

        assertEquals(1150, game.bodies().x[0]);
        assertEquals(-1, game.score(0));
        assertEquals("a player is out", game.ending());
        assertEquals(List.of(1, 0), Arrays.stream(game.ranks()).boxed().toList());
    }

    @Test
    void moreThanHalfOfTheSnafflesEndTheGame() {
        FantasticBits game = Pitches.game(SETUP.create(1), quiet(0).pitch(), new int[] {1, 2}, new int[2]);
        assertEquals(3, game.winningScore());
        game.bodies().setPosition(4, 100, 3000);
        game.bodies().setVelocity(4, -200, 0);
        game.play();
        assertEquals("a score of 3 of 5 is reached", game.ending());
    }

    @Override
    protected FantasticBits twin(GameSetup other, FantasticBits game) {
        return Pitches.game((FantasticBits) other.create(1), game.copy().pitch(),
            new int[] {game.score(0), game.score(1)},
            new int[] {game.magic(0), game.magic(1)});
    }

    @Override
    protected double alike() {
        return 0.95;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
        "variant": "puzzle" | "variant": "puzle" | match.variant: found "puzle", expected one of
        "match":            | "motion": {}, "match": | motion: found a block motion, expected none
        "radius": 300       | "radius": 200 | field: found another field, expected the pitch of Fantastic Bits
        "pushOut": 1e-5     | "pushOut": 1 | impacts: found another law of impact, expected that of the scene
        "match":            | "pods": {}, "match": | pods: found an unknown field
        """)
    void aSceneThatIsNotFantasticBitsIsRefused(String part, String instead, String expected) {
        assertRefused(part, instead, expected);
    }
}
