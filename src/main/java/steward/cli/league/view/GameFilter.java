package steward.cli.league.view;

import java.util.List;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.files.InputException;
import steward.league.StoredGame.StoredSeat;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.text.NearestName;

/** Options that select games. */
@OptionSection("Which games")
final class GameFilter {

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--bot", paramLabel = "NAME", description = "Only games of this bot; NAME#2 is its second version.")
    private String bot;

    @Option(names = "--against", paramLabel = "NAME", description = "Only games against this bot.")
    private String against;

    @Option(names = "--won", description = "Only games that the bot won.")
    private boolean won;

    @Option(names = "--drawn", description = "Only draws.")
    private boolean drawn;

    @Option(names = "--lost", description = "Only games that the bot lost.")
    private boolean lost;

    @Option(names = "--failed", description = "Only games in which the bot failed; without --bot, any bot.")
    private boolean failed;

    @Option(names = "--kept", description = "Only games whose replay is kept.")
    private boolean kept;

    @Option(names = "--forgiven", description = "Only games that 'league forgive' set aside.")
    private boolean forgiven;

    /** Refuses options that do not go together. */
    void check() {
        check.that((won ? 1 : 0) + (drawn ? 1 : 0) + (lost ? 1 : 0) <= 1,
            "--won, --drawn and --lost exclude each other");
        check.that(bot != null || !won && !lost, (won ? "--won" : "--lost") + ": expected --bot with it");
    }

    /** True if only failed games are asked for. */
    boolean failed() {
        return failed;
    }

    /** The version of {@code --bot}, or -1. */
    int version(List<LeagueTable.Entry> entries) {
        return version(bot, entries);
    }

    /** The version of {@code --against}, or -1. */
    int opponent(List<LeagueTable.Entry> entries) {
        return version(against, entries);
    }

    /** The version of a name; -1 for {@code null}. */
    static int version(String name, List<LeagueTable.Entry> entries) {
        if (name == null) {
            return -1;
        }
        List<String> names = entries.stream().map(LeagueTable.Entry::name).toList();
        return entries.stream().filter(entry -> entry.name().equals(name)).findFirst().orElseThrow(() ->
            new InputException("found no bot '" + name + "' with games, expected one of " + String.join(", ", names)
                + NearestName.question(name, names, "'"))).version();
    }

    /**
     * True if a game is meant.
     *
     * @param version  of {@link #version}
     * @param opponent of {@link #opponent}
     */
    boolean takes(StoredGame game, int version, int opponent) {
        if (kept && game.replay() == null || forgiven && (game.problem() == null
                || !game.problem().startsWith(StoredGame.FORGIVEN))) {
            return false;
        }
        List<StoredSeat> own = game.seats().stream().filter(seat -> version < 0 || seat.version() == version).toList();
        boolean met = opponent < 0 || game.seats().stream().anyMatch(seat -> seat.version() == opponent);
        if (own.isEmpty() || !met || failed && own.stream().allMatch(seat -> seat.fault() == null)) {
            return false;
        }
        long first = game.seats().stream().filter(seat -> seat.rank() == 0).count();
        boolean isFirst = own.stream().anyMatch(seat -> seat.rank() == 0);
        return !won && !drawn && !lost || game.counts() && (won && isFirst && first == 1
            || drawn && isFirst && first > 1
            || lost && !isFirst);
    }
}
