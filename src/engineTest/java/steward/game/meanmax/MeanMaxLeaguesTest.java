package steward.game.meanmax;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.game.CodecText;
import steward.game.GameSetup;
import steward.match.TestScenes;

/**
 * The lower leagues of Mean Max: version 0 of the published referee has reapers and wrecks alone, version 1 destroyers
 * and tankers too, version 2 doofs, rage and grenades too. The numbers are those of its switches; whole games of it are
 * compared by {@link MeanMaxVectorsTest}, whose matches may state a version.
 */
class MeanMaxLeaguesTest {

    private static final int SEED = 4;

    private static GameSetup league(int version) {
        return TestScenes.changed("mean-max", "\"winningScore\":", "\"version\": " + version + ", \"winningScore\":");
    }

    private static MeanMax game(int version) {
        return (MeanMax) league(version).create(SEED);
    }

    private static String answer(GameSetup setup, MeanMax game, int player, String answer) {
        return CodecText.read(setup.textCodec(game).orElseThrow(), player, answer);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 2", "2, 3", "3, 3"})
    void everyPlayerHasTheLootersOfTheLeague(int version, int looters) {
        MeanMax game = game(version);
        int count = 0;
        for (int unit = 0; unit < game.bodies().size(); unit++) {
            count += game.world().isTanker(unit) ? 0 : 1;
        }
        assertEquals(3 * looters, count);
        assertEquals(2, game.playerOf(3 * looters - 1));
        assertEquals(-1, game.playerOf(3 * looters));
    }

    /** Wrecks stand at 3000 u from the centre, with as much water as the tanker in whose place they come is large. */
    @Test
    void wrecksComeInPlaceOfTankers() {
        MeanMax game = game(0);
        MeanMax whole = game(3);
        assertEquals(3, game.bodies().size());
        assertEquals(whole.bodies().size() - 9, game.world().wrecks().size());
        int k = 0;
        for (Wreck wreck : game.world().wrecks()) {
            assertEquals(3000, Math.hypot(wreck.x(), wreck.y()), 1e-9);
            assertEquals(whole.bodies().columns[MeanMaxWorld.SIZE][9 + k++], wreck.water());
            assertEquals(400 + 50 * wreck.water(), wreck.radius());
        }
    }

    /** A reaper that stands in a wreck takes one water a turn; the next one of its player then comes. */
    @Test
    void anotherWreckComesForOneThatIsEmpty() {
        MeanMax game = game(0);
        Wreck first = game.world().wrecks().get(0);
        int water = first.water();
        int player = first.player();
        int id = first.id();
        int wrecks = game.world().wrecks().size();
        int left = game.world().queue().left(player);
        int next = game.world().queue().size(player);
        for (int turn = 0; turn < water; turn++) {
            game.bodies().setPosition(0, Math.rint(first.x()), Math.rint(first.y()));
            game.bodies().setVelocity(0, 0, 0);
            game.play();
        }
        assertEquals(water, game.score(0));
        assertEquals(wrecks, game.world().wrecks().size());
        assertEquals(0, game.world().wrecks().stream().filter(wreck -> wreck.id() == id).count());
        Wreck last = game.world().wrecks().get(wrecks - 1);
        assertEquals(List.of(player, next, left - 1),
            List.of(last.player(), last.water(), game.world().queue().left(player)));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0", "2, 1", "3, 1"})
    void rageComesWithDoofs(int version, int least) {
        GameSetup setup = league(version);
        MeanMax game = (MeanMax) setup.create(SEED);
        for (int turn = 0; turn < 5; turn++) {
            for (int player = 0; player < 3; player++) {
                assertNull(answer(setup, game, player, "WAIT\nWAIT\n0 0 300"));
            }
            game.play();
        }
        assertEquals(least, Math.min(1, game.rage(0)));
    }

    /** A skill that the league does not have is a wait, not a fault; of version 2 the grenade alone is one. */
    @ParameterizedTest
    @CsvSource({"2, 0, 0", "2, 1, 1", "2, 2, 0", "3, 0, 1", "3, 1, 1", "3, 2, 1"})
    void aSkillThatTheLeagueDoesNotHaveIsAWait(int version, int looter, int effects) {
        GameSetup setup = league(version);
        MeanMax drawn = (MeanMax) setup.create(SEED);
        MeanMax game = MeanMaxWorlds.game(drawn, drawn.world().copy(), new int[3], new int[] {100, 100, 100});
        int self = game.world().looter(0, looter);
        String skill = "SKILL " + (int) game.bodies().x[self] + " " + (int) game.bodies().y[self];
        assertNull(answer(setup, game, 0, (looter == 0 ? skill : "WAIT") + "\n" + (looter == 1 ? skill : "WAIT") + "\n"
            + (looter == 2 ? skill : "WAIT")));
        int next = game.bodies().nextId();
        game.play();
        assertEquals(effects, game.bodies().nextId() > next ? 1 : 0, "an effect takes an id");
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 2"})
    void linesOfLootersThatAreNotThereAreNotRead(int version, int looters) {
        GameSetup setup = league(version);
        MeanMax game = (MeanMax) setup.create(SEED);
        assertNull(answer(setup, game, 0, looters == 1 ? "1 2 3\nnonsense\n" : "1 2 3\nWAIT\nnonsense"));
        assertEquals(LooterCommand.WAIT, game.command(0, 2));
        assertTrue(answer(setup, game, 1, looters == 1 ? "nonsense\nWAIT\nWAIT" : "WAIT\nnonsense\nWAIT")
            .startsWith("line " + looters + " of 3: found \"nonsense\""));
        game.play();
        assertNotEquals(0, game.turn());
    }

    /** Order of the emptied wrecks is part of the state: hashes tell owners apart. */
    @Test
    void forWhomAWreckStandsIsPartOfTheStateWhereAnotherFollowsIt() {
        for (int version : new int[] {0, 3}) {
            MeanMaxSettings settings = new MeanMaxSettings(50, 200, version);
            long[] hashes = new long[2];
            for (int player = 0; player < 2; player++) {
                MeanMaxWorld world = MeanMaxWorlds.empty(settings, SEED, 9);
                world.addWreck(30, 0, 0, 600, 4, player);
                hashes[player] = MeanMaxWorlds.game(game(version), world, new int[3], new int[3]).hash();
            }
            assertEquals(version == 0, hashes[0] != hashes[1]);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "4", "1.5", "\"0\""})
    void otherVersionsAreRefused(String version) {
        String message = assertThrows(RuntimeException.class,
            () -> TestScenes.changed("mean-max", "\"winningScore\":", "\"version\": " + version
                + ", \"winningScore\":")).getMessage();
        assertTrue(message.contains("harvest.version") && message.contains("expected a whole number 0..3"), message);
    }
}
