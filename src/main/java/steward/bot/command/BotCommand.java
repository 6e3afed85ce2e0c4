package steward.bot.command;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A bot as it is given on the command line: {@code [NAME=][builtin:|json:|codingame:]COMMAND}, for example {@code
 * racer.py}, {@code blue=python3 racer.py} or {@code builtin:racer}.
 *
 * @param name  the name before the {@code =} (letters, digits, dot, underscore, hyphen), or {@code null}
 * @param words the program and its arguments, split as by {@link CommandLine}; for {@link Prefix#BUILTIN} the bot's
 *     name and further arguments; at least one word
 */
public record BotCommand(String name, Prefix prefix, List<String> words) {

    /** Kind of bot, as the word before the colon selects it. */
    public enum Prefix {
        /** A bot bundled with the program; uses the JSON protocol. */
        BUILTIN,
        /** A program that uses the JSON protocol; usually also the meaning of a command without a prefix. */
        JSON,
        /** A program that uses CodinGame's text protocol. */
        CODINGAME;

        /** The prefix as it is written, with its colon. */
        public String written() {
            return name().toLowerCase(Locale.ROOT) + ":";
        }
    }

    /** The form of a bot command, for messages. */
    public static final String FORM = "[NAME=][builtin:|json:|codingame:]COMMAND";

    private static final int LONGEST_NAME = 100;
    private static final int SHOWN = 20;

    private static final Pattern NAMED = Pattern.compile("([\\p{L}\\p{M}\\p{N}._-]+)=(.*)", Pattern.DOTALL);

    private static final Pattern VARIABLE = Pattern.compile("[A-Z_][A-Z0-9_]*");
    private static final Pattern UNKNOWN_PREFIX = Pattern.compile("([A-Za-z]+):.*", Pattern.DOTALL);

    /** @throws IllegalArgumentException when there is no word */
    public BotCommand {
        Objects.requireNonNull(prefix, "prefix");
        words = List.copyOf(words);
        if (words.isEmpty()) {
            throw new IllegalArgumentException("a bot command needs at least one word");
        }
    }

    /** Parses as {@link #parse(String, Prefix)} does; a program without a prefix uses JSON. */
    public static BotCommand parse(String text) {
        return parse(text, Prefix.JSON);
    }

    /**
     * Reads a bot command.
     *
     * @param usual what a bot without a prefix is
     * @throws IllegalArgumentException when it has no command or cannot be split into words; the message says where
     */
    public static BotCommand parse(String text, Prefix usual) {
        Matcher named = NAMED.matcher(text);
        String name = named.matches() ? named.group(1) : null;
        if (name != null && name.length() > LONGEST_NAME) {
            throw new IllegalArgumentException("bot '" + name.substring(0, SHOWN) + "...': found a name of "
                + name.length() + " characters, expected at most " + LONGEST_NAME);
        }
        checkName(text, named.matches());
        String rest = named.matches() ? named.group(2) : text;
        Prefix written = writtenPrefix(rest);
        int start = text.length() - rest.length() + (written == null ? 0 : written.written().length());
        List<String> words = split(text, start);
        if (words.isEmpty()) {
            String after = start == 0 ? "" : " after '" + text.substring(0, start) + "'";
            throw new IllegalArgumentException(
                "bot '" + text + "': there is no command" + after + "; expected " + FORM);
        }
        return new BotCommand(name, written == null ? usual : written, words);
    }

    /**
     * A bot command whose words a shell has split already: name and prefix may stand before the first of them.
     *
     * @param usual what a bot without a prefix is
     * @throws IllegalArgumentException when there is no command
     */
    public static BotCommand of(List<String> words, Prefix usual) {
        String first = words.isEmpty() ? "" : words.get(0);
        Matcher named = NAMED.matcher(first);
        String name = named.matches() ? named.group(1) : null;
        checkName(first, named.matches());
        String rest = named.matches() ? named.group(2) : first;
        Prefix written = writtenPrefix(rest);
        String program = written == null ? rest : rest.substring(written.written().length());
        List<String> all = new ArrayList<>(words.subList(Math.min(1, words.size()), words.size()));
        if (!program.isEmpty()) {
            all.add(0, program);
        }
        if (all.isEmpty() || first.isEmpty()) {
            throw new IllegalArgumentException("bot '" + first + "': there is no command; expected " + FORM);
        }
        return new BotCommand(name, written == null ? usual : written, all);
    }

    /** A single word without a prefix, before {@code =} and a known prefix, can only be meant as a name. */
    private static void checkName(String text, boolean named) {
        if (!named && isMisnamed(text)) {
            throw new IllegalArgumentException("bot '" + text + "': found the name '"
                + text.substring(0, text.indexOf('=')) + "', expected one of letters, digits, dots, underscores and "
                + "hyphens");
        }
    }

    private static boolean isMisnamed(String text) {
        int equals = text.indexOf('=');
        return equals >= 0 && writtenPrefix(text) == null && !text.substring(0, equals).contains(" ")
            && writtenPrefix(text.substring(equals + 1)) != null;
    }

    private static Prefix writtenPrefix(String text) {
        return Arrays.stream(Prefix.values()).filter(each -> text.startsWith(each.written())).findFirst().orElse(null);
    }

    private static List<String> split(String text, int start) {
        try {
            // Blanks replace what was already read, so that columns in messages are those of the whole text.
            return CommandLine.split(" ".repeat(start) + text.substring(start));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("bot '" + text + "', " + e.getMessage(), e);
        }
    }

    /** The given name; without one, the name of the builtin bot, the script or the program, found in a folder. */
    public String displayName(Path folder) {
        String program = nameGiver(folder);
        String last = program.substring(program.lastIndexOf('/') + 1);
        return name != null ? name : last.isEmpty() ? program : last;
    }

    /** Returns the word that names the bot: a file after an interpreter, otherwise the program. */
    public String nameGiver(Path folder) {
        String program = words.get(0);
        return prefix == Prefix.BUILTIN || !ProgramFinder.runsOthers(program) ? program
            : words.stream().skip(1).filter(word -> ProgramFinder.isFile(word, folder)).findFirst().orElse(program);
    }

    /**
     * The program to start and its arguments, checked: the builtin bot is known, the program exists and is executable.
     *
     * @param folder where the program and its scripts are found
     * @throws IllegalArgumentException when it cannot be started; the message says what was found and what was expected
     */
    public List<String> resolve(Path folder) {
        return resolve(BuiltinBots.installed(), folder);
    }

    /** As {@link #resolve(Path)}, with builtin bots of the caller's choice. */
    List<String> resolve(BuiltinBots builtins, Path folder) {
        try {
            if (prefix == Prefix.BUILTIN) {
                return builtins.command(words.get(0), words.subList(1, words.size()));
            }
            ProgramFinder.check(words, folder);
            return words;
        } catch (IllegalArgumentException e) {
            String shown = toString();
            throw new IllegalArgumentException("bot " + (shown.indexOf('\'') < 0 ? "'" + shown + "'" : shown) + ": "
                + e.getMessage() + hint(), e);
        }
    }

    /**
     * Checks that the bot is not a builtin one of another game; programs of other people are not known.
     *
     * @throws IllegalArgumentException if it is; the message says which play the game
     */
    public void checkPlays(String game) {
        BuiltinBots builtins = BuiltinBots.installed();
        if (prefix == Prefix.BUILTIN && !builtins.game(words.get(0)).equals(game)) {
            List<String> others = builtins.of(game);
            throw new IllegalArgumentException("bot '" + this + "': found a bot of " + builtins.game(words.get(0))
                + ", expected one of " + game + (others.isEmpty() ? ", which has no builtin bots"
                    : "; there are: " + String.join(", ", others)));
        }
    }

    private String hint() {
        if (name != null && VARIABLE.matcher(name).matches() && words.size() > 1) {
            return "; a variable is set by env: 'env " + name + "=" + CommandLine.quote(words) + "'";
        }
        boolean odd = prefix != Prefix.BUILTIN && UNKNOWN_PREFIX.matcher(words.get(0)).matches();
        return !odd ? "" : "; the known prefixes are "
            + Arrays.stream(Prefix.values()).map(Prefix::written).collect(Collectors.joining(" "));
    }

    /** The command as it could have been written, quoted where necessary. */
    @Override
    public String toString() {
        String line = CommandLine.quote(words);
        boolean clear = prefix == Prefix.JSON && writtenPrefix(line) == null && !NAMED.matcher(line).matches()
            && !isMisnamed(line);
        return (name == null ? "" : name + "=") + (clear ? "" : prefix.written()) + line;
    }
}
