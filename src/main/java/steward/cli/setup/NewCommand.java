package steward.cli.setup;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.CommandLine;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ProtocolWord;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.match.Protocol;
import steward.scene.SceneFiles;
import steward.text.NearestName;

/** {@code steward new}: writes a bot to start from. */
@Command(name = "new", description = "Writes a commented bot to start from, which races at once, into a new or empty "
    + "folder, and prints how to run it.",
    footer = {"", "Examples:", "  steward new python mybot", "  steward new python mybot --protocol codingame",
        "  steward new cpp mybot --simulator",
        "", "Exit status: 0 written; 2 the folder is not empty, or cannot be written into."})
public final class NewCommand extends ProgramCommand {

    @Parameters(index = "0", paramLabel = "LANGUAGE", completionCandidates = Languages.class,
        description = "One of ${COMPLETION-CANDIDATES}.")
    private String language;

    @Parameters(index = "1", paramLabel = "DIR", description = "The folder; made if it is not there.")
    private String folder;

    @Option(names = "--game", paramLabel = "GAME", defaultValue = Games.FIRST, completionCandidates = GameIds.class,
        description = "The game that it plays, one of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private String game;

    @Option(names = "--protocol", paramLabel = "P", completionCandidates = ProtocolWord.Candidates.class,
        description = "What it speaks, json or codingame (default: JSON in python, CodinGame's lines in the others).")
    private String protocol;

    @Option(names = "--simulator", description = "Writes, in cpp for the pod race, a bot that searches, with "
        + "steward_podrace.hpp: the official turn to the last bit, in one header.")
    private boolean simulator;

    /** The games that have bots to start from. */
    static final class GameIds implements Iterable<String> {

        static List<String> all() {
            return Games.ids().stream().filter(game -> !Starter.languages(game).isEmpty()).toList();
        }

        @Override
        public Iterator<String> iterator() {
            return all().iterator();
        }
    }

    /** The words for the languages. */
    static final class Languages implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Starter.languages(Games.FIRST).iterator();
        }
    }

    @Override
    public Integer call() {
        Starter starter = starter();
        Path path = OutputFiles.path(folder);
        refuseUnlessEmpty(path);
        try {
            Files.createDirectories(path);
            for (String file : starter.files()) {
                Files.write(path.resolve(file), starter.read(game, file));
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be written into: " + OutputFiles.reason(path, problem));
        }
        streams.out().println("Written: " + path.resolve(starter.files().get(0)) + ". It speaks "
            + (starter.protocol() == Protocol.CODINGAME ? "CodinGame's lines" : "JSON") + ". To race it:");
        streams.out().println("  cd " + CommandLine.quote(List.of(folder)));
        starter.compile().forEach(command -> streams.out().println("  " + command));
        String bot = " --bot " + CommandLine.quote(List.of("me=" + starter.bot()));
        streams.out().println("  steward match" + (game.equals(Games.FIRST) ? bot + " --bot builtin:racer"
            : " --scene " + scene() + bot.repeat(Games.open(scene()).scene().players())));
        return ExitStatus.DONE;
    }

    /** Finds what is asked for; refusals name only what there is for the game. */
    private Starter starter() {
        List<String> games = GameIds.all();
        if (!games.contains(game)) {
            throw new InputException("--game: found '" + game + "', expected one of " + String.join(", ", games)
                + NearestName.question(game, games, "'"));
        }
        Protocol wanted = protocol == null ? null : ProtocolWord.parse(protocol);
        List<String> languages = Starter.languages(game);
        if (!languages.contains(language)) {
            throw new InputException("LANGUAGE: found '" + language + "', expected one of "
                + String.join(", ", languages) + (game.equals(Games.FIRST) ? "" : " for " + game)
                + NearestName.question(language, languages, "'"));
        }
        List<Starter> known = Arrays.stream(Starter.values())
            .filter(each -> each.word().equals(language) && each.isFor(game) && each.searches() == simulator).toList();
        if (known.isEmpty()) {
            throw new InputException("--simulator: found LANGUAGE '" + language + "' for " + game
                + ", expected cpp for " + Games.FIRST);
        }
        return known.stream().filter(each -> wanted == null || each.protocol() == wanted).findFirst().orElseThrow(
            () -> new InputException("--protocol: found '" + protocol + "', expected "
                + known.get(0).protocol().word() + ", which the bot in " + language + " speaks"));
    }

    /** The first shipped scene of the game. */
    private String scene() {
        return SceneFiles.shipped().stream().filter(name -> Games.open(name).scene().gameId().equals(game)).findFirst()
            .orElseThrow();
    }

    /** Refuses to overwrite anything. */
    private static void refuseUnlessEmpty(Path path) {
        if (!Files.exists(path)) {
            return;
        }
        if (!Files.isDirectory(path)) {
            throw new InputException(path + ": found a file, expected a new or empty folder");
        }
        try (Stream<Path> files = Files.list(path)) {
            if (files.findAny().isPresent()) {
                throw new InputException(path + ": found a folder with files in it, expected a new or empty one");
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be read: " + problem.getMessage());
        }
    }
}
