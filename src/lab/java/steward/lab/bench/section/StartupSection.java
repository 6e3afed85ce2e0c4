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
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.Stretch;
import steward.text.TextFormat;

/** Bench section on start-up: from the program's start to the first line that a bot is sent. */
public record StartupSection(MatchFixture fixture) implements Section {

    private static final int ROUNDS = 20;

    @Override
    public String name() {
        return "start";
    }

    @Override
    public String about() {
        return "The time from the call of `steward match` to the first line of a bot, a shell that then writes the"
            + " time to a file. The launcher has archives of classes; `java -cp` starts without them.";
    }

    @Override
    public int steps(Effort effort) {
        return effort.rounds(ROUNDS).steps(2);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        List<Contender> contenders = new ArrayList<>();
        contenders.add(new Contender("java -cp", least -> start(fixture.plain())));
        if (fixture.launcher() != null) {
            contenders.add(new Contender("launcher", least -> start(fixture.launcher())));
        }
        new Comparison(name(), "starts", contenders, (samples, k) ->
            String.format(Locale.ROOT, "%.0f ms to the first frame", samples.median(k) / TextFormat.NANOS_PER_MS))
            .run(effort.rounds(ROUNDS), step, rows);
    }

    private static Stretch start(List<String> program) throws IOException {
        Path told = Files.createTempFile("steward-bench", ".time");
        try {
            List<String> words = new ArrayList<>(program);
            String bot = "sh -c 'read -r line; date +%s%N >" + told + "'";
            words.addAll(List.of("match", "--bot", "a=" + bot, "--bot", "b=sh -c 'read -r line'", "--seed", "1",
                "--quiet", "--no-deadline"));
            Instant start = Instant.now();
            new PipeRoundTrip(words).close();
            long nanos = Long.parseLong(Files.readString(told).strip());
            return new Stretch(nanos - (TimeUnit.SECONDS.toNanos(start.getEpochSecond()) + start.getNano()),
                Double.NaN);
        } catch (NumberFormatException none) {
            throw new IOException("no frame came to a bot, or `date +%s%N` does not tell nanoseconds here", none);
        } finally {
            Files.delete(told);
        }
    }
}
