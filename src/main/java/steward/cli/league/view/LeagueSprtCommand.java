package steward.cli.league.view;

import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ThreadsOption;
import steward.cli.play.StoredSeries;
import steward.cli.sequential.SprtOptions;
import steward.cli.sequential.SprtRun;
import steward.cli.shared.Verbosity;
import steward.contest.Contest;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.sequential.Gsprt;

/** {@code steward league sprt}: runs a sequential test between two bots of a league. */
@Command(name = "sprt", description = "Tests whether one bot of a league is better than another, with its stored "
    + "games and as many more as are needed.",
    footer = {
        "", "The test is that of 'steward sprt', with the scene, the limits and the sandbox",
        "of the league. Its games are stored in the league. The first bot is the new",
        "one, the second the old one.",
        "", "Example:",
        "  steward league sprt night mine old --elo1 10"})
public final class LeagueSprtCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "A", description = "The name of the new bot.")
    private String one;

    @Parameters(index = "2", paramLabel = "B", description = "The name of the old bot.")
    private String other;

    @Option(names = "--fill", paramLabel = "NAME",
        description = "In a scene for three and more players: the bot that takes the other seats.")
    private String fill;

    @Mixin
    private final SprtOptions options = new SprtOptions();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--anyway", description = "Counts games on seeds that the bots' own games were used to "
        + "choose, and flags the result.")
    private boolean anyway;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        Gsprt test = options.test();
        threads.check();
        LeagueFolder folder = league.open();
        LeagueSettings settings = folder.read();
        check.that(!one.equals(other), "found the bot '" + one + "' twice, expected two bots");
        Contest empty = LeagueOpening.contest(folder, settings, streams);
        List<Contest.Entrant> entrants = SprtOptions.withFill(check, List.of(one, other), fill, empty.players(),
            "are tested").stream().map(name -> entrant(settings, name)).toList();
        Contest.checkPlayable(empty.setup(), entrants);
        Contest contest = empty.between(entrants);
        return StoredSeries.play(folder.path(), contest, settings.factor(),
            List.copyOf(LeagueOpening.environment(settings).keySet()), streams, (store, watch) -> {
                store.refuseTwins();
                return new SprtRun(streams, contest, test, options.ending(), store,
                    json ? Verbosity.JSON : Verbosity.FULL).flagged(List.of(), anyway)
                    .play(Seeds.from(store.ownSeed()), threads.count(streams), watch);
            });
    }

    private static Contest.Entrant entrant(LeagueSettings settings, String name) {
        Contest.Entrant entrant = LeagueOpening.bot(settings, name).entrant();
        if (entrant.problem() != null) {
            throw new InputException(entrant.problem());
        }
        return entrant;
    }
}
