package steward.cli.lab;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.AccuracyOption;
import steward.cli.options.ShippedScenes;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Json;
import steward.cli.shared.Streams;
import steward.game.GameSetup;
import steward.scene.AccuracyChoice;
import steward.scene.PlanTable;
import steward.scene.Scene;
import steward.text.TextFormat;

/** {@code steward explain}: what a scene contains, and which parts of the engine it needs. */
@Command(name = "explain", description = "Prints what a scene says, which parts of the engine it needs and why, and "
    + "what each adds to the time of a turn.",
    footer = {"", "Example:", "  steward explain walled-race"})
public final class ExplainCommand implements Callable<Integer> {

    private static final int WIDTH = 100;

    private final Streams streams;

    @Parameters(index = "0", paramLabel = "SCENE", completionCandidates = ShippedScenes.class,
        description = "A file or one of ${COMPLETION-CANDIDATES}.")
    private String scene;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    @Option(names = "--no-prices", description = "Do not measure what the parts cost, which takes two seconds.")
    private boolean noPrices;

    public ExplainCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        GameSetup setup = accuracy.open(scene);
        PrintStream out = streams.out();
        PriceList prices = noPrices ? null : PriceList.measure(streams, setup);
        out.println("Parts of the engine that " + setup.scene().name() + " needs, and those left out:");
        out.println();
        boolean colours = streams.outTerminal() && Ansi.AUTO.enabled();
        out.print(PlanTable.of(setup.plan(), part -> noPrices ? "" : prices.of(part), (part, line) -> {
            String wrapped = TextFormat.wrap(line, ", ", WIDTH, " ".repeat(line.length() - part.why().length()));
            return colours && !part.in() ? Ansi.ON.string("@|faint " + wrapped + "|@") : wrapped;
        }));
        out.println();
        if (!noPrices) {
            out.println(TextFormat.wrap(prices.legend(), " ", WIDTH, ""));
            out.println();
        }
        AccuracyChoice choice = setup.plan().accuracy();
        out.println(TextFormat.wrap("Accuracy: " + choice.rung() + ", " + choice.why(), " ", WIDTH, "  "));
        out.println();
        settings(out, setup.scene());
        return ExitStatus.DONE;
    }

    private static void settings(PrintStream out, Scene read) {
        out.println("What the scene says:");
        out.println();
        out.println("  game " + read.gameId() + " for " + TextFormat.count(read.players(), "player"));
        out.println("  first answer within " + read.time().firstAnswerMs() + " ms, the others within "
            + read.time().answerMs() + " ms");
        for (Map.Entry<String, Object> block : Json.object(read.json()).entrySet()) {
            if (block.getValue() instanceof Map<?, ?> fields && !block.getKey().equals("time")) {
                List<String> items = new ArrayList<>();
                fields.forEach((name, value) -> items.add(name + " " + word(value)));
                out.println(TextFormat.wrap("  " + block.getKey() + ": " + String.join(", ", items), ", ", WIDTH,
                    "    "));
            }
        }
    }

    private static String word(Object value) {
        if (value instanceof List<?> list) {
            return "(" + list.size() + " of them)";
        }
        return value instanceof Map<?, ?> ? "(more)" : Json.word(value, 9);
    }
}
