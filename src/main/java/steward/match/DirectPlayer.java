package steward.match;

import steward.bot.Answer;
import steward.bot.InProcessPlayer;
import steward.bot.LineBuffer;
import steward.game.Game;

/**
 * Adapter of a {@link DirectBot} to a player and its dialogue, without lines. Time is measured as for a bot program and
 * the limit applies, but a bot that never returns cannot be stopped.
 */
final class DirectPlayer extends InProcessPlayer implements DialoguePlayer, Dialogue {

    private final DirectBot bot;
    private final LineBuffer noLines = new LineBuffer();
    private Game game;
    private String problem;

    DirectPlayer(String name, DirectBot bot) {
        super(name, null);
        this.bot = bot;
    }

    @Override
    public Dialogue in(Game played) {
        game = played;
        return this;
    }

    @Override
    public boolean mayBlock() {
        return false;
    }

    @Override
    public LineBuffer setup(int player) {
        try {
            bot.start(game, player);
        } catch (Throwable thrown) {
            // Anything a bot throws, errors included, is the bot's failure and not the referee's.
            problem = "threw " + thrown;
        }
        return noLines;
    }

    @Override
    public LineBuffer turn(int player) {
        return noLines;
    }

    @Override
    public LineBuffer end(int player) {
        return noLines;
    }

    @Override
    public int answerLines(int player) {
        return 1;
    }

    /** The bot has given its commands to the game. */
    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return null;
    }

    @Override
    public String message(int player) {
        return bot.message();
    }

    @Override
    protected String played(byte[] frame, int length, int answerLines, Answer answer) {
        if (problem == null) {
            bot.turn();
        }
        return problem;
    }

    @Override
    protected void end(byte[] lines, int length) {
        bot.end();
    }

    /** Tells the bot of the end also if the match is broken off. */
    @Override
    public void close() {
        finish(noLines.bytes(), 0);
    }
}
