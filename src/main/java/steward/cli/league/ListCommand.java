package steward.cli.league;

import java.nio.file.Files;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import steward.cli.league.view.LeagueArgument;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.store.GameStore;
import steward.text.TextFormat;

/** {@code steward league list}: the bots and their versions. */
@Command(name = "list", description = "Prints the bots of a league, their versions and how many games each has.",
    footer = {"", "Example:", "  steward league list night"})
final class ListCommand implements Callable<Integer> {

    private final Streams streams;

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    ListCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        LeagueFolder folder = league.open();
        LeagueSettings settings = folder.read();
        streams.out().println(TextFormat.plain(TextFormat.count(settings.bots().size(), "bot") + " in a league of "
            + settings.scene() + ", " + settings.pairing()));
        if (Files.notExists(folder.database())) {
            settings.bots().forEach(bot -> print(bot, List.of(), null));
            return ExitStatus.DONE;
        }
        try (GameStore store = GameStore.read(folder)) {
            List<GameStore.Version> versions = store.versions();
            settings.bots().forEach(bot -> print(bot, versions, store));
            versions.stream().filter(version -> settings.bot(version.bot()).isEmpty()).forEach(version ->
                streams.out().println("  " + version.display() + ": "
                    + TextFormat.count(store.gamesOf(version.id()), "game") + ", not in league.json: "
                    + TextFormat.plain(version.command())));
        }
        return ExitStatus.DONE;
    }

    private void print(LeagueBot bot, List<GameStore.Version> versions, GameStore store) {
        streams.out().println(TextFormat.plain("  " + bot.name() + (bot.retired() ? " (retired)" : "")
            + (bot.random() ? " (random)" : "") + ": " + bot.command()));
        bot.platforms().forEach(each -> streams.out().println(TextFormat.plain("    on " + each.platform() + ": "
            + each.command())));
        versions.stream().filter(version -> version.bot().equals(bot.name())).forEach(version ->
            streams.out().println("    " + version.display() + ": "
                + TextFormat.count(store.gamesOf(version.id()), "game") + ", program "
                + version.identity().substring(0, 8)));
    }
}
