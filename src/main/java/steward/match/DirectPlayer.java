package steward.match;

import steward.bot.Answer;
import steward.bot.FaultMessages;
import steward.bot.Player;
import steward.game.Game;

/**
 * A {@link DirectBot} as a player: it is asked without lines. Time is measured as for a bot program and the limit
 * applies, but a bot that never returns cannot be stopped.
 */
final class DirectPlayer implements Player {

    private final String name;
    private final DirectBot bot;
    private String problem;
    private boolean over;

    DirectPlayer(String name, DirectBot bot) {
        this.name = name;
        this.bot = bot;
    }

    void start(Game game, int player) {
        try {
            bot.start(game, player);
        } catch (Throwable thrown) {
            // Anything a bot throws, errors included, is the bot's failure and not the referee's.
            problem = "threw " + thrown;
        }
    }

    Ending ask(long limitNanos, Answer answer) {
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

    String message() {
        return bot.message();
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        return ask(limitNanos, answer);
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
