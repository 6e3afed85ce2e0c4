package steward.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * A build that depends on what is published, the folder of {@code gradlew repository}: the programs of docs/library.md
 * are compiled and run with what its POMs name, and nothing else.
 */
@Tag("campaign")
class PublishedTest {

    private static final Path REPOSITORY = Path.of("build/repository/steward");
    private static final Pattern PROGRAM = Pattern.compile("```java\\n(import .*?public class (\\w+) .*?)```",
        Pattern.DOTALL);

    @TempDir
    private Path folder;

    private record Dependency(String group, String module, String version, boolean optional) {
    }

    /** Published file of a module, such as {@code .pom}; the folder has one version. */
    private static Path published(String module, String ending) throws IOException {
        try (Stream<Path> versions = Files.list(REPOSITORY.resolve(module))) {
            Path version = versions.findAny().orElseThrow();
            return version.resolve(module + "-" + version.getFileName() + ending);
        }
    }

    private static List<Dependency> dependencies(String module) throws Exception {
        Element pom = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(published(module, ".pom").toFile()).getDocumentElement();
        assertEquals(module, text(pom, "artifactId"));
        NodeList all = pom.getElementsByTagName("dependency");
        return IntStream.range(0, all.getLength()).mapToObj(k -> (Element) all.item(k)).map(each -> new Dependency(
            text(each, "groupId"), text(each, "artifactId"), text(each, "version"),
            each.getElementsByTagName("optional").getLength() > 0)).toList();
    }

    private static String text(Element parent, String name) {
        return parent.getElementsByTagName(name).item(0).getTextContent();
    }

    /** The class path of a module; jars of others with what they need are those of the class path of the tests. */
    private static Set<String> classPath(String module) throws Exception {
        Set<String> path = new LinkedHashSet<>();
        path.add(published(module, ".jar").toAbsolutePath().toString());
        for (Dependency each : dependencies(module)) {
            if (each.group().equals("steward")) {
                path.addAll(classPath(each.module()));
            } else if (!each.optional()) {
                List<String> found = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                    .filter(jar -> jar.contains(each.module() + "-" + each.version())
                        || each.group().startsWith("tools.jackson") && jar.contains("jackson-")).toList();
                assertTrue(!found.isEmpty(), () -> "no jar of " + each);
                path.addAll(found);
            }
        }
        return path;
    }

    private Path program(String name) throws IOException {
        Matcher programs = PROGRAM.matcher(Files.readString(Path.of("docs/library.md")));
        while (programs.find()) {
            if (programs.group(2).equals(name)) {
                return Files.writeString(folder.resolve(name + ".java"), programs.group(1));
            }
        }
        throw new AssertionError("docs/library.md has no program " + name);
    }

    private List<String> compiled(String name, String module) throws Exception {
        String path = String.join(File.pathSeparator, classPath(module));
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-cp", path, "-d",
            folder.toString(), program(name).toString()));
        return List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
            path + File.pathSeparator + folder, name);
    }

    private static String run(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        return said;
    }

    @Test
    void thePomsNameWhatIsNeeded() throws Exception {
        assertEquals("tools.jackson.core:jackson-databind", dependencies("steward-engine").stream()
            .map(each -> each.group() + ":" + each.module()).reduce("", String::concat));
        List<Dependency> steward = dependencies("steward");
        assertEquals("steward-engine", steward.get(0).module());
        assertTrue(steward.stream().anyMatch(each -> each.module().equals("artemis-server") && each.optional()));
        String page = Files.readString(Path.of("docs/library.md"));
        assertTrue(page.contains("'steward:steward-engine:" + steward.get(0).version() + "'"), "the page's version");
        for (Dependency each : steward) {
            assertTrue(each.version().matches("[0-9].*"), each::toString);
        }
    }

    @Test
    void sourcesAndJavadocArePublished() throws IOException {
        for (String module : List.of("steward-engine", "steward")) {
            String type = module.equals("steward") ? "steward/contest/Contest" : "steward/physics/Bodies";
            try (JarFile sources = new JarFile(published(module, "-sources.jar").toFile());
                 JarFile javadoc = new JarFile(published(module, "-javadoc.jar").toFile())) {
                assertNotNull(sources.getEntry(type + ".java"), module);
                assertNotNull(javadoc.getEntry(type + ".html"), module);
            }
        }
    }

    @Test
    @Tag("process")
    void aBotThatSearchesNeedsTheEngineAlone() throws Exception {
        List<String> bot = compiled("Searcher", "steward-engine");
        List<String> match = new ArrayList<>(compiled("OneMatch", "steward"));
        match.add("searcher=codingame:" + String.join(" ", bot));
        match.add("builtin:racer");
        assertTrue(run(match).matches("searcher: rank (1\nracer: rank 2|2\nracer: rank 1)\n"));
        List<String> noWinner = new ArrayList<>(compiled("OneMatch", "steward"));
        noWinner.addAll(List.of("false", "false"));
        assertTrue(run(noWinner).contains("false-1: rank "), "a match of two bots that fail has no winner");
    }
}
