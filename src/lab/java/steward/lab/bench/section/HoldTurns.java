package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.BotProcess;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;

/**
 * Cost of a turn where bots are held, at the level of isolation that is usual here: never, burners though there are
 * none, and always, which is a stop and a continue for each answer. In each round every policy has a pair of bots of
 * its own, started anew and asked in turns as in a match; policies take turns, so that all see the same machine. Then
 * with bots that compute for some milliseconds before they answer, always as much, and at last beside busy processes,
 * each in a session of its own.
 */
final class HoldTurns {

    private static final int TURNS = 500;
    /** Of bots that compute, or beside busy processes, a turn takes milliseconds. */
    private static final int SLOW_TURNS = 20;
    /** Counts up for some 10 ms: long enough that the one that waits meanwhile is looked at. */
    private static final List<String> SEARCHING = List.of("sh", "-c", "while read -r l; do k=0; while [ $k -lt 5000 ];"
        + " do k=$((k + 1)); done; echo; done");
    private static final int HOGS = 16;
    /** Never reached; without limits nobody is held, and the watchdog has nothing to watch. */
    private static final long LIMIT = TimeUnit.MINUTES.toNanos(1);
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MICRO = 1e3;
    private static final List<String> BUSY = List.of("sh", "-c", "read -r l; k=0; while [ $k -lt " + HOGS
        + " ]; do k=$((k + 1)); setsid sh -c 'while :; do :; done' >/dev/null & done; echo; read -r l");

    private final String section;
    private final List<String> responder;
    private final byte[] frame;
    private final List<HoldPolicy> policies = List.of(HoldPolicy.NEVER, HoldPolicy.BURNERS, HoldPolicy.ALWAYS);

    /**
     * @param responder a program that answers every line with one
     * @param frame     what it is asked
     */
    HoldTurns(String section, List<String> responder, byte[] frame) {
        this.section = section;
        this.responder = responder;
        this.frame = frame;
    }

    /** Rounds of which the first third warms up. */
    void run(int rounds, Consumer<String> about, Consumer<Row> rows) {
        if (HoldMeans.of(Isolation.usual()) != HoldMeans.INIT) {
            return;
        }
        measure(responder, rounds, TURNS, "", about, rows);
        measure(SEARCHING, rounds / 2, SLOW_TURNS, " of bots that compute", about, rows);
        try (BotProcess hogs = new BotProcess("hogs", new Launch(BUSY, Isolation.usual().holding(HoldPolicy.NEVER),
                List.of()), BotProcess.DEFAULT_GRACE_MS)) {
            ask(hogs, frame);
            measure(responder, Math.max(2, rounds / 10), SLOW_TURNS, ", beside " + HOGS + " busy processes", about,
                rows);
        }
    }

    private void measure(List<String> command, int rounds, int turns, String where, Consumer<String> about,
                         Consumer<Row> rows) {
        int warm = rounds / 3;
        double[][] spent = new double[policies.size()][rounds - warm];
        for (int round = 0; round < rounds; round++) {
            about.accept("holding" + where);
            for (int k = 0; k < policies.size(); k++) {
                double turn = turn(command, policies.get(k), turns);
                if (round >= warm) {
                    spent[k][round - warm] = turn;
                }
            }
        }
        double never = Meter.median(spent[0]);
        for (int k = 0; k < policies.size(); k++) {
            double[] ratios = Meter.ratios(spent[k], spent[0], rounds - warm);
            double turn = Meter.median(spent[k]);
            rows.accept(new Row(section, "a turn, --hold " + policies.get(k).word() + where, "turns", NANOS / turn,
                never / turn, Double.NaN, k == 0 ? "" : String.format(Locale.ROOT, "%.3f times never (median of pairs);"
                    + " %+.1f us for a bot and turn", Meter.median(ratios), (turn - never) / 2 / NANOS_PER_MICRO)));
        }
    }

    /** The mean of the turns of one pair of bots, in nanoseconds. */
    private double turn(List<String> command, HoldPolicy policy, int turns) {
        List<BotProcess> bots = new ArrayList<>();
        try {
            for (int k = 0; k < 2; k++) {
                bots.add(new BotProcess("bot", new Launch(command, Isolation.usual().holding(policy), List.of()),
                    BotProcess.DEFAULT_GRACE_MS));
                ask(bots.get(k), frame);
            }
            long start = System.nanoTime();
            for (int turn = 0; turn < turns; turn++) {
                ask(bots.get(0), frame);
                ask(bots.get(1), frame);
            }
            return (System.nanoTime() - start) / (double) turns;
        } finally {
            bots.forEach(BotProcess::close);
        }
    }

    static void ask(Player bot, byte... frame) {
        Answer answer = new Answer();
        if (bot.ask(frame, frame.length, 1, LIMIT, answer) != Player.Ending.ANSWERED) {
            throw new IllegalStateException("a bot failed that only answers: " + answer.fault() + " "
                + answer.stderr());
        }
    }
}
