package steward.cli.options;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Option;
import steward.bot.command.ProgramFinder;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.BotEnvironment;
import steward.bot.isolation.ChosenLocale;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.ResourceLimits;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.text.NearestName;

/** Options for the isolation of bots from this machine and from each other. */
@OptionSection(value = "Isolation", help = "sandbox")
public final class SandboxOptions {

    /** How the warning begins that the usual level does not work here. */
    public static final String NOT_APART = "bots are not kept apart from this machine and each other";

    private static final String AUTO = "auto";
    private static final Pattern SIZE = Pattern.compile("([0-9]{1,18})([KMGT]?)B?", Pattern.CASE_INSENSITIVE);
    private static final String UNITS = "KMGT";
    private static final int UNIT_BITS = 10;
    private static final Pattern VARIABLE = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

    private final CallCheck check = CallCheck.withHelp();

    /** The words of {@code --sandbox}. */
    static final class Levels extends ArrayList<String> {
        Levels() {
            super(List.of(AUTO, "strict", "light", "off"));
        }
    }

    @Option(names = "--sandbox", paramLabel = "LEVEL", completionCandidates = Levels.class,
        description = "How bots are isolated: strict, light, off; or auto, which is light if that works and "
            + "otherwise off (default: auto; for 'worker' strict, which needs bwrap).")
    private String level;

    @Option(names = "--network", description = "Brings up the loopback device in the sandbox; there is no other.")
    private boolean network;

    @Option(names = "--memory", paramLabel = "SIZE", description = "How much memory a bot may use, such as 512M "
        + "or 2G. Without a control group, it limits the address space of each process. The JVM and Node need "
        + "gigabytes of that: 512M ends them at once.")
    private String memory;

    @Option(names = "--processes", paramLabel = "N",
        description = "How many processes and threads a bot may have (strict: 512).")
    private Long processes;

    @Option(names = "--file-size", paramLabel = "SIZE", description = "How large each file of a bot may become "
        + "(strict: 1G).")
    private String fileSize;

    @Option(names = "--open-files", paramLabel = "N",
        description = "How many files each process may have open (strict: 4096).")
    private Long openFiles;

    @Option(names = "--env", paramLabel = "NAME", description = "Passes this environment variable to bots, even "
        + "if it looks like a secret or is not on the short list. Can be repeated.")
    private List<String> variables = new ArrayList<>();

    @Option(names = "--clean-env", description = "Passes only a short list of environment variables (PATH, HOME, "
        + "LANG and the like), as strict always does.")
    private boolean cleanEnvironment;

    @Option(names = "--visible", paramLabel = "PATH",
        description = "Lets bots read this file or folder, which strict would hide. Can be repeated.")
    private List<String> visible = new ArrayList<>();

    @Option(names = "--hold", paramLabel = "burners|always|never",
        description = "Which bots are stopped while another bot is asked. burners (default at light and strict): "
            + "bots that have used more than a quarter of a processor out of turn, from then on. always: all "
            + "bots. never: bots may think on. Not with --no-deadline.")
    private HoldPolicy hold;

    /** The variables that bots are passed by name. */
    public List<String> variables() {
        return List.copyOf(variables);
    }

    /** True if it is said which bots are held. */
    public boolean isHold() {
        return hold != null;
    }

    /**
     * Supplies the isolation that the options ask for. Of {@code auto} without more it is found out, and a warning
     * given, only when bots are started: a call that is refused for another reason has tried nothing.
     *
     * @throws InputException if it cannot be had on this machine
     */
    public Supplier<Isolation> isolation(Streams streams) {
        return isolation(streams, AUTO);
    }

    /**
     * Supplies the isolation, with a usual level.
     *
     * @param usual the level where none is asked for, {@code auto} or {@code strict}
     */
    public Supplier<Isolation> isolation(Streams streams, String usual) {
        String word = level == null ? usual : level;
        check.that(new Levels().contains(word), "--sandbox: found '" + word + "', expected auto, strict, light or off"
            + NearestName.question(word, new Levels(), "'"));
        ResourceLimits limits = limits();
        BotEnvironment environment = environment();
        List<Path> shown = visiblePaths();
        HoldPolicy policy = hold(word);
        OneTime<Isolation> isolation = new OneTime<>(() -> found(streams, word, policy, limits, environment, shown));
        if (!word.equals(AUTO) || !limits.isNone() || !shown.isEmpty() || network) {
            isolation.get();
        }
        return isolation;
    }

    private HoldPolicy hold(String word) {
        check.that(hold != HoldPolicy.BURNERS || !word.equals(SandboxLevel.OFF.word()),
            "--hold burners: expected --sandbox light or strict with it: at off bots can hide what they use");
        return hold == null ? HoldPolicy.BURNERS : hold;
    }

