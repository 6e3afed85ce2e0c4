package steward.lab.cli;

import java.util.List;
import java.util.function.Consumer;
import steward.cli.shared.Games;
import steward.cli.shared.Lab;
import steward.cli.streams.ProgressLine;
import steward.cli.streams.Streams;
import steward.game.GameSetup;
import steward.lab.calibration.PartPrices;
import steward.lab.cli.bench.BenchCommand;
import steward.lab.statistics.SelfCheck;
import steward.lab.timing.Timing;
import steward.lab.timing.TimingEffort;
import steward.scene.price.MeasuredPrices;

/** The lab as the program sees it, found by {@link java.util.ServiceLoader}. */
public final class LabCommands implements Lab {

    @Override
    public Object command(String name) {
        return switch (name) {
            case "stability" -> new StabilityCommand();
            case "tradeoff" -> new TradeoffCommand();
            case "bench" -> new BenchCommand();
            case "league capacity" -> new CapacityCommand();
            default -> throw new IllegalArgumentException(name);
        };
    }

    @Override
    public MeasuredPrices measurePrices(Streams streams, GameSetup setup) {
        return measurePrices(streams, setup, Timing.inJvms(TimingEffort.SOON, TimingMain.class));
    }

    static MeasuredPrices measurePrices(Streams streams, GameSetup setup, Timing timing) {
        PartPrices parts = new PartPrices(setup.scene(), Games.types());
        try (ProgressLine progress = ProgressLine.watched(streams, "measuring", timing.steps(parts.jobs()))) {
            return parts.measure(timing, progress::step);
        }
    }

    @Override
    public void selfCheck(List<String> parts, long leagues, int threads, Consumer<String> out)
            throws InterruptedException {
        SelfCheck tables = new SelfCheck(leagues, threads, out);
        for (String part : parts) {
            tables.print(part);
        }
    }
}
