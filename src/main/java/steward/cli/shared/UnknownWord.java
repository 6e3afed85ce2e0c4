package steward.cli.shared;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import steward.text.NearestName;

/** Error messages for unknown words of a call, with the nearest known word. */
public final class UnknownWord {

    private UnknownWord() { }

    /** Names such a word of a command, and the nearest that would mean something. */
    static String message(CommandLine command, String word) {
        CommandSpec spec = command.getCommandSpec();
        if (word.startsWith("-")) {
            String name = word.replaceFirst("=.*", "");
            return "unknown option '" + name + "'" + question(name, spec.optionsMap().keySet());
        }
        if (!spec.subcommands().isEmpty()) {
            return command(word, spec.subcommands().keySet());
        }
        return "'" + word + "': found more than " + spec.qualifiedName() + " takes" + option(word, spec);
    }

    /** Says that there is no such command. */
    public static String command(String word, Collection<String> known) {
        return "unknown command '" + word + "'" + question(word, known);
    }

    /** The dashes of an option may have been forgotten, or the option before a bot. */
    private static String option(String word, CommandSpec spec) {
        List<String> options = new ArrayList<>(spec.optionsMap().keySet());
        return options.contains("--" + word) ? "; did you mean '--" + word + "'?"
            : options.contains("--bot") ? "; a bot stands behind --bot: --bot '" + word.replace("'", "") + "'" : "";
    }

    private static String question(String word, Collection<String> known) {
        return NearestName.of(word, known).map(near -> "; did you mean '" + near + "'?").orElse("");
    }
}
