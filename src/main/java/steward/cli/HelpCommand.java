package steward.cli;

import java.util.Iterator;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Streams;
import steward.cli.shared.UnknownWord;

/** {@code steward help}: the help of the program, or of a command. */
@Command(name = HelpCommand.NAME, description = "Prints the help of the program, or of a command.",
    footer = {"", "Example:", "  steward help match"})
final class HelpCommand implements Callable<Integer> {

    /** The name of the command. */
    static final String NAME = "help";

    private final Streams streams;

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", arity = "0..1", paramLabel = "COMMAND", completionCandidates = Commands.class,
        description = "One of the commands.")
    private String command;

    HelpCommand(Streams streams) {
        this.streams = streams;
    }

    /** The names of all commands. */
    static final class Commands implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Main.commands().iterator();
        }
    }

    @Override
    public Integer call() {
        Map<String, CommandLine> commands = spec.root().subcommands();
        if (command != null && !commands.containsKey(command)) {
            throw new ParameterException(spec.root().commandLine(),
                UnknownWord.command(command, commands.keySet()));
        }
        (command == null ? spec.root().commandLine() : commands.get(command)).usage(streams.out());
        return ExitStatus.DONE;
    }
}
