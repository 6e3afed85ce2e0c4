package steward.minigame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.calibration.Calibration;
import steward.lab.calibration.SeededPlay;
import steward.lab.timing.RungJob;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.lab.timing.WorkTimer;
import steward.numerics.SplitMix64;
import steward.scene.json.SceneException;

/** Needs of a second game that the first game could do without: tried on the pond. */
class PondSeamTest {

    private static final GameSetup POND = MiniScenes.pond();

    /** Times in this JVM. */
    private static final Timing<RungJob> HERE = new Timing<>(new TimingEffort(1, 1, 0, 0, 0),
        job -> new WorkTimer(job.open(POND.physics())));

    private static void command(GameSetup setup, Game game, SplitMix64 random) {
        for (int player = 0; player < game.players(); player++) {
            byte[] line = setup.pilot(Pilot.Aim.WIN).answer(game, player, random).getBytes();
            assertEquals(null, setup.codec(game).readAnswer(player, line, line.length));
        }
    }

    @Test
    void aCopyGoesOnAlikeAndIndependently() {
        Game game = POND.create(3);
        for (int turn = 0; turn < 10; turn++) {
            command(POND, game, new SplitMix64(turn));
            game.play();
        }
        Game copy = game.copy();
        assertNotSame(game.bodies(), copy.bodies());
        assertEquals(game.hash(), copy.hash());
        for (int turn = 10; turn < 20 && !game.isOver(); turn++) {
            long before = copy.hash();
            command(POND, game, new SplitMix64(turn));
            game.play();
            assertEquals(before, copy.hash(), "the copy stays as it was");
            command(POND, copy, new SplitMix64(turn));
            copy.play();
            assertEquals(game.hash(), copy.hash());
            assertEquals(game.log().impacts(), copy.log().impacts());
        }
    }

    /** Contacts that ask are measured with the reaction that the setup offers for it. */
    @Test
    void aGameWithReactionsIsCalibrated() throws InterruptedException {
        Calibration calibration = new Calibration(POND,
            seed -> new SeededPlay(POND, POND.pilot(Pilot.Aim.WIN), seed), 5);
        calibration.time(HERE, () -> { });
        calibration.run(1, () -> { });
        assertEquals(5, calibration.figures().states());
    }

    @Test
    void aSceneForAnotherNumberOfPlayersIsRefused() {
        assertEquals("pond.json:1:1: players: found 1, expected 2..16, as many as pond is for",
            assertThrows(SceneException.class, () -> MiniScenes.pond("\"players\": 3", "\"players\": 1"))
                .getMessage().replaceFirst(":[0-9]+:[0-9]+:", ":1:1:"));
    }
}
