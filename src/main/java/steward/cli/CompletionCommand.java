package steward.cli;

import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Streams;

/** {@code steward completion}: lets a shell complete commands and options. */
@Command(name = CompletionCommand.NAME, description = "Prints a script for bash and zsh that completes commands.",
    footer = {"", "Example, for the running shell:", "  source <(steward completion)"})
final class CompletionCommand implements Callable<Integer> {

    /** The name of the command. */
    static final String NAME = "completion";

    private final Streams streams;

    @Spec
    private CommandSpec spec;

    CompletionCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        streams.out().print(AutoComplete.bash("steward", spec.root().commandLine()));
        return ExitStatus.DONE;
    }
}
