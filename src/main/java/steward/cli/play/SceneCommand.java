package steward.cli.play;

import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.CallCheck;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ShippedScenes;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.files.Resources;
import steward.game.GameType;
import steward.guest.GuestType;
import steward.report.Fields;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.text.TextFormat;

/** {@code steward scene}: lists and prints the scenes that come with the program. */
@Command(name = "scene", description = "Prints a scene that comes with the program; without a name, all names.",
    footer = {"", "Examples:", "  steward scene", "  steward scene walled-race > my-scene.json",
        "  steward scene --schema > scene.schema.json",
        "", "--json: scenes (name, game, players, about)."})
public final class SceneCommand extends ProgramCommand {

    @Parameters(index = "0", arity = "0..1", paramLabel = "NAME", completionCandidates = ShippedScenes.class,
        description = "One of ${COMPLETION-CANDIDATES}.")
    private String name;

    @Option(names = "--schema", description = "Prints the JSON Schema (2020-12) of scenes instead; with the name "
        + "guest, of scenes with their own referee.")
    private boolean schema;

    @Option(names = "--json", description = "Prints all names in one JSON object; see below.")
    private boolean json;

    @Override
    public Integer call() {
        CallCheck.withHelp().that(!json || name == null && !schema, "--json: expected no NAME and no --schema with it");
        if (json) {
            Json.print(streams, Fields.of("scenes", Fields.each(SceneFiles.shipped(), each -> {
                Scene scene = Games.open(each).scene();
                return Fields.of("name", each, "game", scene.gameId(), "players", scene.players(),
                    "about", about(each));
            })));
        } else if (schema) {
            String game = name == null ? Games.types().types().get(0).id() : name.equals(GuestType.ID) ? name
                : Games.types().open(SceneFiles.shipped(name).text(), name).scene().gameId();
            streams.out().print(schema(game));
        } else if (name != null) {
            streams.out().print(SceneFiles.shipped(name).text());
        } else {
            List<String> names = SceneFiles.shipped();
            int width = names.stream().mapToInt(String::length).max().orElse(0);
            for (String each : names) {
                streams.out().println(TextFormat.left(each, width) + "  " + about(each));
            }
        }
        return ExitStatus.DONE;
    }

    /** Describes a shipped scene in one line; the README says the same. */
    static String about(String scene) {
        return switch (scene) {
            case "mad-pod-racing" -> "the official rules and maps, two players with two pods";
            case "mad-pod-racing-silver" -> "the same with one pod each and a thrust of at most 100";
            case "walled-race" -> "the race between walls that bounce, with immovable bumpers";
            case "duel" -> "one pod each on a small map: over in seconds, good for trying things";
            default -> Games.about(scene);
        };
    }

    /** Every {@link GameType} of the program has one among its resources. */
    private static String schema(String game) {
        return Resources.text("/steward/schemas/" + game + ".json");
    }
}
