package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.bot.TimeBasis;
import steward.bot.accounting.TreeSampler;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.BotProcess;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;

/**
 * Costs of a turn where a bot's limits are limits of its CPU time: the time that its processes have used is then looked
 * up before each question. One bot for each basis, asked in turns, so that both see the same machine; at the level of
 * isolation that is usual here.
 */
final class TimeBasisTurns {

    /** Turns of a round. */
    private static final int TURNS = 100;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MICRO = 1e3;

    private final String section;
    private final List<String> responder;
    private final byte[] frame;
    private final List<TimeBasis> bases;

    /**
     * @param responder a program that answers every line with one
     * @param frame     what it is asked
     */
    TimeBasisTurns(String section, List<String> responder, byte[] frame) {
        this.section = section;
        this.responder = responder;
        this.frame = frame;
        bases = TimeBasis.CHOICES.stream()
            .filter(basis -> basis == TimeBasis.WALL || TreeSampler.showsCpuTime()).toList();
    }

    /** Rounds of which the first third warms up. */
    void run(int rounds, Consumer<String> about, Consumer<Row> rows) {
        int warm = rounds / 3;
        double[][] turns = new double[bases.size()][rounds - warm];
        List<BotProcess> bots = new ArrayList<>();
        try {
            for (TimeBasis basis : bases) {
                BotProcess bot = new BotProcess("bot", new Launch(responder, Isolation.usual(), List.of()),
                    BotProcess.DEFAULT_GRACE_MS);
                bot.limitBy(basis);
                bots.add(bot);
                HoldTurns.ask(bot, frame);
            }
            for (int round = 0; round < rounds; round++) {
                about.accept("limits of time");
                for (int k = 0; k < bots.size(); k++) {
                    long start = System.nanoTime();
                    for (int turn = 0; turn < TURNS; turn++) {
                        HoldTurns.ask(bots.get(k), frame);
                    }
                    if (round >= warm) {
                        turns[k][round - warm] = (System.nanoTime() - start) / (double) TURNS;
                    }
                }
            }
        } finally {
            bots.forEach(BotProcess::close);
        }
        double wall = Meter.median(turns[0]);
        for (int k = 0; k < bases.size(); k++) {
            double turn = Meter.median(turns[k]);
            rows.accept(new Row(section, "turn of a bot, --time " + bases.get(k).word(), "turns", NANOS / turn,
                wall / turn, Double.NaN, String.format(Locale.ROOT, "%+.1f us against wall",
                (turn - wall) / NANOS_PER_MICRO)));
        }
    }
}
