package steward.cli.league;

import java.nio.file.Files;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.InputException;
import steward.league.FolderLock;
import steward.league.LeagueFolder;
import steward.league.store.AsideGames;
import steward.league.store.GameStore;
import steward.text.NearestName;
import steward.text.TextFormat;

/** {@code steward league forgive}: takes games out of the count that something outside the game spoilt. */
@Command(name = "forgive", description = "Sets aside games of a bot that something outside the game spoilt, such "
    + "as a full disk or a missing file.",
    footer = {
        "", "All games of the range are set aside, won or lost, so that nothing is selected",
        "by its result. With --replay the next 'league run' plays those in which the bot",
        "failed again, with the same seeds; the others count as before. Games stay",
        "stored. 'league games --forgiven' lists them. --back counts them again; then",
        "further attempts do not count.",
        "", "Examples:",
        "  steward league games night --bot mine --failed",
        "  steward league forgive night mine --games 120..164 --replay"})
final class ForgiveCommand extends ProgramCommand {

    private static final Pattern RANGE = Pattern.compile("([0-9]{1,18})\\.\\.([0-9]{1,18})");

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "NAME", description = "The bot: all of its versions.")
    private String name;

    @Option(names = "--games", paramLabel = "A..B", required = true, description = "Numbers of games, as "
        + "'league games' lists them.")
    private String games;

    @Option(names = "--replay", description = "Plays the games again in which the bot failed.")
    private boolean replay;

    @Option(names = "--back", description = "Counts forgiven games again.")
    private boolean back;

    @Override
    @SuppressWarnings("try")                           // the lock is only closed, never used
    public Integer call() {
        check.that(!replay || !back, "--replay: expected no --back with it");
        AsideGames.Range range = range();
        LeagueFolder folder = league.openToWrite(streams);
        if (!Files.exists(folder.database())) {
            throw new InputException(folder.path() + ": found a league without games, expected one that has been "
                + "played");
        }
        try (FolderLock lock = FolderLock.take(folder); GameStore store = GameStore.write(folder)) {
            List<String> names = store.versions().stream().map(GameStore.Version::bot).distinct().toList();
            if (!names.contains(name)) {
                throw new InputException("found no bot '" + name + "' with games, expected one of "
                    + String.join(", ", names) + NearestName.question(name, names, "'"));
            }
            AsideGames aside = new AsideGames(store);
            int count = back ? aside.takeBack(name, range) : replay ? aside.playAgain(name, range)
                : aside.forgive(name, range);
            streams.out().println(TextFormat.count(count, "game") + " of " + name + (back ? count == 1
                ? " counts again" : " count again" : replay ? count == 1 ? " is played again by the next run"
                : " are played again by the next run" : count == 1 ? " is set aside" : " are set aside"));
        }
        return ExitStatus.DONE;
    }

    private AsideGames.Range range() {
        Matcher range = RANGE.matcher(games);
        boolean whole = range.matches() && Long.parseLong(range.group(1)) <= Long.parseLong(range.group(2));
        check.that(whole, "--games: found '" + games + "', expected two numbers of games such as 120..164, the lower "
            + "one first");
        return new AsideGames.Range(Long.parseLong(range.group(1)), Long.parseLong(range.group(2)));
    }
}
