package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.bot.process.BotProcess;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;

/**
 * Costs of each level of isolation that works on this machine: from the start of a shell to its first answer, and for
 * each further answer. Levels take turns, so that all see the same machine.
 */
final class SandboxStarts {

    /** Answers after the first. */
    private static final int TURNS = 50;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MS = 1e6;
    private static final double NANOS_PER_MICRO = 1e3;

    private final String section;
    private final List<String> shell;
    private final List<SandboxLevel> levels;

    /** @param shell a program that starts at once and answers every line with one */
    SandboxStarts(String section, List<String> shell) {
        this.section = section;
        this.shell = shell;
        levels = Arrays.stream(SandboxLevel.values()).filter(level -> SandboxSupport.problem(level) == null).toList();
    }

    /** Rounds of which the first third warms up. */
    void run(int rounds, Consumer<String> about, Consumer<Row> rows) {
        int warm = rounds / 3;
        double[][] starts = new double[levels.size()][rounds - warm];
        double[][] turns = new double[levels.size()][rounds - warm];
        for (int round = 0; round < rounds; round++) {
            about.accept("sandboxes");
            for (int k = 0; k < levels.size(); k++) {
                double[] spent = one(levels.get(k));
                if (round >= warm) {
                    starts[k][round - warm] = spent[0];
                    turns[k][round - warm] = spent[1];
                }
            }
        }
        double plain = Meter.median(starts[0]);
        for (int k = 0; k < levels.size(); k++) {
            double start = Meter.median(starts[k]);
            rows.accept(new Row(section, "start of a bot, sandbox " + levels.get(k).word(), "starts", NANOS / start,
                plain / start, Double.NaN, String.format(Locale.ROOT, "%.2f ms, %+.2f against off; then %.0f us a turn",
                start / NANOS_PER_MS, (start - plain) / NANOS_PER_MS, Meter.median(turns[k]) / NANOS_PER_MICRO)));
        }
    }

    /** The time to the first answer, and the mean of the others. */
    private double[] one(SandboxLevel level) {
        byte[] line = {'\n'};
        Answer answer = new Answer();
        List<String> problems = new ArrayList<>();
        try (BotProcess bot = new BotProcess("bot", new Launch(shell, Isolation.at(level), List.of()),
                BotProcess.DEFAULT_GRACE_MS)) {
            long start = System.nanoTime();
            ask(bot, line, answer, problems);
            long first = System.nanoTime();
            for (int turn = 0; turn < TURNS; turn++) {
                ask(bot, line, answer, problems);
            }
            long end = System.nanoTime();
            if (!problems.isEmpty()) {
                throw new IllegalStateException("a bot failed that only answers, at level " + level.word() + ": "
                    + problems.get(0));
            }
            return new double[] {first - start, (end - first) / (double) TURNS};
        }
    }

    private static void ask(Player bot, byte[] line, Answer answer, List<String> problems) {
        if (bot.ask(line, line.length, 1, Long.MAX_VALUE, answer) != Player.Ending.ANSWERED) {
            problems.add(answer.fault() + " " + answer.stderr());
        }
    }
}
