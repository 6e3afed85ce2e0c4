package steward.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code steward tradeoff}: what each rung of accuracy costs, and how far it is from the truth. */
@Command(name = "tradeoff", description = "Measures what each rung of accuracy costs and how far it is from the truth.")
final class TradeoffCommand implements Callable<Integer> {

    private final Streams streams;

    @Option(names = "--scene", paramLabel = "F", description = "Only this scene; can be repeated.")
    private List<String> scenes = new ArrayList<>();

    TradeoffCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        throw new InputException("tradeoff: found no measuring yet, expected --calibrate");
    }
}
