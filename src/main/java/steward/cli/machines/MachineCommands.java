package steward.cli.machines;

import java.util.LinkedHashMap;
import java.util.Map;
import steward.cli.league.run.RunCommand;
import steward.cli.shared.Lab;
import steward.cli.streams.Streams;

/** Commands of a league that are about several machines. */
public final class MachineCommands {

    private MachineCommands() {
    }

    /** The commands by their names, in listed order. */
    public static Map<String, Object> ofLeague(Streams streams) {
        Map<String, Object> commands = new LinkedHashMap<>();
        commands.put("run", new RunCommand(streams, new ServeOptions()));
        commands.put("worker", new LeagueWorkerCommand(streams));
        commands.put("shard", new ShardCommand(streams));
        commands.put("merge", new MergeCommand(streams));
        commands.put("capacity", Lab.commandOrMissing("league capacity", streams));
        return commands;
    }
}
