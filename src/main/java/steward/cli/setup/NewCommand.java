package steward.cli.setup;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.BotCommand;
import steward.bot.command.CommandLine;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.Resources;
import steward.game.BotStub;
import steward.game.GameType;
import steward.match.Protocol;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.text.NearestName;

/** {@code steward new}: writes a bot to start from. */
@Command(name = "new", description = "Writes a commented bot to start from, which plays at once, into a new or empty "
    + "folder, and prints how to run it.",
    footer = {"", "Examples:", "  steward new python mybot", "  steward new java mybot --protocol json",
        "  steward new cpp mybot --simulator",
        "", "Exit status: 0 written; 2 the folder is not empty, or cannot be written into."})
public final class NewCommand extends ProgramCommand {

    /** Says how to run the bot. */
    static final String README = "README.md";

    private static final String SIMULATOR = "/steward/starters/cpp-simulator/";
    private static final List<String> SIMULATOR_FILES = List.of("bot.cpp", "steward_podrace.hpp", README);
    private static final String SIMULATOR_COMPILE = "g++ -std=c++17 -O3 -march=native -o bot bot.cpp";

    @Parameters(index = "0", paramLabel = "LANGUAGE", completionCandidates = Languages.class,
        description = "One of ${COMPLETION-CANDIDATES}.")
    private String language;

    @Parameters(index = "1", paramLabel = "DIR", description = "The folder; made if it is not there.")
    private String folder;

    @Option(names = "--game", paramLabel = "GAME", defaultValue = Games.FIRST, completionCandidates = GameIds.class,
        description = "The game that it plays, one of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private String game;

    @Option(names = "--protocol", paramLabel = "P",
        description = "The protocol of the bot, json or codingame (default: JSON in python, CodinGame's lines in "
            + "the others).")
    private Protocol protocol;

    @Option(names = "--simulator", description = "Writes a bot that searches, in cpp for the pod race, with "
        + "steward_podrace.hpp: the official turn to the last bit, in one header.")
    private boolean simulator;

    /** The games: those of the program, and those of the user's jars. */
    static final class GameIds implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Games.ids().iterator();
        }
    }

    /** The words for the languages. */
    static final class Languages implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return StarterLanguage.words().iterator();
        }
    }

    @Override
    public Integer call() {
        StarterLanguage wanted = language();
        GameType type = type();
        Protocol spoken = protocol != null ? protocol : usual(wanted, type);
        if (simulator && !(wanted == StarterLanguage.CPP && game.equals(Games.FIRST) && spoken == Protocol.CODINGAME)) {
            throw new InputException("--simulator: found LANGUAGE '" + language + "' for " + game
                + (spoken == Protocol.JSON ? " in json" : "") + ", expected cpp for " + Games.FIRST + " in codingame");
        }
        List<String> compile = simulator ? List.of(SIMULATOR_COMPILE) : wanted.compile();
        String bot = wanted.bot(spoken);
        Map<String, byte[]> files = simulator ? simulatorFiles() : Map.of(
            wanted.source(), bytes(source(wanted, spoken, type)), README, bytes(readme(compile, bot)));
        Path path = OutputFiles.path(folder);
        refuseUnlessEmpty(path);
        try {
            Files.createDirectories(path);
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                Files.write(path.resolve(file.getKey()), file.getValue());
            }
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be written into: " + OutputFiles.reason(path, problem));
        }
        streams.out().println("Written: " + path.resolve(wanted.source()) + ". It speaks "
            + (spoken == Protocol.CODINGAME ? "CodinGame's lines" : "JSON") + ". To race it:");
        streams.out().println("  cd " + CommandLine.quote(List.of(folder)));
        compile.forEach(command -> streams.out().println("  " + command));
        streams.out().println("  " + match(bot));
        return ExitStatus.DONE;
    }

    private StarterLanguage language() {
        List<String> languages = StarterLanguage.words();
        if (!languages.contains(language)) {
            throw new InputException("LANGUAGE: found '" + language + "', expected one of "
                + String.join(", ", languages) + NearestName.question(language, languages, "'"));
        }
        return StarterLanguage.values()[languages.indexOf(language)];
    }

    private GameType type() {
        List<String> games = Games.ids();
        if (!games.contains(game)) {
            throw new InputException("--game: found '" + game + "', expected one of " + String.join(", ", games)
                + NearestName.question(game, games, "'"));
        }
        return Games.types().of(game).orElseThrow();
    }

    /** The language's usual protocol, unless the game declares the other one only. */
    private Protocol usual(StarterLanguage wanted, GameType type) {
        Protocol other = wanted.usual() == Protocol.JSON ? Protocol.CODINGAME : Protocol.JSON;
        return stub(type, wanted.usual()) == null && stub(type, other) != null ? other : wanted.usual();
    }

    /** @throws InputException if the game of a jar declares something that is not possible */
    private BotStub stub(GameType type, Protocol spoken) {
        try {
            return spoken == Protocol.JSON ? type.frameStub() : type.lineStub();
        } catch (IllegalArgumentException | ExceptionInInitializerError problem) {
            throw unusable(problem instanceof Error ? problem.getCause() : problem);
        }
    }

    private InputException unusable(Throwable problem) {
        return new InputException("--game " + game + ": its type declares input or answer that no starter can have: "
            + problem.getMessage());
    }

    private String source(StarterLanguage wanted, Protocol spoken, GameType type) {
        BotStub stub = stub(type, spoken);
        if (stub == null) {
            streams.warn(game + " does not declare its " + (spoken == Protocol.JSON ? "frames" : "lines")
                + ": the bot says where to read and answer them");
        }
        try {
            return StarterSource.of(wanted, spoken, game, stub == null ? StarterSource.undeclared(spoken, game) : stub);
        } catch (IllegalArgumentException problem) {
            throw unusable(problem);
        }
    }

    private String readme(List<String> compile, String bot) {
        return (compile.isEmpty() ? "Run it, with nothing to compile: "
            : "Compile it: " + compile.get(0) + "\nRun it: ") + match(bot) + " --out match.jsonl --overwrite\n";
    }

    private static Map<String, byte[]> simulatorFiles() {
        return SIMULATOR_FILES.stream().collect(Collectors.toMap(file -> file,
            file -> Resources.bytes(SIMULATOR + file)));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** The call of a match, against the weakest bundled bot or against itself. */
    private String match(String bot) {
        String scene = scene();
        String weakest = Games.weakestBot(game);
        int players = scene == null ? Math.max(2, Games.types().of(game).orElseThrow().fewestPlayers())
            : Games.open(scene).scene().players();
        String me = " --bot " + CommandLine.quote(List.of("me=" + bot));
        return "steward match" + (game.equals(Games.FIRST) ? "" : " --scene " + (scene == null ? "SCENE.json" : scene))
            + me + (weakest == null ? me : " --bot " + BotCommand.Prefix.BUILTIN.written() + weakest)
            .repeat(players - 1);
    }

    /** The first shipped scene of the game that is played, the one of its name before others; {@code null} if none. */
    private String scene() {
        if (SceneFiles.shipped().contains(game)) {
            return game;
        }
        return SceneFiles.shipped().stream().filter(name -> {
            Scene scene = Games.open(name).scene();
            return scene.gameId().equals(game) && scene.players() > 0;
        }).findFirst().orElse(null);
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
