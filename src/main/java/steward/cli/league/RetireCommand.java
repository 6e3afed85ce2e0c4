package steward.cli.league;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;

/** {@code steward league retire}: ends a bot's play; its games stay. */
@Command(name = "retire", description = "Ends a bot's play; its games stay.",
    footer = {"", "Example:", "  steward league retire night mine"})
final class RetireCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "NAME", description = "The bot.")
    private String name;

    @Option(names = "--back", description = "Lets it play again.")
    private boolean back;

    @Override
    public Integer call() {
        LeagueFolder folder = league.openToWrite(streams);
        LeagueSettings settings = folder.read();
        LeagueBot bot = LeagueOpening.bot(settings, name);
        folder.write(settings.replaced(name, bot.retired(!back)));
        streams.out().println(name + (back ? " plays again" : " plays no more; its games stay"));
        return ExitStatus.DONE;
    }
}
