package steward.cli.league;

import java.nio.file.Files;
import java.util.Objects;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.InputException;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueReader;
import steward.league.LeagueSettings;
import steward.league.store.GameStore;

/** {@code steward league rename}: gives a bot another name. */
@Command(name = "rename", description = "Gives a bot another name, which its games then have too.",
    footer = {"", "Example:", "  steward league rename night mine careful"})
final class RenameCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Parameters(index = "1", paramLabel = "NAME", description = "The bot.")
    private String name;

    @Parameters(index = "2", paramLabel = "NEW-NAME", description = "The new name.")
    private String other;

    @Override
    public Integer call() {
        LeagueFolder folder = league.openToWrite(streams);
        LeagueSettings settings = folder.read();
        LeagueBot bot = LeagueOpening.bot(settings, name);
        if (!LeagueReader.isName(other) || !Objects.equals(bot.platform(), LeagueBot.platform(other))) {
            throw new InputException("found the name '" + other + "', expected " + LeagueReader.NAME_FORM
                + (bot.platform() == null ? "" : ", and '" + LeagueBot.AT + bot.platform() + "' after them"));
        }
        boolean taken = settings.bot(other).isPresent();
        if (Files.exists(folder.database())) {
            try (GameStore store = GameStore.write(folder)) {
                taken |= store.present(other).isPresent();
                if (!taken) {
                    store.rename(name, other);
                }
            }
        }
        if (taken) {
            throw new InputException("found a bot '" + other + "' in the league, expected another name");
        }
        folder.write(settings.replaced(name, bot.named(other)));
        streams.out().println(name + " is now called " + other);
        return ExitStatus.DONE;
    }
}
