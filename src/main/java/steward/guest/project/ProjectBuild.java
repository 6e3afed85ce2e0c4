package steward.guest.project;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.Launch;
import steward.bot.process.ProgramRun;
import steward.files.InputException;
import steward.files.Remedied.Remedy;

/**
 * Build of a referee's project with Maven, with the engine that the project names or another one.
 *
 * @param classPath the project first, absolute
 * @param engine    the engine if it was built from source, for people; or {@code null}
 */
record ProjectBuild(List<Path> classPath, String engine) {

    /** Newest engine on Maven Central. */
    private static final String PUBLISHED = "4.3.0";
    private static final Pattern COMMENT = Pattern.compile("<!--.*?-->", Pattern.DOTALL);
    private static final Pattern ENGINE = Pattern.compile(
        "<groupId>\\s*com\\.codingame\\.gameengine\\s*</groupId>\\s*<artifactId>\\s*core\\s*</artifactId>\\s*"
        + "<version>\\s*(?:\\$\\{([^}<]+)\\}|([^<]+?))\\s*</version>");
    private static final Pattern VERSION = Pattern.compile("[\\w.-]{1,40}");
    private static final String PART = "com\\.codingame\\.gameengine:[\\w-]+:(?:jar|pom):[\\w.-]+";
    /** Part of an engine that Maven has looked for in vain, now or a short time ago. */
    private static final Pattern NOT_TO_BE_HAD = Pattern.compile(
        "(?<=ould not find artifact )" + PART + "|" + PART + "(?= was not found in )");
    private static final Pattern OFFLINE = Pattern.compile("in offline mode|UnknownHostException|Unknown host"
        + "|Connection refused|Network is unreachable|Name or service not known|[Cc]onnect(ion)? timed out"
        + "|Temporary failure in name resolution|No route to host");
    /** Milliseconds for a first build, which fetches everything. */
    private static final long PATIENCE_MS = 900_000;
    private static final int MOST_ERRORS = 5;

    /** A program that has ended: whether it succeeded, and its output. */
    record Said(boolean done, String text) { }

    /**
     * Compiles a project.
     *
     * @param engine version of the engine in place of the project's, or {@code null}
     * @param source clone of the engine's repository to build that version from, or {@code null}
     */
    static ProjectBuild of(Path project, String engine, Path source, Consumer<String> told) {
        try {
            program("mvn", "Maven, or what it compiles to: target/classes with all jars in target/dependency");
            if (source == null) {
                return new ProjectBuild(compiled(project, engine, told), null);
            }
            String named = named(project);
            EngineSource built = EngineSource.built(source, named, engine, told);
            List<Path> classPath = new ArrayList<>();
            String problem = compile(project, List.of("-Dmaven.repo.local=" + built.repository()), classPath, told);
            if (problem != null) {
                throw new InputException(project + ": does not compile with the engine " + built.text() + ": "
                    + errors(problem));
            }
            return new ProjectBuild(classPath, built.text());
        } catch (IOException problem) {
            throw new InputException(project + ": cannot be built: " + problem);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new InputException(project + ": the build was interrupted");
        }
    }

    /** Compiles with an engine that a repository has. */
    private static List<Path> compiled(Path project, String engine, Consumer<String> told)
            throws IOException, InterruptedException {
        List<String> words = engine == null ? List.of() : List.of("-D" + property(project) + "=" + engine);
        List<Path> classPath = new ArrayList<>();
        String problem = compile(project, words, classPath, told);
        if (problem == null) {
            return classPath;
        }
        Matcher missing = NOT_TO_BE_HAD.matcher(problem);
        boolean absent = missing.find();
        boolean other = absent && engine == null && engine(project).group(1) != null
            && compile(project, List.of("-D" + property(project) + "=" + PUBLISHED), new ArrayList<>(), told) == null;
        throw refusal(project, problem, engine, other);
    }

    /** Compiles it and adds its class path; returns Maven's words if that fails, or {@code null}. */
    private static String compile(Path project, List<String> words, List<Path> classPath, Consumer<String> told)
            throws IOException, InterruptedException {
        Path found = project.resolve("target/steward-class-path.txt");
        List<String> all = new ArrayList<>(List.of("-f", project.resolve("pom.xml").toString()));
        all.addAll(words);
        all.addAll(List.of("compile", "dependency:build-classpath", "-Dmdep.outputFile=" + found));
        String problem = maven(project, all, told);
        if (problem == null) {
            classPath.add(project.resolve("target/classes"));
            Stream.of(Files.readString(found).strip().split(File.pathSeparator))
                .forEach(entry -> classPath.add(Path.of(entry)));
        }
        return problem;
    }

