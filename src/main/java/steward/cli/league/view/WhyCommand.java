package steward.cli.league.view;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.contest.loss.Losses;
import steward.files.InputException;
import steward.league.StoredGame;
import steward.league.page.StoredLosses;
import steward.league.rating.LeagueTable;

/** {@code steward league why}: explains why a bot lost its games. */
@Command(name = "why", description = "Explains the games that a bot lost: how, when and how badly.",
    footer = {
        "", "It prints:",
        "  - how lost games ended: failed, out by the rules, or the end of the game",
        "  - the turn from which the bot was behind to the end: median and range",
        "  - the worst game of each kind, by the distance to the winner's score",
        "  - the bot's values in lost and won games: score, turns, values of the game,",
        "    and data that the bot reported with [PDATA] and [TDATA]",
        "Replays are played again for it; \"keep\": \"lost\" in league.json keeps them.",
        "", "Example:",
        "  steward league why night mine"})
public final class WhyCommand extends ProgramCommand {

    private static final int MOST = 100_000;
    /** Replays of each bot that a page reads. */
    private static final int ON_PAGE = 20;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "NAME", description = "The bot; NAME#2 is its second version.")
    private String bot;

    @Option(names = "--replays", paramLabel = "N", defaultValue = "500", description = "Reads the replays of the N "
        + "latest lost and N latest won games that have one (default: ${DEFAULT-VALUE}).")
    private Integer replays;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Override
    public Integer call() {
        check.range("--replays", replays, 0, MOST);
        try (LeagueOpening.Opened opened = LeagueOpening.read(league.open())) {
            if (opened.season().players() < 2) {
                throw new InputException("found a league in which each plays alone, expected one in which games are "
                    + "lost; 'steward league table' compares the scores");
            }
            int version = GameFilter.version(bot, opened.entries());
            Losses losses = losses(opened, bot, version, each -> opened.games().gamesOf(version, each), replays);
            if (json) {
                Json.print(streams, losses.fields());
            } else {
                losses.lines().forEach(streams.out()::println);
            }
        }
        return ExitStatus.DONE;
    }

    private static Losses losses(LeagueOpening.Opened opened, String name, int version,
                                 Consumer<Consumer<StoredGame>> games, int most) {
        Set<Integer> random = opened.entries().stream().filter(LeagueTable.Entry::random)
            .map(LeagueTable.Entry::version).collect(Collectors.toSet());
        StoredLosses losses = new StoredLosses(name, version, random, opened.season().lowerScoreIsBetter(),
            opened.folder().replays(), Games.types());
        games.accept(losses::add);
        return losses.read(most);
    }

    /** The accounts of all bots that play, by version, over games that a page lists. */
    static Map<Integer, List<String>> ofPage(LeagueOpening.Opened opened, List<StoredGame> games) {
        Map<Integer, List<String>> lines = new LinkedHashMap<>();
        if (opened.season().players() < 2) {
            return lines;
        }
        for (LeagueTable.Entry entry : opened.entries().stream().filter(LeagueTable.Entry::active).toList()) {
            Losses losses = losses(opened, entry.name(), entry.version(), games::forEach, ON_PAGE);
            if (losses.losses() > 0) {
                lines.put(entry.version(), losses.lines());
            }
        }
        return lines;
    }
}
