package steward.cli.shared;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;
import steward.files.InputException;
import steward.replay.ReplayException;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/** Turns an exception into a message and an exit status. */
public final class ErrorHandler implements IParameterExceptionHandler, IExecutionExceptionHandler {

    private final Streams streams;

    public ErrorHandler(Streams streams) {
        this.streams = streams;
    }

    /** A wrong call: the problem, similar names that exist, and where help is. */
    @Override
    public int handleParseException(ParameterException problem, String[] arguments) {
        CommandLine command = problem.getCommandLine();
        say(problem.getMessage());
        StringWriter suggestions = new StringWriter();
        UnmatchedArgumentException.printSuggestions(problem, new PrintWriter(suggestions, true));
        streams.err().print(suggestions);
        return pointToHelp(command);
    }

    private int pointToHelp(CommandLine command) {
        streams.err().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitStatus.UNUSABLE;
    }

    @Override
    public int handleExecutionException(Exception problem, CommandLine command, ParseResult parsed) {
        streams.out().flush();
        if (problem instanceof CallException) {
            say(problem.getMessage());
            return pointToHelp(command);
        }
        if (problem instanceof InputException || problem instanceof SceneException
            || problem instanceof ReplayException || problem instanceof UncheckedIOException) {
            say(problem.getMessage());
            return ExitStatus.UNUSABLE;
        }
        if (problem instanceof FailedException) {
            say(problem.getMessage());
            return ExitStatus.FAILED;
        }
        if (problem instanceof InterruptedException) {
            say("interrupted");
            return ExitStatus.FAILED;
        }
        say("this should not have happened:");
        problem.printStackTrace(streams.err());
        return ExitStatus.FAILED;
    }

    private void say(String message) {
        streams.err().println("steward: " + TextFormat.plain(message));
    }
}
