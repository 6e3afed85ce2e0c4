package steward.replay.feed;

import java.util.function.Consumer;
import java.util.function.IntConsumer;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameTypes;
import steward.match.Protocol;
import steward.numerics.StateHash;
import steward.replay.JsonLine;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Resimulation;

/**
 * Feed that sends a bot all that one player of a recorded match was sent, and compares its answers with the recorded
 * ones. The recorded commands are played, whatever the bot answers.
 */
public final class Feed {

    /** Ending of feeding. */
    public enum Ending {
        /** All turns were sent in which the player was asked, and the end of the match if it has one. */
        WHOLE,
        /** The turn given as the last one was reached; the bot waits for more. */
        STOPPED,
        /** The bot can be asked no more. */
        BOT_GONE
    }

    /** The length of an object without fields: of games in memory no outcomes are kept. */
    private static final int NO_OUTCOME = "{}".length();

    private final RecordedMatch match;
    private final FeedDialogue dialogue;

    /**
     * @param player   counted from 0
     * @param protocol that the bot speaks
     * @param bot      not asked anything yet; finished only if the match comes to its end
     * @throws ReplayException              if the match cannot be played again
     * @throws steward.scene.json.SceneException if its scene cannot be played
     * @throws IllegalArgumentException     if the scene's game does not speak the protocol
     */
    public Feed(RecordedMatch match, GameTypes types, int player, Protocol protocol, Player bot) {
        this(match, new Resimulation(match.header(), match.start(), types, match.source()), player, protocol, bot);
    }

    /**
     * As above, if the scene of the match is open already.
     *
     * @param again of the match, nothing played yet
     */
    public Feed(RecordedMatch match, Resimulation again, int player, Protocol protocol, Player bot) {
        this.match = match;
        dialogue = new FeedDialogue(again, player, protocol, bot, match.header().limits());
    }

    /**
     * Sends the turns.
     *
     * @param until  last turn to be sent
     * @param before is told each turn before it is sent
     * @param after  is told what the bot did
     * @throws ReplayException if the match cannot be played again as it was recorded
     */
    public Ending run(int until, IntConsumer before, Consumer<FedTurn> after) {
        boolean failed = false;
        for (RecordedTurn turn : match.turns()) {
            if (dialogue.isIn() && turn.asked(dialogue.player())) {
                if (turn.number() > until) {
                    return Ending.STOPPED;
                }
                before.accept(turn.number());
                FedTurn fed = dialogue.ask(turn, false);
                after.accept(fed);
                if (fed.gone()) {
                    return Ending.BOT_GONE;
                }
            }
            failed |= turn.faults()[dialogue.player()] != null;
            play(dialogue.again(), turn);
        }
        if (until <= match.lastAsked(dialogue.player())) {
            return Ending.STOPPED;
        }
        if (match.ending() != null && !failed) {
            dialogue.end();
        }
        return Ending.WHOLE;
    }

    /** Plays a recorded turn again. @throws ReplayException if it is another then */
    public static void play(Resimulation again, RecordedTurn turn) {
        requireSame(turn, again.play(turn));
        checkHash(again.game(), turn);
    }

    /** Refuses a turn that cannot be played again. */
    static void requireSame(RecordedTurn turn, ReplayDifference difference) {
        if (difference != null) {
            throw new ReplayException(turn.where() + ": cannot be played again: " + difference);
        }
    }

    /** Refuses a turn whose state differs when played again: the bot would be sent other lines than in the match. */
    static void checkHash(Game game, RecordedTurn turn) {
        if (turn.outcome().length == NO_OUTCOME) {
            return;
        }
        JsonLine outcome = new JsonLine(turn.where(), turn.outcome());
        if (outcome.has("hash") && !outcome.text("hash").equals(StateHash.toHex(game.hash()))) {
            throw new ReplayException(turn.where() + ": turn " + turn.number() + " differs when it is played again: "
                + "what the bot was sent from then on cannot be told");
        }
    }
}
