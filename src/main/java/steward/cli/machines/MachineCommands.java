package steward.cli.machines;

import java.util.LinkedHashMap;
import java.util.Map;
import steward.cli.league.run.LeagueRunCommand;

/** List of the league commands that are about several machines. */
public final class MachineCommands {

    private MachineCommands() { }

    /** The commands by their names, in listed order. */
    public static Map<String, Object> ofLeague() {
        Map<String, Object> commands = new LinkedHashMap<>();
        commands.put("run", new LeagueRunCommand(new ServeOptions()));
        commands.put("worker", new LeagueWorkerCommand());
        return commands;
    }
}
