package steward.lab.calibration;

import java.nio.charset.StandardCharsets;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.timing.TimedTurns;
import steward.numerics.SplitMix64;

/** One turn of many games whose bodies do not move: only the game's own rules are timed. */
final class RulesOnlyTurns implements TimedTurns {

    /** Fewer turns than players without progress may play. */
    private static final int MOST_TURNS = 16;

    private final GameSetup setup;
    private final Pilot pilot;
    private final SplitMix64 random;
    private final Game[] games;
    private final FrameCodec[] codecs;
    private long seed;

    /** @param pilot {@code null} for games without commands */
    RulesOnlyTurns(GameSetup setup, Pilot pilot, int games, long seed) {
        this.setup = setup;
        this.pilot = pilot;
        this.seed = seed;
        random = new SplitMix64(seed);
        this.games = new Game[games];
        codecs = new FrameCodec[games];
    }

    @Override
    public void prepare() {
        for (int k = 0; k < games.length; k++) {
            if (games[k] == null || games[k].isOver() || games[k].turn() + 1 >= MOST_TURNS) {
                games[k] = setup.create(seed++);
                codecs[k] = setup.codec(games[k]);
            }
            games[k].play();                           // so that its data are in the processor's cache
            for (int player = 0; pilot != null && player < games[k].players(); player++) {
                if (games[k].isIn(player)) {
                    byte[] answer = pilot.answer(games[k], player, random).getBytes(StandardCharsets.UTF_8);
                    codecs[k].frames().readAnswer(player, answer, answer.length);
                }
            }
        }
    }

    @Override
    public void run() {
        for (Game game : games) {
            game.play();
        }
    }

    @Override
    public int turns() {
        return games.length;
    }
}
