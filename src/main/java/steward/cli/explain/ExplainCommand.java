package steward.cli.explain;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.AccuracyOption;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ShippedScenes;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Colour;
import steward.cli.streams.Json;
import steward.game.GameSetup;
import steward.physics.Arithmetic;
import steward.report.Fields;
import steward.scene.Accuracy;
import steward.scene.AccuracyChoice;
import steward.scene.PlanTable;
import steward.scene.Scene;
import steward.text.TextFormat;

/** {@code steward explain}: prints what a scene contains and which parts of the engine it needs. */
@Command(name = "explain", description = "Prints the contents of a scene, and which parts of the engine it needs "
    + "and why.",
    footer = {"", "Examples:", "  steward explain walled-race", "  steward explain my-scene.json --json"})
public final class ExplainCommand extends ProgramCommand {

    private static final int WIDTH = 100;
    private static final String WARNING = "Warning:";

    @Parameters(index = "0", paramLabel = "SCENE", completionCandidates = ShippedScenes.class,
        description = "A file, - for the standard input, or one of ${COMPLETION-CANDIDATES}.")
    private String scene;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    @Option(names = "--json", description = "Prints one JSON object instead: parts, accuracy, warnings.")
    private boolean json;

    @Override
    public Integer call() {
        GameSetup setup = Games.computed(accuracy.open(scene, streams), "explain");
        if (json) {
            Json.print(streams, fields(setup));
            return ExitStatus.DONE;
        }
        PrintStream out = streams.out();
        warnings(out, streams.outColour(), setup.check());
        out.println("Parts of the engine that " + setup.scene().name() + " needs, and those left out:");
        out.println();
        Colour colour = streams.outColour();
        out.print(PlanTable.of(setup.plan(), (part, line) -> {
            String wrapped = TextFormat.wrap(line, ", ", WIDTH, " ".repeat(line.length() - part.why().length()));
            return part.in() ? wrapped : colour.faint(wrapped);
        }));
        out.println();
        AccuracyChoice choice = setup.plan().accuracy();
        out.println(TextFormat.wrap("Accuracy: " + choice.rung() + ", " + choice.why(), " ", WIDTH, "  "));
        if (choice.met().size() > 1) {
            out.println("  rungs that met the demand, with their cost in turns of event/double and their error:");
            choice.met().forEach(line -> out.println("  " + line));
        }
        if (choice.rung().equals(Accuracy.event(Arithmetic.EXACT))) {
            out.println("  its decisions are right within a turn; the state is rounded at its end as on every rung:");
            out.println("  docs/stability.md says after how many impacts a path leaves the true one");
        }
        out.println();
        settings(out, setup.scene());
        return ExitStatus.DONE;
    }

    private static Fields fields(GameSetup setup) {
        AccuracyChoice choice = setup.plan().accuracy();
        Fields accuracy = Fields.of("rung", choice.rung().text(), "stated", choice.stated(), "why", choice.why());
        return Fields.of("scene", setup.scene().name(), "game", setup.scene().gameId(),
            "players", setup.scene().players(), "parts", Fields.each(setup.plan().parts(), part -> Fields.of(
                "name", part.name(), "in", part.in(), "why", part.why(), "when", part.when())),
            "accuracy", choice.met().isEmpty() ? accuracy : accuracy.with("met", choice.met()),
            "warnings", setup.check());
    }

    private static void warnings(PrintStream out, Colour colour, List<String> warnings) {
        for (String warning : warnings) {
            String wrapped = TextFormat.wrap(WARNING + " " + TextFormat.plain(warning), " ", WIDTH, "  ");
            out.println(colour.warning(WARNING) + wrapped.substring(WARNING.length()));
        }
        if (!warnings.isEmpty()) {
            out.println();
        }
    }

    private static void settings(PrintStream out, Scene read) {
        out.println("What the scene says:");
        out.println();
        out.println("  game " + read.gameId() + " for " + TextFormat.count(read.players(), "player"));
        if (read.players() > 0) {
            out.println("  first answer within " + read.time().firstAnswerMs() + " ms, the others within "
                + read.time().answerMs() + " ms");
        }
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
