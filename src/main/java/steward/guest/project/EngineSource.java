package steward.guest.project;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.files.Folders;
import steward.files.InputException;
import steward.files.UserFolders;

/**
 * CodinGame's engine, built from a clone of its repository, for projects that name a version which no Maven repository
 * has. It is installed under the version that the project names, in a Maven repository of its own in Steward's cache,
 * once for each tag and commit. The clone is only read.
 *
 * @param repository Maven repository that has it
 * @param text       the version built, for people
 */
record EngineSource(Path repository, String text) {

    private static final Pattern TAG = Pattern.compile("v(\\d{1,6}(?:\\.\\d{1,6}){1,3})");
    /** Version in every pom.xml of the engine's repository; its own release replaces it. */
    private static final String UNRELEASED = "master-SNAPSHOT";
    private static final int COMMIT_SHOWN = 12;
    /** Word of Maven for the newest version. */
    private static final String NEWEST = "LATEST";
    /** Name of the folder of a build that is under way; after a day, of one that was killed. */
    private static final String MAKING = "making";
    private static final Duration KILLED = Duration.ofDays(1);

    /**
     * Builds the engine, or finds it built.
     *
     * @param clone  of the engine's repository
     * @param named  version that the project names
     * @param engine version to build in its place, or {@code null}
     */
    static EngineSource built(Path clone, String named, String engine, Consumer<String> told)
            throws IOException, InterruptedException {
        List<String> tags = git(clone, "tag", "-l").lines().toList();
        String tag = tag(tags, engine == null ? named : engine);
        if (engine != null && !tag.equals("v" + engine)) {
            throw new InputException("engine", "found " + engine + ", of which " + clone + " has no tag; its newest is "
                + tag(tags, NEWEST));
        }
        String commit = git(clone, "rev-parse", (tag.equals("HEAD") ? tag : "refs/tags/" + tag) + "^{commit}").strip();
        if (!git(clone, "ls-tree", commit, "engine/core/pom.xml").contains("pom.xml")) {
            throw new InputException("engine-source", "found no engine/core/pom.xml in " + tag + " of " + clone
                + ", expected a clone of " + SdkProject.ENGINE_REPOSITORY);
        }
        String text = (tag.equals("HEAD") ? "the newest commit" : tag) + ", commit "
            + commit.substring(0, Math.min(COMMIT_SHOWN, commit.length()))
            + (tag.equals("v" + named) ? "" : ", in place of " + named
                + (engine == null ? ", which has no tag" : ""));
        Path folder = UserFolders.cache().resolve("engines").resolve(tag + "-" + commit + "-as-" + named);
        told.accept("engine: " + text);
        if (!Files.isDirectory(folder)) {
            build(clone, commit, named, folder, told);
        }
        return new EngineSource(folder.resolve("repository"), text);
    }

    /**
     * Returns the tag of a version, else the next later one, else the newest, which a version without a number is, too;
     * without tags, the newest commit.
     */
    static String tag(List<String> tags, String version) {
        List<String> sorted = tags.stream().filter(tag -> TAG.matcher(tag).matches())
            .sorted(Comparator.comparing(EngineSource::order)).toList();
        String order = order(version);
        return sorted.stream().filter(tag -> !order.isEmpty() && order(tag).compareTo(order) >= 0).findFirst()
            .orElse(sorted.isEmpty() ? "HEAD" : sorted.get(sorted.size() - 1));
    }

    /** A text that sorts as versions do. */
    private static String order(String tag) {
        StringBuilder order = new StringBuilder();
        for (Matcher number = Pattern.compile("\\d{1,9}").matcher(tag); number.find();) {
            order.append(String.format("%09d.", Integer.parseInt(number.group())));
        }
        return order.toString();
    }

    private static void build(Path clone, String commit, String named, Path folder, Consumer<String> told)
            throws IOException, InterruptedException {
        Files.createDirectories(folder.getParent());
        try (DirectoryStream<Path> begun = Files.newDirectoryStream(folder.getParent(), MAKING + "*")) {
            for (Path each : begun) {
                if (Files.getLastModifiedTime(each).toInstant().isBefore(Instant.now().minus(KILLED))) {
                    Folders.delete(each);
                }
            }
        }
        Path making = Files.createTempDirectory(folder.getParent(), MAKING);
        try {
            Path source = making.resolve("source");
            git(clone, "clone", "-q", "-n", clone.toAbsolutePath().toString(), source.toString());
            git(source, "checkout", "-q", commit);
            for (Path pom : poms(source)) {
                Files.writeString(pom, Files.readString(pom).replace(UNRELEASED, named));
            }
            List<String> words = new ArrayList<>(List.of("-f", source.resolve("pom.xml").toString(),
                "-DskipTests", "-Dgpg.skip", "-Dmaven.javadoc.skip", "-Dmaven.source.skip",
                "-Dmaven.repo.local=" + making.resolve("repository"), "install"));
            String problem = ProjectBuild.maven(clone, words, told);
            if (problem != null) {
                throw new InputException("engine-source", "the engine cannot be built: "
                    + ProjectBuild.errors(problem));
            }
            Folders.delete(source);
            Files.move(making, folder, StandardCopyOption.ATOMIC_MOVE);
        } catch (FileSystemException taken) {
            if (!Files.isDirectory(folder)) {          // else another adoption was faster: its engine is as good
                throw taken;
            }
        } finally {
            Folders.delete(making);
        }
    }

    private static List<Path> poms(Path source) throws IOException {
        try (Stream<Path> files = Files.walk(source)) {
            return files.filter(file -> file.getFileName().toString().equals("pom.xml")).toList();
        }
    }

    private static String git(Path folder, String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(ProjectBuild.program("git", "git").toString(), "-C",
            folder.toString()));
        command.addAll(List.of(words));
        ProjectBuild.Said said = ProjectBuild.run(command);
        if (!said.done()) {
            throw new InputException("engine-source", "git cannot read " + folder + ": "
                + said.text().strip().replaceAll("\\s*\\R\\s*", " | "));
        }
        return said.text();
    }
}
