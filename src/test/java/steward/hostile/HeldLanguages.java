package steward.hostile;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.command.ProgramFinder;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;
import steward.bot.process.BotProcess;

/**
 * Asks bots with threads, timers and signals in several languages the same, held while another is asked and not, and
 * prints how long their answers took. {@code --turns N} of each (200), {@code --level light}, {@code --languages
 * java,go} some of the languages. Exit status 1 if answers differ.
 */
public final class HeldLanguages {

    private static final Path SOURCES = Path.of("src/test/hostile/threads");
    private static final long LIMIT = TimeUnit.SECONDS.toNanos(60);
    private static final double NANOS_PER_MS = 1e6;

    private HeldLanguages() {
    }

    /** Answers of one bot, and the times. */
    private record Answers(List<String> said, List<Long> nanos) {
    }

    /** Reads the options, asks, prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<String> options = List.of(arguments);
        int turns = options.contains("--turns") ? Integer.parseInt(options.get(options.indexOf("--turns") + 1)) : 200;
        SandboxLevel level = SandboxLevel.valueOf((options.contains("--level")
            ? options.get(options.indexOf("--level") + 1) : "light").toUpperCase(Locale.ROOT));
        Path work = Files.createTempDirectory(Path.of(System.getProperty("java.io.tmpdir")), "threads-");
        System.out.println("held: " + HoldMeans.text(Isolation.at(level).holding(HoldPolicy.ALWAYS)));
        System.out.println("| language | asked | never held: median, worst ms | always held: median, worst ms | |");
        System.out.println("|---|---:|---:|---:|---|");
        boolean equal = true;
        List<String> languages = options.contains("--languages")
            ? List.of(options.get(options.indexOf("--languages") + 1).split(",")) : all();
        for (String language : languages) {
            List<String> command = command(language, work);
            if (command == null) {
                System.out.println("| " + language + " | - | - | - | skipped: there is no "
                    + (language.equals("dotnet") ? "dotnet and mcs" : language) + " |");
                continue;
            }
            List<Answers> found = ask(command, level, turns);
            boolean same = found.get(0).said().equals(found.get(1).said());
            equal &= same;
            for (int turn = 0; turn < turns && !same; turn++) {
                if (!found.get(0).said().get(turn).equals(found.get(1).said().get(turn))) {
                    System.out.println(language + ", turn " + turn + ": never held: " + found.get(0).said().get(turn)
                        + ", always held: " + found.get(1).said().get(turn));
                    break;
                }
            }
            System.out.println("| " + language + " | " + turns + " | " + times(found.get(0)) + " | "
                + times(found.get(1)) + " | " + (same ? "equal" : "DIFFERENT") + " |");
        }
        System.exit(equal ? 0 : 1);
    }

    /** Interpreters and compilers, and every JVM where systems have them. */
    private static List<String> all() throws IOException {
        List<String> languages = new ArrayList<>(List.of("java", "node", "go", "python3", "g++", "rustc", "dotnet"));
        Path machines = Path.of("/usr/lib/jvm");
        if (Files.isDirectory(machines)) {
            try (Stream<Path> folders = Files.list(machines)) {
                folders.filter(folder -> !Files.isSymbolicLink(folder)).map(folder -> folder.resolve("bin/java"))
                    .filter(Files::isExecutable).map(Path::toString).sorted().forEach(languages::add);
            }
        }
        return languages;
    }

    private static List<String> command(String language, Path work) throws IOException, InterruptedException {
        Path program = ProgramFinder.find(language);
        if (program == null) {
            return null;
        }
        boolean java = program.getFileName().toString().equals("java");
        String source = SOURCES.resolve(java ? "Threads.java" : "threads." + switch (language) {
            case "node" -> "js";
            case "python3" -> "py";
            case "rustc" -> "rs";
            case "g++" -> "cpp";
            case "dotnet" -> "cs";
            default -> language;
        }).toAbsolutePath().toString();
        if (java) {                                          // once, and not by each of the bots
            boolean compiled = ToolProvider.getSystemJavaCompiler().run(null, null, null, "-proc:none", "-d",
                work.toString(), source) == 0;
            return compiled ? List.of(program.toString(), "-cp", work.toString(), "Threads") : null;
        }
        if (language.equals("node") || language.equals("python3")) {
            return List.of(program.toString(), source);
        }
        if (language.equals("dotnet")) {
            return dotnet(program, source, work);
        }
        Path built = work.resolve("threads-" + language);
        List<String> words = new ArrayList<>(List.of(program.toString(), "-o", built.toString(), source));
        words.addAll(1, language.equals("go") ? List.of("build") : List.of("-O"));
        words.addAll(language.equals("g++") ? List.of("-pthread") : List.of());
        ProcessBuilder builder = new ProcessBuilder(words);
        builder.environment().put("GOFLAGS", "-mod=mod");
        return builder.inheritIO().start().waitFor() == 0 ? List.of(built.toString()) : null;
    }

    /** A program for any version of .NET, by Mono's compiler: one of .NET's own wants a project and packages. */
    private static List<String> dotnet(Path program, String source, Path work)
            throws IOException, InterruptedException {
        Path compiler = ProgramFinder.find("mcs");
        Path built = work.resolve("threads.exe");
        if (compiler == null || new ProcessBuilder(compiler.toString(), "-out:" + built, source).inheritIO().start()
                .waitFor() != 0) {
            return null;
        }
        Files.writeString(work.resolve("threads.runtimeconfig.json"), """
            {"runtimeOptions": {"rollForward": "LatestMajor",
              "framework": {"name": "Microsoft.NETCore.App", "version": "3.1.0"},
              "configProperties": {"System.Globalization.Invariant": true}}}
            """);
        return List.of(program.toString(), built.toString());
    }

    /** Never held and always, asked in turns: while one is asked, the other waits. */
    private static List<Answers> ask(List<String> command, SandboxLevel level, int turns) {
        List<HoldPolicy> policies = List.of(HoldPolicy.NEVER, HoldPolicy.ALWAYS);
        List<BotProcess> bots = policies.stream().map(policy -> new BotProcess(policy.word(), new Launch(command,
            Isolation.at(level).withoutMemoryLimit().holding(policy), List.of()),
            BotProcess.DEFAULT_GRACE_MS)).toList();
        List<Answers> found = List.of(new Answers(new ArrayList<>(), new ArrayList<>()),
            new Answers(new ArrayList<>(), new ArrayList<>()));
        try {
            Answer answer = new Answer();
            for (int turn = 0; turn < turns; turn++) {
                byte[] line = (7919 * turn + "\n").getBytes(StandardCharsets.UTF_8);
                for (int k = 0; k < bots.size(); k++) {
                    if (bots.get(k).ask(line, line.length, 1, LIMIT, answer) != Player.Ending.ANSWERED) {
                        throw new IllegalStateException(command + ": " + answer.fault() + " " + answer.stderr());
                    }
                    found.get(k).said().add(answer.text());
                    found.get(k).nanos().add(answer.nanos());
                }
            }
        } finally {
            bots.forEach(BotProcess::close);
        }
        return found;
    }

    /** Without the first, which includes the start. */
    private static String times(Answers found) {
        List<Long> sorted = found.nanos().stream().skip(1).sorted().toList();
        return String.format(Locale.ROOT, "%.2f, %.2f", sorted.get(sorted.size() / 2) / NANOS_PER_MS,
            sorted.get(sorted.size() - 1) / NANOS_PER_MS);
    }
}
