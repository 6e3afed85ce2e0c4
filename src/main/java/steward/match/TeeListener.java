package steward.match;

import steward.game.Game;
import steward.game.GameJson;

/**
 * Match listener that passes every call on to two others.
 *
 * @param first  is called first
 * @param second is called only if the first call did not throw
 */
public record TeeListener(MatchListener first, MatchListener second) implements MatchListener {

    @Override
    public void start(Game game, GameJson codec) {
        first.start(game, codec);
        second.start(game, codec);
    }

    @Override
    public void commands(Turn turn) {
        first.commands(turn);
        second.commands(turn);
    }

    @Override
    public void played(Turn turn) {
        first.played(turn);
        second.played(turn);
    }

    @Override
    public void end(MatchResult result) {
        first.end(result);
        second.end(result);
    }
}
