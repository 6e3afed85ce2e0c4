package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.BotProcess;
import steward.lab.timing.Stretch;
import steward.lab.timing.TimedPlace;

/**
 * Timing of turns of bots that only answer. A round starts them anew, asks each once, and then times turns, in which
 * the bots are asked one after the other as in a match; the unit is a turn. Without turns it times the start up to the
 * first answer.
 *
 * @param command of the bots; answers every line with one
 * @param bots    how many
 * @param frame   that each is asked
 * @param turns   in a round
 */
record BotTurns(List<String> command, Isolation isolation, int bots, byte[] frame, int turns)
        implements TimedPlace {

    /** Never reached; without a limit nobody is held or watched. */
    private static final long LIMIT = TimeUnit.MINUTES.toNanos(1);

    @Override
    public Stretch round(double least) {
        List<BotProcess> asked = new ArrayList<>();
        try {
            long start = System.nanoTime();
            for (int k = 0; k < bots; k++) {
                asked.add(new BotProcess("bot", new Launch(command, isolation, List.of()),
                    BotProcess.DEFAULT_GRACE_MS));
                ask(asked.get(k));
            }
            long started = System.nanoTime();
            for (int turn = 0; turn < turns; turn++) {
                asked.forEach(this::ask);
            }
            return new Stretch(turns == 0 ? started - start : (System.nanoTime() - started) / (double) turns,
                Double.NaN);
        } finally {
            asked.forEach(BotProcess::close);
        }
    }

    private void ask(Player bot) {
        Answer answer = new Answer();
        if (bot.ask(frame, frame.length, 1, LIMIT, answer) != Player.Ending.ANSWERED) {
            throw new IllegalStateException("a bot failed that only answers, at level " + isolation.level().word()
                + ": " + answer.fault() + " " + answer.stderr());
        }
    }
}
