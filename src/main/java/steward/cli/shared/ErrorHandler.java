package steward.cli.shared;

import java.io.UncheckedIOException;
import java.util.List;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.Remedied;
import steward.replay.ReplayException;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/** Handler that turns exceptions of a command into a message and an exit status. */
public final class ErrorHandler implements IParameterExceptionHandler, IExecutionExceptionHandler {

    private static final String OPTION = "'(--?[^'=]+)[^']*'(?: \\([^)]*\\))?";

    /** Messages of the library about options, and those in their place. */
    private static final List<Translation> TRANSLATIONS = List.of(
        Translation.of("^Invalid value for option " + OPTION + ": ('.*') is not a boolean$",
            "$1: found $2, expected no value"),
        Translation.of("^Invalid value for option " + OPTION + ": ", "$1: "),
        Translation.of("^option " + OPTION + " should be specified only once$", "$1: found twice, expected once"),
        Translation.of("^Missing required parameter for option '(--?[^']+)' \\(([^)]*)\\)$",
            "$1: found nothing, expected $2"),
        Translation.of("^Missing required parameters: '([^']+)', '([^']+)'$", "found no $1 and no $2, expected both"),
        Translation.of("^Expected parameter for option '(--?[^']+)' but found ('.*')$",
            "$1: found $2, expected its value"));

    private record Translation(Pattern message, String words) {

        static Translation of(String message, String words) {
            return new Translation(Pattern.compile(message, Pattern.DOTALL), words);
        }
    }

    private final Streams streams;

    public ErrorHandler(Streams streams) {
        this.streams = streams;
    }

    /** A wrong call: the problem, similar names that exist, and where help is. */
    @Override
    public int handleParseException(ParameterException problem, String[] arguments) {
        answer(problem.getCommandLine(), List.of(arguments));
        say(said(problem));
        return pointToHelp(problem.getCommandLine());
    }

    private static void answer(CommandLine command, List<String> arguments) {
        if (command.getCommand() instanceof RefusedCall refused) {
            refused.refuse(arguments);
        }
    }

    private static String said(ParameterException problem) {
        CommandLine command = problem.getCommandLine();
        if (problem instanceof UnmatchedArgumentException unknown) {
            return UnknownWord.message(command, unknown.getUnmatched().get(0));
        }
        if (problem instanceof MissingParameterException missing) {
            for (String word : command.getUnmatchedArguments()) {
                if (word.startsWith("-")) {
                    return UnknownWord.message(command, word);         // the right name is probably what is missing
                }
            }
            String words = translated(missing.getMessage());
            return words.equals(missing.getMessage()) ? missing(missing.getMissing().get(0)) : words;
        }
        return translated(problem.getMessage());
    }

    private static String missing(ArgSpec argument) {
        String name = name(argument);
        return "found no " + name + ", expected " + (argument.isPositional() ? "one"
            : argument.arity().max() > 0 ? name + " " + argument.paramLabel() : "it");
    }

    private static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }

    /** A message of the library in the words that all other messages have; one that is ours already as it is. */
    static String translated(String message) {
        String words = message;
        for (Translation each : TRANSLATIONS) {
            words = each.message().matcher(words).replaceFirst(each.words());
        }
        return words;
    }

    private int pointToHelp(CommandLine command) {
        streams.err().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return ExitStatus.UNUSABLE;
    }

    @Override
    public int handleExecutionException(Exception problem, CommandLine command, ParseResult parsed) {
        streams.out().flush();
        if (problem instanceof CallException) {
            answer(command, parsed.originalArgs());
            say(problem.getMessage());
            return pointToHelp(command);
        }
        if (problem instanceof InputException || problem instanceof SceneException
            || problem instanceof ReplayException || problem instanceof UncheckedIOException) {
            answer(command, parsed.originalArgs());
            say(withOptions(problem, command));
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
        if (OutOfMemory.isBehind(problem)) {
            return OutOfMemory.report(streams);
        }
        say("this should not have happened:");
        problem.printStackTrace(streams.err());
        return ExitStatus.FAILED;
    }

    /** The message of a library, with the options of this command that it is about. */
    private static String withOptions(Exception problem, CommandLine command) {
        boolean named = problem instanceof InputException input && has(command, input.parameter());
        List<String> remedies = !(problem instanceof Remedied known) ? List.of() : known.remedies().stream()
            .filter(each -> has(command, each.option())).map(each -> "--" + each.option() + " " + each.effect())
            .toList();
        return (named ? "--" : "") + problem.getMessage() + (remedies.isEmpty() ? "" : "; ")
            + String.join(", ", remedies);
    }

    private static boolean has(CommandLine command, String option) {
        return option != null && command.getCommandSpec().findOption("--" + option) != null;
    }

    private void say(String message) {
        streams.err().println(streams.errColour().bad("steward:") + " " + TextFormat.plain(message));
    }
}
