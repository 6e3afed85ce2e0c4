package steward.lab.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import steward.bot.InProcessPlayer;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ThreadsOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.RunProgress;
import steward.files.OutputFiles;
import steward.lab.capacity.Capacity;
import steward.lab.capacity.CapacityText;
import steward.lab.capacity.CheckPrices;
import steward.lab.capacity.LeagueCosts;
import steward.lab.capacity.MeasuredBots;
import steward.lab.capacity.MeasuredLeague;
import steward.lab.capacity.MeasuredLeague.Sample;
import steward.lab.capacity.SaturationTable;
import steward.lab.cli.bench.BenchDirectBot;
import steward.lab.cli.bench.BenchLineBot;
import steward.lab.timing.Machine;
import steward.machines.serve.RemoteGames;
import steward.match.Seat;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/** {@code steward league capacity}: what workers cost a league's process, and how many it could serve. */
@Command(name = "capacity", description = "Measures what workers cost a league's process on this machine, and "
    + "simulates with how many of them it has no time left.",
    footer = {"",
        "Plays a league of bots inside the process, by itself and with a worker that joins",
        "it by TLS as all do, and prints CPU times as they stand in the documentation.",
        "", "Examples:", "  steward league capacity", "  steward league capacity --workers 100 --rate 2",
        "", "Exit status: 0 done; 1 nothing was played, as the machine is too busy; 2 the",
        "call is unusable; 130 interrupted."})
final class CapacityCommand extends ProgramCommand {

    private static final String SCENE = "mad-pod-racing";
    private static final int MOST_WORKERS = 100_000;
    private static final int MOST_RATE = 1000;
    /** Games in a second that are played to be measured, and at which the overhead is told. */
    private static final double PACE = 200;
    private static final int SLOTS = 4;
    /** How often both leagues are measured, in turn: each has a median. */
    private static final int ROUNDS = 3;
    /** Seconds before a league is measured that is not the first of its kind: what it needs is compiled. */
    private static final double LATER_WARM = 10;

    /** Share of the processors that others may take while figures mean something. */
    private static final double MOST_BUSY = 0.2;

    @Option(names = "--workers", paramLabel = "N", defaultValue = "1000", description = "Up to so many workers are "
        + "simulated (default: ${DEFAULT-VALUE}).")
    private int workers;

    @Option(names = "--rate", paramLabel = "N", defaultValue = "20", description = "Games that one of them plays in a "
        + "second (default: ${DEFAULT-VALUE}).")
    private int rate;

