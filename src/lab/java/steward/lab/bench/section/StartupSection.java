package steward.lab.bench.section;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.process.PipeRoundTrip;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;

/** Bench section on start-up: from the program's start to the first line that a bot is sent. */
record StartupSection(MatchFixture fixture) implements Section {

    private static final double NANOS = 1e9;
    private static final double NANOS_PER_MS = 1e6;

    @Override
    public String name() {
        return "start";
    }

    @Override
    public String about() {
        return "From the call of `steward match` to the moment in which a bot, a shell, has its first line and has told"
            + " the time to a file: by the launcher with its archives of classes, and by `java -cp` without.";
    }

    @Override
    public int steps(Effort effort) {
        return effort == Effort.QUICK ? 2 : 20;
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        int rounds = effort == Effort.QUICK ? 2 : 20;
        double[] plain = new double[rounds];
        double[] launched = new double[rounds];
        for (int round = 0; round < rounds; round++) {
            about.accept("round " + (round + 1));
            plain[round] = start(fixture.plain());
            launched[round] = fixture.launcher() == null ? Double.NaN : start(fixture.launcher());
        }
        double one = Meter.median(plain);
        rows.accept(row("java -cp", one, 1));
        if (fixture.launcher() != null) {
            rows.accept(row("launcher", Meter.median(launched), one / Meter.median(launched)));
        }
    }

    private Row row(String how, double nanos, double ratio) {
        return new Row(name(), how, "starts", NANOS / nanos, ratio, Double.NaN,
            String.format(Locale.ROOT, "%.0f ms to the first frame", nanos / NANOS_PER_MS));
    }

    private static double start(List<String> program) throws IOException {
        Path told = Files.createTempFile("steward-bench", ".time");
        try {
            List<String> words = new ArrayList<>(program);
            String bot = "sh -c 'read -r line; date +%s%N >" + told + "'";
            words.addAll(List.of("match", "--bot", "a=" + bot, "--bot", "b=sh -c 'read -r line'", "--seed", "1",
                "--quiet", "--no-deadline"));
            Instant start = Instant.now();
            new PipeRoundTrip(words).close();
            long nanos = Long.parseLong(Files.readString(told).strip());
            return nanos - (TimeUnit.SECONDS.toNanos(start.getEpochSecond()) + start.getNano());
        } catch (NumberFormatException none) {
            throw new IOException("no frame came to a bot, or `date +%s%N` does not tell nanoseconds here", none);
        } finally {
            Files.delete(told);
        }
    }
}
