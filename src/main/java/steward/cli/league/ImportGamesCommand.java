package steward.cli.league;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.store.GameLine;
import steward.league.store.GameStore;
import steward.league.store.SeasonOpening;
import steward.text.TextFormat;
import steward.text.Utf8Text;

/** {@code steward league import}: takes over games of another league. */
@Command(name = "import", description = "Reads games that 'league export' wrote, of the same scene, limits and rules.",
    footer = {
        "", "A game that the league already has is skipped. All games are checked before the",
        "first is stored.",
        "", "Example:",
        "  steward league import night games.jsonl"})
final class ImportGamesCommand extends ProgramCommand {

    private static final int TOGETHER = 10_000;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "FILE", description = "The games, in JSON Lines.")
    private String file;

    @Override
    public Integer call() {
        LeagueFolder folder = league.openToWrite(streams);
        LeagueSettings settings = folder.read();
        Season season = Season.of(LeagueOpening.setup(folder, settings), settings);
        Path path = OutputFiles.path(file);
        if (!Files.isRegularFile(path)) {
            throw new InputException(path + ": found " + (Files.isDirectory(path) ? "a folder" : "no such file")
                + ", expected games of 'league export'");
        }
        try (GameStore store = GameStore.write(folder)) {
            List<StoredGame> games = new ArrayList<>();
            GameLine.Reader reader = new GameLine.Reader(store, season);
            read(path, found -> reader.check(found.place(), found.game(), found.seats()));
            int number = SeasonOpening.open(folder, store, season, false);
            read(path, found -> games.add(reader.read(found.place(), found.game(), found.seats())));
            int added = 0;
            for (int from = 0; from < games.size(); from += TOGETHER) {
                added += store.add(number, games.subList(from, Math.min(games.size(), from + TOGETHER)));
            }
            streams.out().println(TextFormat.count(added, "game") + " stored"
                + (games.size() > added ? ", " + (games.size() - added) + " were there already" : ""));
        }
        return ExitStatus.DONE;
    }

    private static void read(Path path, Consumer<GameFile.Found> taker) {
        try (BufferedReader in = Files.newBufferedReader(path, StandardCharsets.UTF_8)) {
            GameFile.readJson(in, path.toString(), taker);
        } catch (CharacterCodingException problem) {
            throw new InputException(place(path));
        } catch (IOException problem) {
            throw new InputException(path + ": cannot be read: " + OutputFiles.reason(path, problem));
        }
    }

    /** Returns where a file is not UTF-8: it is too long to be read at once. */
    private static String place(Path path) {
        try (InputStream in = Files.newInputStream(path)) {
            return Utf8Text.problem(in, path.toString(), "a text in UTF-8").getMessage();
        } catch (IOException problem) {
            return path + ": cannot be read: " + OutputFiles.reason(path, problem);
        }
    }
}