    @Option(names = "--quick", description = "Measures for a short time: rough figures that may not be quoted.")
    private boolean quick;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        check.range("--workers", workers, 1, MOST_WORKERS);
        check.range("--rate", rate, 1, MOST_RATE);
        double warm = quick ? 2 : 60;
        double seconds = quick ? 1 : 15;
        int rounds = quick ? 1 : ROUNDS;
        double later = LATER_WARM + seconds;
        double busy = ThreadsOption.loadOfOthers();
        if (busy > MOST_BUSY) {
            streams.warn("other programs keep " + TextFormat.fixed(100 * busy, 0) + "% of the processors busy: the "
                + "figures are too high, and how many games were reached too low; measure on a quiet machine");
        }
        RunProgress progress = new RunProgress(streams, Stream.of(Stream.generate(() -> warm + seconds).limit(2),
            Stream.generate(() -> later).limit(2L * rounds - 2), Stream.of(4 * seconds, 10.0))
            .flatMap(parts -> parts).toList());
        if (!json) {
            ProgressLine.announce(streams, TextFormat.about(progress.total()), "prints nothing");
        }
        Capacity capacity;
        Path folder = temporary();
        try (Interruption interruption = new Interruption(streams, () -> {
            delete(folder);
            return "nothing is printed";
        })) {
            capacity = measure(new MeasuredLeague(bots(), folder), new MeasuredLeague.Effort(PACE, warm, seconds,
                SLOTS), rounds, progress);
            interruption.over();
        } catch (IOException problem) {
            throw unusable(folder, problem);
        } catch (MeasuredLeague.NoGameException none) {
            throw new FailedException(none.getMessage());
        } finally {
            delete(folder);
        }
        if (json) {
            Json.print(streams, out -> write(out, capacity));
        } else {
            CapacityText.of(capacity, LocalDate.now(ZoneOffset.UTC) + ", " + Machine.line()
                + (quick ? ", measured roughly" : "") + (busy > MOST_BUSY ? ", while other programs kept "
                    + TextFormat.fixed(100 * busy, 0) + "% of the processors busy: of no use" : ""))
                .forEach(streams.out()::println);
        }
        return ExitStatus.DONE;
    }

    private static MeasuredBots bots() {
        return new MeasuredBots(Games.types(), Games.open(SCENE),
            (entrant, isolation, others) -> Seat.direct(entrant.name(), new BenchDirectBot()).player(),
            (entrant, isolation, others) -> new InProcessPlayer(entrant.name(), new BenchLineBot()),
            number -> "builtin:regular 3 0." + number);
    }

    private Capacity measure(MeasuredLeague league, MeasuredLeague.Effort effort, int rounds, RunProgress progress)
            throws InterruptedException, IOException {
        List<Sample> alone = new ArrayList<>();
        List<Sample> served = new ArrayList<>();
        for (int round = 0; round < rounds; round++) {
            MeasuredLeague.Effort now = round == 0 ? effort
                : new MeasuredLeague.Effort(effort.perSecond(), LATER_WARM, effort.seconds(), effort.slots());
            progress.begin("a league by itself");
            alone.add(league.measure(false, now));
            progress.end();
            progress.begin("with a worker");
            served.add(league.measure(true, now));
            progress.end();
        }
        progress.begin("checks");
        CheckPrices prices = CheckPrices.measure(bots(), effort.seconds());
        progress.end();
        progress.begin("simulation");
        LeagueCosts costs = Capacity.costs(median(served), prices);
        SaturationTable table = SaturationTable.of(costs, Runtime.getRuntime().availableProcessors(), workers, rate,
            RemoteGames.MOST, progress.steps(SaturationTable.steps(workers)));
        progress.end();
        return new Capacity(PACE, rounds, median(alone), median(served), prices, table);
    }

    private static Sample median(List<Sample> samples) {
        return samples.stream().sorted(Comparator.comparingDouble(Sample::threads)).toList().get(samples.size() / 2);
    }

    private static void write(JsonGenerator out, Capacity capacity) {
        LeagueCosts costs = capacity.table().costs();
        out.writeStringProperty("machine", Machine.line());
        out.writeNumberProperty("gamesPerSecond", capacity.rate());
        out.writeObjectPropertyStart("microseconds");
        out.writeNumberProperty("broker", costs.broker());
        out.writeNumberProperty("messages", costs.messages());
        out.writeNumberProperty("check", costs.check());
        out.writeNumberProperty("again", costs.again());
        out.writeNumberProperty("shareAgain", costs.share());
        out.writeNumberProperty("schedule", costs.schedule());
        out.writeNumberProperty("store", costs.store());
        out.writeNumberProperty("alone", capacity.alone().threads());
        out.writeNumberProperty("served", capacity.served().threads());
        out.writeEndObject();
        out.writeArrayPropertyStart("simulated");
        capacity.table().rows().forEach(row -> write(out, row));
        write(out, capacity.table().last());
        capacity.table().larger().forEach(row -> write(out, row));
        out.writeEndArray();
    }

    private static void write(JsonGenerator out, SaturationTable.Row row) {
        out.writeStartObject();
        out.writeNumberProperty("processors", row.processors());
        out.writeNumberProperty("workers", row.workers());
        out.writeNumberProperty("offered", row.offered());
        out.writeNumberProperty("games", row.load().perSecond());
        out.writeNumberProperty("processorsBusy", row.load().processors());
        out.writeNumberProperty("messagesBusy", row.load().messages());
        out.writeNumberProperty("scheduleBusy", row.load().schedule());
        out.writeNumberProperty("storeBusy", row.load().store());
        out.writeNumberProperty("workersBusy", row.load().workers());
        out.writeNumberProperty("waitMs", row.load().delayMs());
        out.writeStringProperty("noTimeLeft", row.first().words());
        out.writeEndObject();
    }

    private static Path temporary() {
        try {
            return Files.createTempDirectory("steward-capacity");
        } catch (IOException problem) {
            throw unusable(Path.of(System.getProperty("java.io.tmpdir")), problem);
        }
    }

    private static FailedException unusable(Path folder, IOException problem) {
        return new FailedException(folder + ": " + OutputFiles.reason(folder, problem)
            + ", expected a folder for temporary files that can be written");
    }

    private static void delete(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
        } catch (IOException stays) {
            return;
        }
    }
}
