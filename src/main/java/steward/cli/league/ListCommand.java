package steward.cli.league;

import java.nio.file.Files;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Json;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.store.GameStore;
import steward.match.OwnLimits;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward league list}: lists the bots and their versions. */
@Command(name = "list", description = "Prints the bots of a league, their versions and how many games each has.",
    footer = {
        "", "--json: scene, pairing, bots (name, command, listed, retired, random,",
        "timeLimit, platforms (platform, command), versions (name, games, program,",
        "timeLimit, paused)).",
        "", "Example:",
        "  steward league list night"})
final class ListCommand extends ProgramCommand {

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() {
        LeagueFolder folder = league.open();
        LeagueSettings settings = folder.read();
        if (json) {
            printJson(folder, settings);
            return ExitStatus.DONE;
        }
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
                    + TextFormat.plain(version.command()) + limits(version)));
        }
        return ExitStatus.DONE;
    }

    private void printJson(LeagueFolder folder, LeagueSettings settings) {
        try (GameStore store = Files.notExists(folder.database()) ? null : GameStore.read(folder)) {
            List<GameStore.Version> versions = store == null ? List.of() : store.versions();
            Set<String> names = new LinkedHashSet<>(settings.bots().stream().map(LeagueBot::name).toList());
            versions.forEach(version -> names.add(version.bot()));
            Json.print(streams, Fields.of("scene", settings.scene(), "pairing", settings.pairing(),
                "bots", Fields.each(names, name -> {
                    Optional<LeagueBot> bot = settings.bot(name);
                    List<GameStore.Version> own = versions.stream().filter(each -> each.bot().equals(name)).toList();
                    return Fields.of("name", name, "command", bot.map(LeagueBot::command)
                        .orElseGet(() -> own.get(own.size() - 1).command()), "listed", bot.isPresent(),
                        "retired", bot.map(LeagueBot::retired).orElse(false),
                        "random", bot.map(LeagueBot::random).orElse(false),
                        OwnLimits.FIELD, bot.map(LeagueBot::limits).map(OwnLimits::written).orElse(null),
                        "platforms", Fields.each(bot.map(LeagueBot::platforms).orElse(List.of()), each -> Fields.of(
                            "platform", each.platform(), "command", each.command())),
                        "versions", Fields.each(own, version -> Fields.of("name", version.display(),
                            "games", store.gamesOf(version.id()), "program", version.identity(),
                            OwnLimits.FIELD, version.timeLimit(), "paused", version.paused())));
                })));
        }
    }

    private void print(LeagueBot bot, List<GameStore.Version> versions, GameStore store) {
        streams.out().println(TextFormat.plain("  " + bot.name() + (bot.retired() ? " (retired)" : "")
            + (bot.random() ? " (random)" : "") + ": " + bot.command()
            + (bot.limits() == null ? "" : ", " + bot.limits())));
        bot.platforms().forEach(each -> streams.out().println(TextFormat.plain("    on " + each.platform() + ": "
            + each.command())));
        versions.stream().filter(version -> version.bot().equals(bot.name())).forEach(version ->
            streams.out().println("    " + version.display() + ": "
                + TextFormat.count(store.gamesOf(version.id()), "game") + ", program "
                + version.identity().substring(0, 8)
                + limits(version)
                + (version.paused() ? ", paused" : "")));
    }

    private static String limits(GameStore.Version version) {
        return version.timeLimit() == null ? "" : ", " + OwnLimits.parse(version.timeLimit());
    }
}