    private Isolation found(Streams streams, String word, HoldPolicy policy, ResourceLimits limits,
                            BotEnvironment environment, List<Path> shown) {
        SandboxLevel used = used(word);
        check.that(used != SandboxLevel.OFF || limits.isNone(), limitName() + ": found no way to hold it at level off, "
            + "expected --sandbox light or strict" + (word.equals(AUTO) ? ", which do not work here" : ""));
        check.that(used == SandboxLevel.STRICT || shown.isEmpty(),
            "--visible: expected --sandbox strict with it: " + used.word() + " hides no files");
        shown.forEach(this::checkShown);
        check.that(!network || !word.equals(SandboxLevel.OFF.word()),
            "--network: expected --sandbox light or strict with it: off leaves bots the network of this machine");
        check.that(!network || used != SandboxLevel.LIGHT || ProgramFinder.find("ip") != null
            || SandboxSupport.isNative(), "--network: there is no program 'ip', which brings up the loopback device");
        String problem = word.equals(AUTO) ? SandboxSupport.problem(SandboxLevel.LIGHT) : null;
        if (problem != null) {
            streams.warn(NOT_APART + ": " + problem + "; run only bots you trust ('steward doctor' says more, "
                + "--sandbox off says nothing)");
        }
        Isolation found = new Isolation(used, network, used == SandboxLevel.STRICT
            ? limits.orElse(ResourceLimits.STRICT) : limits, environment, shown, List.of(), policy);
        if (used != SandboxLevel.OFF && !SandboxSupport.isNative()) {
            streams.warn("level " + used.word() + " has no filter of system calls here"
                + (HoldMeans.of(found) == HoldMeans.MEASURED ? ", and bots that compute while others are asked are not "
                + "held" : "") + ": " + SandboxSupport.NO_LAUNCHER);
        }
        if (used != SandboxLevel.OFF && level != null && SandboxSupport.isRoot()) {
            streams.warn("this is root, whose files are a bot's own: other people's bots want another user");
        }
        return found;
    }

    /** Gives what another supplier gave when it was first asked. */
    private static final class OneTime<T> implements Supplier<T> {

        private final Supplier<T> source;
        private T given;

        OneTime(Supplier<T> source) {
            this.source = source;
        }

        @Override
        public synchronized T get() {
            if (given == null) {
                given = source.get();
            }
            return given;
        }
    }

    private static SandboxLevel used(String word) {
        if (word.equals(AUTO)) {
            return SandboxSupport.usual();
        }
        SandboxLevel wanted = SandboxLevel.valueOf(word.toUpperCase(Locale.ROOT));
        String problem = SandboxSupport.problem(wanted);
        if (problem != null) {
            throw new InputException("--sandbox " + word + " does not work here: " + problem);
        }
        return wanted;
    }

    private ResourceLimits limits() {
        sizeRange("--memory", memory, ResourceLimits.LEAST_MEMORY);
        range("--processes", processes, ResourceLimits.LEAST_PROCESSES, ResourceLimits.MOST_PROCESSES);
        sizeRange("--file-size", fileSize, ResourceLimits.LEAST_FILE_SIZE);
        range("--open-files", openFiles, ResourceLimits.LEAST_OPEN_FILES, ResourceLimits.MOST_OPEN_FILES);
        return new ResourceLimits(number(size("--memory", memory)), number(processes),
            number(size("--file-size", fileSize)), number(openFiles));
    }

    private void range(String option, Long found, long least, long most) {
        check.range(option, found, least, most);
    }

    /** A size that is out of range is named as it was written, and its range in the largest units that fit. */
    private void sizeRange(String option, String text, long least) {
        Long bytes = size(option, text);
        check.that(bytes == null || CallCheck.isWithin(bytes, least, ResourceLimits.MOST_BYTES), option + ": found "
            + text + ", expected " + sizeText(least) + " to " + sizeText(ResourceLimits.MOST_BYTES));
    }

    /** A number of bytes as it is written in a call; in bytes if it is no multiple of a unit. */
    static String sizeText(long bytes) {
        long number = bytes;
        int unit = 0;
        while (unit < UNITS.length() && number >= 1L << UNIT_BITS && number % (1L << UNIT_BITS) == 0) {
            number >>= UNIT_BITS;
            unit++;
        }
        return number + (unit == 0 ? "" : UNITS.substring(unit - 1, unit));
    }

    private static long number(Long value) {
        return value == null ? 0 : value;
    }

    private String limitName() {
        return memory != null ? "--memory" : processes != null ? "--processes" : fileSize != null ? "--file-size"
            : "--open-files";
    }

    /** Bytes, or {@code null} where the option is not there. */
    private Long size(String option, String text) {
        if (text == null) {
            return null;
        }
        Matcher matcher = SIZE.matcher(text);
        check.that(matcher.matches(), option + ": found '" + text + "', expected a size such as 512M or 2G");
        int shift = matcher.group(2).isEmpty() ? 0
            : UNIT_BITS * (1 + UNITS.indexOf(matcher.group(2).toUpperCase(Locale.ROOT)));
        long number = Long.parseLong(matcher.group(1));
        return number > Long.MAX_VALUE >> shift ? Long.MAX_VALUE : number << shift;
    }

    private BotEnvironment environment() {
        for (String name : variables) {
            check.that(VARIABLE.matcher(name).matches(),
                "--env: found '" + name + "', expected the name of a variable");
            check.that(ChosenLocale.variable(name) != null, "--env: there is no variable '" + name + "'");
        }
        return new BotEnvironment(cleanEnvironment, variables);
    }

    /** Refuses folders that are the sandbox's own, and the whole of the machine. */
    private void checkShown(Path path) {
        check.that(!path.startsWith("/dev") && !path.startsWith("/proc"), "--visible: found '" + path
            + "', expected a path outside /dev and /proc, of which strict has its own");
        check.that(path.getNameCount() > 0, "--visible: found '" + path + "', expected the files or folders that the "
            + "bot needs");
    }

    private List<Path> visiblePaths() {
        List<Path> paths = new ArrayList<>();
        for (String text : visible) {
            try {
                Path path = Path.of(text).toAbsolutePath().normalize();
                check.that(!text.isBlank() && Files.exists(path),
                    "--visible: found '" + text + "', expected a file or folder that is there");
                paths.add(path);
            } catch (InvalidPathException problem) {
                check.that(false, "--visible: found '" + text + "', expected a file or folder that is there");
            }
        }
        return paths;
    }
}
