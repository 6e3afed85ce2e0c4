package steward.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.tools.ToolProvider;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * A build that depends on what is published: the programs of docs/library.md are compiled and run with what the POMs
 * name, and nothing else.
 */
class PublishedTest {

    private static final Map<String, String> JARS = Map.of("steward-engine", "steward-engine.jar", "steward-bots",
        "steward-bots.jar", "steward", "steward-[0-9.]+\\.jar");
    private static final Pattern PROGRAM = Pattern.compile("```java\\n(import .*?public class (\\w+) .*?)```",
        Pattern.DOTALL);

    @TempDir
    private Path folder;

    private record Dependency(String group, String module, String version, boolean optional) {
    }

    private static List<Dependency> dependencies(String publication) throws Exception {
        Element pom = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(new File("build/publications/" + publication + "/pom-default.xml")).getDocumentElement();
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
        try (var jars = Files.list(Path.of("build/libs"))) {
            path.add(jars.filter(jar -> jar.getFileName().toString().matches(JARS.get(module))).findAny().orElseThrow()
                .toAbsolutePath().toString());
        }
        for (Dependency each : dependencies(module.replace("steward-", ""))) {
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
        assertEquals("tools.jackson.core:jackson-databind", dependencies("engine").stream()
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
