package steward.cli.explain;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
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
import steward.json.JsonObject;
import steward.physics.Arithmetic;
import steward.scene.Accuracy;
import steward.scene.AccuracyChoice;
import steward.scene.PlanTable;
import steward.scene.Scene;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

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
            Json.print(streams, out -> write(out, setup));
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
            out.println("  steward stability --case 'true path' counts the impacts until each has left the true path");
        }
        out.println();
        settings(out, setup.scene());
        return ExitStatus.DONE;
    }

    private static void write(JsonGenerator out, GameSetup setup) {
        out.writeStringProperty("scene", setup.scene().name());
        out.writeStringProperty("game", setup.scene().gameId());
        out.writeNumberProperty("players", setup.scene().players());
        JsonObject.writeAll(out, "parts", setup.plan().parts(), part -> {
            out.writeStringProperty("name", part.name());
            out.writeBooleanProperty("in", part.in());
            out.writeStringProperty("why", part.why());
            out.writeStringProperty("when", part.when().name().toLowerCase(Locale.ROOT));
        });
        AccuracyChoice choice = setup.plan().accuracy();
        out.writeObjectPropertyStart("accuracy");
        out.writeStringProperty("rung", choice.rung().text());
        out.writeBooleanProperty("stated", choice.stated());
        out.writeStringProperty("why", choice.why());
        if (!choice.met().isEmpty()) {
            JsonObject.writeTexts(out, "met", choice.met());
        }
        out.writeEndObject();
        JsonObject.writeTexts(out, "warnings", setup.check());
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
