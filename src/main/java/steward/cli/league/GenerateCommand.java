package steward.cli.league;

import java.util.SplittableRandom;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.store.GameStore;
import steward.league.store.MadeUpGames;
import steward.text.TextFormat;

/** {@code steward league generate}: made-up games, to try what a large league is like. */
@Command(name = "generate", description = "Fills a league that has no games with made-up ones, to try how it grows.",
    footer = {"",
        "The bots are called bot-1, bot-2, ...; each is 30 Elo weaker than the one before.",
        "", "Example:", "  steward league init big && steward league generate big --games 1000000"})
final class GenerateCommand extends ProgramCommand {

    private static final int MOST_BOTS = 1000;
    private static final int MOST_GAMES = 100_000_000;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--games", paramLabel = "N", defaultValue = "1000000",
        description = "How many games (default: ${DEFAULT-VALUE}).")
    private int games;

    @Option(names = "--bots", paramLabel = "N", defaultValue = "10",
        description = "How many bots (default: ${DEFAULT-VALUE}).")
    private int bots;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1",
        description = "The results follow from it (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Override
    public Integer call() {
        check.range("--games", games, 1, MOST_GAMES);
        check.range("--bots", bots, 2, MOST_BOTS);
        LeagueFolder folder = league.openToWrite(streams);
        LeagueSettings settings = folder.read();
        Season season = Season.of(LeagueOpening.setup(folder, settings), settings);
        try (GameStore store = GameStore.write(folder)) {
            int number = store.open(season);
            if (store.games(number) > 0 || !store.versions().isEmpty()) {
                throw new InputException(folder.path() + ": found a league with games, expected an empty one");
            }
            new MadeUpGames(store, number, season, MadeUpGames.bots(store, bots), new SplittableRandom(seed))
                .add(games);
        }
        streams.out().println(TextFormat.count(games, "made-up game") + " between " + bots + " bots in "
            + folder.path());
        return ExitStatus.DONE;
    }
}
