package steward.lab.cli;

import steward.cli.shared.Lab;
import steward.lab.cli.bench.BenchCommand;

/** The lab's commands as a service that the program finds by {@link java.util.ServiceLoader}. */
public final class LabCommands implements Lab {

    @Override
    public Object command(String name) {
        return switch (name) {
            case "tradeoff" -> new TradeoffCommand();
            case "bench" -> new BenchCommand();
            default -> throw new IllegalArgumentException(name);
        };
    }
}
