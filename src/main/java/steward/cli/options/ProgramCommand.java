package steward.cli.options;

import java.util.concurrent.Callable;
import picocli.CommandLine;
import steward.cli.shared.WordConverter;
import steward.cli.streams.Streams;

/** Base class of the program's commands: a call that is checked, and the streams to which it prints. */
public abstract class ProgramCommand implements Callable<Integer> {

    /** Refuses options that do not go together; its refusals name the command's help. */
    protected final CallCheck check = CallCheck.withHelp();

    /** The program's streams; there before {@link #call} is. */
    protected Streams streams;

    public final ProgramCommand on(Streams given) {
        streams = given;
        return this;
    }

    /** Runs the command as a part of another one, with arguments of its own. */
    public final int run(Streams given, String... arguments) throws Exception {
        CommandLine line = new CommandLine(this);
        WordConverter.register(line);
        line.parseArgs(arguments);
        return on(given).call();
    }
}
