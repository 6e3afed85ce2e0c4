package steward.match;

import steward.bot.Player;
import steward.game.Game;

/** A player with a dialogue of its own, in whatever protocol its seat is. */
public interface DialoguePlayer extends Player {

    /** The dialogue in a game that is about to begin. */
    Dialogue in(Game game);
}
