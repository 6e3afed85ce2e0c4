package steward.cli.league;

import java.nio.file.Files;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;

/** {@code steward league resume}: lets a paused bot play again. */
@Command(name = "resume", description = "Lets a bot play again that was paused for failing in many games in a row.",
    footer = {
        "", "Its failures so far do not pause it again; later ones do. If the bot's program",
        "has changed, it plays without this command: it is a new version.",
        "", "Example:",
        "  steward league resume night mine"})
final class ResumeCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "NAME", description = "The bot.")
    private String name;

    @Override
    public Integer call() {
        LeagueFolder folder = league.openToWrite(streams);
        LeagueSettings settings = folder.read();
        LeagueBot bot = LeagueOpening.bot(settings, name);
        if (Files.exists(folder.database())) {
            try (LeagueOpening.Opened opened = LeagueOpening.write(folder)) {
                opened.store().versions().stream().filter(version -> version.paused() && version.bot().equals(name))
                    .forEach(version -> opened.store().pause(version.id(), false));
                folder.write(settings.replaced(name, bot.resumed(opened.games().nextDecision())));
            }
        }
        streams.out().println(name + " plays again; its failures so far do not pause it");
        return ExitStatus.DONE;
    }
}
