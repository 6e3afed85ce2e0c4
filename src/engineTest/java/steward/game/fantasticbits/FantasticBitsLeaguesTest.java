package steward.game.fantasticbits;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.CodecText;
import steward.game.GameSetup;
import steward.match.TestScenes;

/**
 * The lower leagues of Fantastic Bits, by the two switches of the published referees: no bludgers, no spells. Whole
 * games of them are compared by {@link FantasticBitsVectorsTest}, whose matches may state the switches.
 */
class FantasticBitsLeaguesTest {

    private static final int SEED = 4;

    private static GameSetup league(boolean bludgers, boolean spells) {
        return TestScenes.changed("fantastic-bits", "\"maximumTurns\":", "\"bludgers\": " + bludgers + ", \"spells\": "
            + spells + ", \"maximumTurns\":");
    }

    private static String answer(GameSetup setup, FantasticBits game, int player, String answer) {
        return CodecText.read(setup.textCodec(game).orElseThrow(), player, answer);
    }

    /** Everything else stands where it stands with bludgers; the posts take the ids that these would have. */
    @Test
    void withoutBludgersNobodyIsTold() {
        GameSetup setup = league(false, true);
        FantasticBits game = (FantasticBits) setup.create(SEED);
        FantasticBits whole = (FantasticBits) league(true, true).create(SEED);
        assertEquals(whole.pitch().entities() - 2, game.pitch().entities());
        assertEquals(whole.bodies().size() - 2, game.bodies().size());
        for (int k = 0; k < game.pitch().entities(); k++) {
            assertEquals(whole.bodies().x[k], game.bodies().x[k]);
        }
        String text = CodecText.turn(setup.textCodec(game).orElseThrow(), 0);
        assertEquals(game.pitch().entities(), Integer.parseInt(text.lines().toList().get(2)));
        assertTrue(!text.contains("BLUDGER"), text);
        int post = game.pitch().entities();
        assertTrue(answer(setup, game, 0, "OBLIVIATE " + post + "\nMOVE 1 2 3").contains("no entity"));
    }

    /** A spell has to have a target all the same, but is never paid. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void withoutSpellsNobodyGathersMagic(boolean bludgers) {
        GameSetup setup = league(bludgers, false);
        FantasticBits game = (FantasticBits) setup.create(SEED);
        for (int turn = 0; turn < 30; turn++) {
            assertNull(answer(setup, game, 0, "PETRIFICUS 2\nACCIO 4"));
            assertNull(answer(setup, game, 1, "FLIPENDO 0\nMOVE 8000 3750 100"));
            game.play();
        }
        assertEquals(0, game.magic(0));
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            for (Spell spell : Spell.values()) {
                assertEquals(0, game.pitch().spells().turns(wizard, spell));
            }
        }
        assertTrue(answer(setup, game, 0, "ACCIO 1\nMOVE 1 2 3").startsWith("line 1 of 2: target: found 1, a wizard"));
    }
}
