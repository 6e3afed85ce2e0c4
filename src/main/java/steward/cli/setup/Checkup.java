package steward.cli.setup;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import steward.bot.command.BuiltinBots;
import steward.bot.command.Platform;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;
import steward.bot.isolation.ChosenLocale;
import steward.bot.isolation.ControlGroup;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.resident.RunningResident;
import steward.live.Browser;
import steward.text.TextFormat;

/** Checkup of this machine: which of its features Steward and bots can use. */
final class Checkup {

    /** How long a program may take to tell its version, in milliseconds. */
    private static final long PATIENCE_MS = 10_000;
    private static final String ARCHIVE = "-XX:SharedArchiveFile=";
    private static final long MEGABYTE = 1 << 20;
    /** Replays of a long series take some hundred megabytes. */
    private static final long ENOUGH_MEGABYTES = 200;

    private final List<Item> items = new ArrayList<>();

    /**
     * One checked item.
     *
     * @param about  a heading that several share
     * @param works  whether it can be used
     * @param detail the version, or why it cannot be used
     */
    record Item(String about, String name, boolean works, String detail) { }

    private Checkup() { }

    /** All of it; takes some seconds, since programs are started. */
    static List<Item> all() throws InterruptedException {
        Checkup checkup = new Checkup();
        checkup.java();
        checkup.isolation();
        checkup.languages();
        String noBrowser = Browser.ofSystem().missing();
        checkup.add("watching", "browser", noBrowser == null, noBrowser == null ? "--open can show a page" : noBrowser
            + ": --watch and --view still work, open their page yourself");
        checkup.temporaryFolder();
        return checkup.items;
    }

    private void add(String about, String name, boolean works, String detail) {
        items.add(new Item(about, name, works, detail));
    }

    private void java() {
        add("java", "JDK", Runtime.version().feature() >= 17, Runtime.version() + ", "
            + System.getProperty("java.vendor") + ", " + System.getProperty("java.vm.name"));
        items.add(platform(Platform.here()));
        boolean fma = useFma();
        add("java", "fused multiply-add", fma, fma ? "in hardware"
            : "not in hardware, or unknown: the rungs compensated and exact are slow, their results the same");
        int processors = Runtime.getRuntime().availableProcessors();
        add("java", "processors", processors > 1, processors + (processors > 1 ? ""
            : ": bots and referee share it, so that a bot may be late through no fault of its own"));
        String archive = archive();
        add("java", "archive of classes", archive != null, archive == null
            ? "none: each start loads its classes one by one; the launcher makes one in ~/.cache/steward where it can"
            : archive);
        items.add(fileNames(System.getProperty("sun.jnu.encoding"), ChosenLocale.name()));
        resident();
        List<String> builtin = BuiltinBots.installed().names();
        add("java", "builtin bots", !builtin.isEmpty(), builtin.isEmpty()
            ? "not on the class path: run the installed program" : String.join(", ", builtin));
    }

    /** Rows of the resident referees: their clients, if compiled, and each that runs. */
    private void resident() {
        String launcher = System.getProperty("steward.launcher");
        boolean compiled = launcher != null
            && Files.isExecutable(Path.of(launcher).resolveSibling("../lib/steward-resident"));
        String running = RunningResident.all().stream().map(each -> "process " + each.pid() + " for matches from "
            + TextFormat.plain(each.folder()) + " (" + each.megabytes() + " MB; 'kill " + each.pid() + "' ends it)")
            .collect(Collectors.joining(", "));
        add("java", "resident referee", compiled, (compiled ? "steward-referee and steward-play are compiled"
            : "steward-referee and steward-play start 'steward' for each match: their client is not in this "
            + "installation, which needs a C compiler on Linux when it is made")
            + "; " + (running.isEmpty() ? "none runs" : running));
    }

    /** The file in which this start found its classes, or {@code null}. */
    private static String archive() {
        return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(argument -> argument.startsWith(ARCHIVE)).map(argument -> argument.substring(ARCHIVE.length()))
            .findFirst().orElse(null);
    }

