package steward.match;

import steward.bot.Answer;
import steward.bot.FaultMessages;
import steward.bot.LineBuffer;
import steward.game.Game;

/**
 * Adapter of a {@link DirectBot} to a player and its dialogue, without lines. Time is measured as for a bot program and
 * the limit applies, but a bot that never returns cannot be stopped.
 */
final class DirectPlayer implements DialoguePlayer, Dialogue {

    private final String name;
    private final DirectBot bot;
    private final LineBuffer noLines = new LineBuffer();
    private Game game;
    private String problem;
    private boolean over;

    DirectPlayer(String name, DirectBot bot) {
        this.name = name;
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
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        if (over) {
            answer.setFault("asked again after its end");
            return Ending.FAULT;
        }
        long start = System.nanoTime();
        if (problem == null) {
            try {
                bot.turn();
            } catch (Throwable thrown) {
                problem = "threw " + thrown;
            }
        }
        answer.setNanos(System.nanoTime() - start);
        if (problem == null && answer.nanos() <= Math.max(1, limitNanos)) {
            return Ending.ANSWERED;
        }
        over = true;
        answer.setFault(problem != null ? problem : FaultMessages.late(Math.max(1, limitNanos), answer.nanos()));
        return Ending.FAULT;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void finish(byte[] lines, int length) {
        boolean polite = !over;
        over = true;
        try {
            if (polite) {
                bot.end();
            }
        } catch (Throwable thrown) {
            // The match is over; an exception of the bot no longer matters.
            return;
        }
    }
}
