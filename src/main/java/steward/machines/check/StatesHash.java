package steward.machines.check;

import steward.game.Game;
import steward.numerics.StateHash;

/**
 * Hash of a game's states by which two machines see that they have computed the same game. It covers the start, every
 * 16th turn and the last one. A state that differs in between changes later ones and is noticed at the next of these
 * turns, unless the rules round the difference away before.
 */
final class StatesHash {

    private static final int EVERY = 16;

    private final Game game;
    private final StateHash hash = new StateHash();

    /** @param game not played yet */
    StatesHash(Game game) {
        this.game = game;
        played();
    }

    /** Call after each turn. */
    void played() {
        if (game.turn() % EVERY == 0 || game.isOver()) {
            hash.add(game.hash());
        }
    }

    /** 16 hexadecimal digits. */
    String hex() {
        return StateHash.toHex(hash.value());
    }
}