    /** Runs Maven; returns its words if it fails, or {@code null}. */
    static String maven(Path folder, List<String> words, Consumer<String> told)
            throws IOException, InterruptedException {
        List<String> all = new ArrayList<>(List.of(program("mvn", "Maven").toString(), "-q", "-B"));
        all.addAll(words);
        told.accept("running: " + String.join(" ", all));
        Said said = run(all);
        return said.done() ? null : said.text();
    }

    static Path program(String name, String expected) {
        Path program = ProgramFinder.find(name);
        if (program == null) {
            throw new InputException("found no " + name + " on the PATH, expected " + expected);
        }
        return program;
    }

    static Said run(List<String> words) throws IOException, InterruptedException {
        Path said = Files.createTempFile("steward-adopt", ".txt");
        Path errors = Files.createTempFile("steward-adopt", ".txt");
        try {
            OptionalInt status = ProgramRun.of(Launch.plain(words), said, errors, PATIENCE_MS);
            boolean done = status.orElse(-1) == 0;
            return new Said(done, Files.readString(said) + (done ? "" : Files.readString(errors))
                + (status.isPresent() ? "" : "it was ended after " + PATIENCE_MS / 60_000 + " minutes"));
        } finally {
            Files.delete(said);
            Files.delete(errors);
        }
    }

    private static Matcher engine(Path project) throws IOException {
        Matcher engine = ENGINE.matcher(COMMENT.matcher(Files.readString(project.resolve("pom.xml"))).replaceAll(""));
        if (!engine.find()) {
            throw new InputException(project.resolve("pom.xml") + ": found no version of the engine's core, expected a "
                + "project on the SDK");
        }
        return engine;
    }

    /** The property that has the version of the engine. */
    private static String property(Path project) throws IOException {
        String property = engine(project).group(1);
        if (property == null) {
            throw new InputException("engine", "found a pom.xml that writes the version of the engine out, expected a "
                + "property for it, or the source of the engine");
        }
        return property;
    }

    /** The version of the engine that a project names. */
    private static String named(Path project) throws IOException {
        Matcher engine = engine(project);
        String version = engine.group(2);
        if (version == null) {
            Matcher value = Pattern.compile("<" + Pattern.quote(engine.group(1)) + ">\\s*([^<]+?)\\s*</")
                .matcher(COMMENT.matcher(Files.readString(project.resolve("pom.xml"))).replaceAll(""));
            version = value.find() ? value.group(1) : "";
        }
        if (!VERSION.matcher(version).matches()) {
            throw new InputException(project.resolve("pom.xml") + ": found '" + version
                + "' for the version of the engine, expected one such as 4.5.0");
        }
        return version;
    }

    /**
     * Returns why a project was not compiled.
     *
     * @param said  what Maven wrote, whose first line may begin with colours
     * @param other whether it compiles with the newest engine that is published
     */
    static InputException refusal(Path project, String said, String engine, boolean other) {
        Matcher missing = NOT_TO_BE_HAD.matcher(said);
        if (!missing.find()) {
            return new InputException(project + ": its Maven failed: " + errors(said));
        }
        String part = missing.group();
        String version = part.substring(part.lastIndexOf(':') + 1);
        if (engine != null) {
            return new InputException("engine", "found " + engine + ", which needs " + part
                + ", which no repository has");
        }
        List<Remedy> remedies = new ArrayList<>();
        remedies.add(new Remedy("engine-source", "codingame-game-engine builds " + version + " from a clone of "
            + SdkProject.ENGINE_REPOSITORY));
        if (other) {
            remedies.add(new Remedy("engine", PUBLISHED + " compiles it too"));
        }
        return new InputException(project + ": needs " + part + ", which no repository has", remedies);
    }

    /** The errors of Maven in one line; a network that is missing is named first. */
    static String errors(String said) {
        List<String> errors = said.lines().filter(line -> line.matches(".*\\[ERROR\\] +\\S.*"))
            .map(line -> line.substring(line.indexOf("[ERROR]"))).limit(MOST_ERRORS).toList();
        return (OFFLINE.matcher(said).find() ? "Maven has no network, which it needs the first time: " : "")
            + (errors.isEmpty() ? said.strip().replaceAll("\\s*\\R\\s*", " | ") : String.join(" | ", errors));
    }
}
