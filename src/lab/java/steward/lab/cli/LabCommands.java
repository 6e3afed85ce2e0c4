package steward.lab.cli;

import java.util.List;
import java.util.function.Consumer;
import steward.cli.shared.Lab;
import steward.lab.cli.bench.BenchCommand;
import steward.lab.statistics.SelfCheck;

/** The lab as the program sees it, found by {@link java.util.ServiceLoader}. */
public final class LabCommands implements Lab {

    @Override
    public Object command(String name) {
        return switch (name) {
            case "stability" -> new StabilityCommand();
            case "tradeoff" -> new TradeoffCommand();
            case "bench" -> new BenchCommand();
            default -> throw new IllegalArgumentException(name);
        };
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
