package steward.cli.league;

import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import steward.cli.league.view.GamesCommand;
import steward.cli.league.view.LeagueSprtCommand;
import steward.cli.league.view.PageCommand;
import steward.cli.league.view.TableCommand;
import steward.cli.league.view.WhyCommand;
import steward.cli.options.ProgramCommand;

/** {@code steward league}: groups the commands of a league, in which bots play each other and every game is kept. */
@Command(name = "league", synopsisSubcommandLabel = "COMMAND",
    description = "Lets bots play each other for as long as you like, stores every game, and rates the bots.",
    footer = {
        "", "A league is a folder. It has league.json, which you read and edit, league.db",
        "with the games (SQLite), and kept replays. 'run' can be ended at any moment and",
        "continues where it was. A bot whose file has changed is a new version, with",
        "games of its own.",
        "", "Examples:",
        "  steward league init night --scene mad-pod-racing",
        "  steward league add night 'mine=python3 bot.py'",
        "  steward league add night builtin:veteran",
        "  steward league run night --for 8h --watch --open",
        "  steward league table night",
        "", "Exit status: 0 done; 1 it could not be finished; 2 the call or the league is",
        "unusable; 130 interrupted (finished games are stored)."})
public final class LeagueCommand extends ProgramCommand {

    @Spec
    private CommandSpec spec;

    /**
     * The command with those in it.
     *
     * @param more commands by their names, {@code run} among them; others are listed behind those that are here
     */
    public static CommandSpec spec(Map<String, Object> more) {
        CommandSpec spec = CommandSpec.forAnnotatedObject(new LeagueCommand());
        Map<String, Object> commands = commands();
        commands.putAll(more);                         // also in the place of one that is there
        commands.forEach((name, command) ->
            spec.addSubcommand(name, CommandSpec.forAnnotatedObject(command)));
        return spec;
    }

    private static Map<String, Object> commands() {
        Map<String, Object> commands = new LinkedHashMap<>();
        commands.put("init", new InitCommand());
        commands.put("add", new AddCommand());
        commands.put("retire", new RetireCommand());
        commands.put("resume", new ResumeCommand());
        commands.put("forgive", new ForgiveCommand());
        commands.put("rename", new RenameCommand());
        commands.put("list", new ListCommand());
        commands.put("run", null);                      // its options are known further up
        commands.put("table", new TableCommand());
        commands.put("games", new GamesCommand());
        commands.put("why", new WhyCommand());
        commands.put("page", new PageCommand());
        commands.put("export", new ExportCommand());
        commands.put("import", new ImportGamesCommand());
        commands.put("backup", new BackupCommand());
        commands.put("verify", new VerifyCommand());
        commands.put("prune", new PruneCommand());
        commands.put("sprt", new LeagueSprtCommand());
        return commands;
    }

    @Override
    public Integer call() {
        throw new ParameterException(spec.commandLine(), "found no command, expected one of "
            + String.join(", ", spec.subcommands().keySet()));
    }
}