    private static boolean useFma() {
        try {
            HotSpotDiagnosticMXBean bean = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class);
            return bean != null && Boolean.parseBoolean(bean.getVMOption("UseFMA").getValue());
        } catch (IllegalArgumentException unknown) {
            return false;
        }
    }

    private void isolation() throws InterruptedException {
        program("isolation", "setsid", "the processes that a bot starts are killed with it",
            "what a bot starts may outlive it", List.of("setsid", "true"));
        level(SandboxLevel.LIGHT, "bots are kept apart by namespaces of their own"
            + (SandboxSupport.isRoot() ? "; they own root's files, so do not run bots of strangers as root" : ""),
            "bots can stop, kill and read each other");
        level(SandboxLevel.STRICT, "bots see little of the file system and cannot write to it",
            "bots of strangers cannot be run safely");
        boolean quick = SandboxSupport.isNative();
        add("isolation", "launcher", quick, quick ? "a small program starts bots in a sandbox"
            : SandboxSupport.NO_LAUNCHER + ": a shell starts bots in a sandbox, which takes some milliseconds longer "
            + "for each");
        boolean filtered = SandboxSupport.isFiltered();
        add("isolation", "system calls", filtered, filtered ? "a filter keeps bots at light and strict from those that "
            + "no bot needs" : "bots can make all: " + (quick ? "this kernel has no filter" : "there is no launcher"));
        hold();
        String none = ControlGroup.problem();
        add("isolation", "control groups", none == null && ControlGroup.holdsLimits(), none != null
            ? none + ": --memory and --processes are limits of each process; systemd-run --user --scope -p "
            + "Delegate=yes steward ... delegates one"
            : ControlGroup.holdsLimits() ? "hold --memory and --processes, and can stop bots"
            : "can stop bots, but hold neither memory nor processes here: --memory and --processes are limits of each "
            + "process");
    }

    /** By what bots are stopped that compute while others are asked. */
    private void hold() {
        SandboxLevel usual = SandboxSupport.usual();
        HoldMeans means = HoldMeans.of(Isolation.at(usual));
        boolean holds = means == HoldMeans.INIT || means == HoldMeans.CONTROL_GROUP;
        add("isolation", "hold burners", holds, "bots that compute while others are asked are " + means.text()
            + " (sandbox " + usual.word() + ")");
    }

    private void level(SandboxLevel level, String good, String bad) {
        String problem = SandboxSupport.problem(level);
        add("isolation", "sandbox " + level.word(), problem == null, problem == null ? good : problem + ": " + bad);
    }

    private void languages() throws InterruptedException {
        version("python3", "python", "--version");
        version("node", "js", "--version");
        version("g++", "cpp", "--version");
        version("javac", "java", "-version");
    }

    private void version(String program, String language, String option) throws InterruptedException {
        program("bots", program, null, "'steward new " + language + "' writes a bot that cannot run here",
            List.of(program, option));
    }

    /**
     * @param good what it gives, or {@code null} for its first line
     * @param bad  what is lost without it
     */
    private void program(String about, String name, String good, String bad, List<String> trial)
            throws InterruptedException {
        if (ProgramFinder.find(name) == null) {
            add(about, name, false, "there is no such program: " + bad);
            return;
        }
        ProgramTrial tried = ProgramTrial.of(trial, PATIENCE_MS);
        String said = TextFormat.shorten(TextFormat.plain(tried.line()), 60);
        add(about, name, tried.works(), tried.works() ? good == null ? said : good
            : "does not work (" + (said.isEmpty() ? "status " + tried.status() : said) + "): " + bad);
    }

    private void temporaryFolder() throws InterruptedException {
        Path folder = Path.of(System.getProperty("java.io.tmpdir"));
        Path script = null;
        try {
            script = Files.createTempFile("steward-", ".sh");
            add("files", "temporary folder", true, folder + " can be written into");
            long free = Files.getFileStore(folder).getUsableSpace() / MEGABYTE;
            add("files", "space there", free >= ENOUGH_MEGABYTES, String.format(Locale.ROOT, "%,d MB free", free));
            Files.writeString(script, "#!/bin/sh\nexit 0\n");
            boolean run = script.toFile().setExecutable(true)
                && ProgramTrial.of(List.of(script.toString()), PATIENCE_MS).works();
            add("files", "programs there", run, run ? "can be run"
                : "cannot be run, perhaps it is mounted noexec: keep compiled bots elsewhere");
        } catch (IOException problem) {
            add("files", "temporary folder", false, folder + " cannot be written into (" + problem.getMessage()
                + "): bots cannot be started; name another one by -Djava.io.tmpdir in JAVA_OPTS");
        } finally {
            if (script != null && !script.toFile().delete()) {
                script.toFile().deleteOnExit();
            }
        }
    }

    /**
     * An item about names of files.
     *
     * @param encoding of the JVM
     * @param chosen   the locale of the launcher's choice, or {@code null}
     */
    static Item fileNames(String encoding, String chosen) {
        boolean all = "UTF-8".equals(encoding);
        return new Item("java", "names of files", all, !all ? encoding + ": files whose names have other letters "
            + "cannot be named; set LC_ALL=C.UTF-8" : chosen == null ? encoding
            : encoding + " by LC_ALL=" + chosen + ", since the locale has none; bots do not get it");
    }

    /** An item about the platform of a machine. */
    static Item platform(String platform) {
        boolean tried = platform.startsWith("linux");
        return new Item("java", "platform", tried, platform + (tried ? ": every command is tried on Linux"
            : ": untried; what should work of each command is in docs/platforms.md"));
    }
}
