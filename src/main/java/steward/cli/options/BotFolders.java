package steward.cli.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import steward.files.OutputFiles;

/**
 * Option that gives a bot a working folder. It stands after the option that names the bot and applies to that bot. In
 * commands whose bots are not options it applies to all of them.
 */
public final class BotFolders {

    private static final String IN = "--in";
    private static final List<String> NAMING = List.of("--bot", "--against", "--fill");

    private final CallCheck check = CallCheck.withHelp();

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = IN, paramLabel = "DIR", description = "The working folder of the bot before this option: it "
        + "is started there, and paths in its command begin there (default: the current folder).")
    private List<String> folders = new ArrayList<>();

    /** The folder where bots are no options; the current one if none is named. */
    public Path folder() {
        check.that(folders.size() <= 1, IN + ": found " + folders.size() + " folders, expected one");
        return folders.isEmpty() ? Path.of("") : folder(folders.get(0));
    }

    /** The folders of the bots that an option names, in their order. */
    public List<Path> of(String option) {
        List<Path> found = new ArrayList<>();
        String bot = null;
        boolean taken = false;
        int next = 0;
        // The parser keeps the values of each option; which stood after which, only the words of the call say.
        List<String> words = command.commandLine().getParseResult().originalArgs();
        for (String word : words.stream().takeWhile(each -> !each.equals("--")).toList()) {
            String name = optionOf(word);
            if (NAMING.contains(name)) {
                bot = name;
                taken = false;
                if (name.equals(option)) {
                    found.add(Path.of(""));
                }
            } else if (name.equals(IN)) {
                String typed = folders.get(next++);
                check.that(bot != null, IN + ": found '" + typed + "' before any bot, expected it after the " + option
                    + " that it is for");
                check.that(!taken, IN + ": found '" + typed + "' for a bot that has one already, expected one folder");
                taken = true;
                if (bot.equals(option)) {
                    found.set(found.size() - 1, folder(typed));
                }
            }
        }
        return found;
    }

    /** Returns the long name of the option that a word of the call is, also as {@code -qb BOT}; empty for others. */
    private String optionOf(String word) {
        if (word.startsWith("--")) {
            return word.split("=", 2)[0];
        }
        for (int k = 1; word.startsWith("-") && k < word.length(); k++) {
            OptionSpec option = command.findOption(word.charAt(k));
            if (option == null || option.arity().max() > 0) {
                return option == null ? "" : option.longestName();
            }
        }
        return "";
    }

    private Path folder(String typed) {
        Path folder = OutputFiles.path(typed);
        check.that(Files.isDirectory(folder), IN + ": found '" + typed + "', expected a folder that is there");
        return folder.toAbsolutePath().normalize();
    }
}
