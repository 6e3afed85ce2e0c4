package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaConstructor;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.properties.HasAnnotations;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Tags;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.platform.commons.annotation.Testable;
import org.openqa.selenium.chrome.ChromeDriver;
import steward.bot.process.BotProcess;
import steward.live.Browser;
import steward.match.TestSize;

/**
 * Tests that start a process carry the tag {@code process}, those that start a browser the tag {@code browser}, at the
 * test or at its class, so that {@code gradle quickTest} can leave them out; those that ask {@link TestSize} the tag
 * {@code sized}, so that {@code gradle campaigns} runs them too.
 *
 * <p>Calls are followed through the sources of the tests, from a test and from what is run around it. They are not
 * followed through the program, whose input alone decides whether it starts a bot: a test that has it do so and lacks
 * the tag fails in {@code quickTest}, in whose JVM no process can be started.
 */
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class TagsTest {

    private static final String BROWSERS = "org.openqa.selenium.";

    private static JavaClasses all;
    /** Classes of the program that use processes themselves, and those that have one of them as a field, by name. */
    private static Set<String> starters;

    @BeforeAll
    static void importClasses() {
        all = ArchConfiguration.withThreadLocalScope(imports -> {
            imports.setClassResolverArguments("org.junit.jupiter");           // nothing is asked of our own classes
            return new ClassFileImporter().importPaths(HouseClasses.homesOfTests().stream().map(Path::of).toList());
        });
        starters = new HashSet<>();
        boolean grows = true;
        while (grows) {
            grows = starters.addAll(HouseClasses.all().stream().filter(TagsTest::isStarter).map(JavaClass::getName)
                .toList());
        }
    }

    private static boolean isStarter(JavaClass type) {
        return type.getDirectDependenciesFromSelf().stream().anyMatch(to -> isProcess(to.getTargetClass()))
            || type.getFields().stream().anyMatch(field -> starters.contains(field.getRawType().getName()));
    }

    private static boolean isProcess(JavaClass type) {
        return type.isEquivalentTo(Process.class) || type.isEquivalentTo(ProcessBuilder.class);
    }

    /** The tags of what a call of this class starts, or of the size that it asks for. */
    private static Set<String> startedBy(JavaClass type) {
        if (type.getName().startsWith(BROWSERS)) {
            return Set.of("browser");
        }
        if (type.isEquivalentTo(TestSize.class)) {
            return Set.of("sized");
        }
        return isProcess(type) || starters.contains(type.getName()) ? Set.of("process") : Set.of();
    }

    @Test
    void whatStartsSomethingCarriesTheTag() {
        assertEquals(new TreeSet<>(), untagged(all.stream().filter(type -> !isPlanted(type)).toList()));
    }

    @Test
    void whatIsPlantedIsFound() {
        assertEquals(new TreeSet<>(Set.of("Planted.startsItself: process", "Planted.hasAHelperStart: process",
            "Planted.hasACallbackStart: process", "Planted.looksAtAPage: browser", "Planted.hasASize: sized",
            "Around.isStartedBefore: process")),
            untagged(all.stream().filter(TagsTest::isPlanted).toList()));
    }

    @Test
    void theProgramsOwnWaysToStartAreKnown() {
        assertTrue(starters.containsAll(Set.of(BotProcess.class.getName(), Browser.class.getName())),
            starters::toString);
        assertTrue(starters.size() < 25, () -> "that many cannot be: " + starters);
    }

    private static boolean isPlanted(JavaClass type) {
        return type.getName().startsWith(TagsTest.class.getName() + "$");
    }

    /** Returns the missing tags: {@code Class.method: tag}. */
    private static Set<String> untagged(List<JavaClass> types) {
        Set<String> found = new TreeSet<>();
        for (JavaClass type : types) {
            for (JavaMethod test : type.getMethods()) {
                if (test.isMetaAnnotatedWith(Testable.class)) {
                    Set<String> started = started(test);
                    started.removeAll(tags(test));
                    started.removeAll(tags(type));
                    if (tags(test).contains("campaign")) {
                        started.remove("sized");              // it is large anyway
                    }
                    started.forEach(tag -> found.add(type.getSimpleName() + "." + test.getName() + ": " + tag));
                }
            }
        }
        return found;
    }

    private static Set<String> tags(HasAnnotations<?> annotated) {
        Set<String> values = new HashSet<>();
        annotated.tryGetAnnotationOfType(Tag.class).ifPresent(tag -> values.add(tag.value()));
        annotated.tryGetAnnotationOfType(Tags.class).ifPresent(tags -> List.of(tags.value())
            .forEach(tag -> values.add(tag.value())));
        return values;
    }

    /** The tags of all that is started by a test, by what is run around it, and by what they call. */
    private static Set<String> started(JavaMethod test) {
        Set<String> started = new TreeSet<>();
        Set<JavaCodeUnit> seen = new HashSet<>(Set.of(test));
        JavaClass own = test.getOwner();
        own.getCodeUnits().stream().filter(TagsTest::isRunAround).forEach(seen::add);
        own.getStaticInitializer().ifPresent(seen::add);
        Deque<JavaCodeUnit> open = new ArrayDeque<>(seen);
        while (!open.isEmpty()) {
            for (JavaAccess<?> access : open.remove().getAccessesFromSelf()) {
                JavaClass type = access.getTargetOwner();
                started.addAll(startedBy(type));
                JavaMember target = access.getTarget().resolveMember().orElse(null);
                if (target instanceof JavaCodeUnit called && all.contain(type.getName()) && seen.add(called)) {
                    open.add(called);
                }
                // Methods of a created object may be called back; test methods are called by JUnit alone.
                if (target instanceof JavaConstructor && all.contain(type.getName()) && !type.equals(own)) {
                    type.getMethods().stream().filter(method -> !method.isMetaAnnotatedWith(Testable.class))
                        .filter(seen::add).forEach(open::add);
                }
            }
        }
        return started;
    }

    private static boolean isRunAround(JavaCodeUnit unit) {
        return unit instanceof JavaConstructor || unit.isAnnotatedWith(BeforeEach.class)
            || unit.isAnnotatedWith(BeforeAll.class) || unit.isAnnotatedWith(AfterEach.class)
            || unit.isAnnotatedWith(AfterAll.class);
    }

    /** Abstract, as the next two, so that JUnit does not run it. */
    abstract static class Planted {

        @Test
        void startsItself() throws IOException {
            new ProcessBuilder("true").start();
        }

        @Test
        void hasAHelperStart() throws Exception {
            new Helper().call();
        }

        @Test
        void hasACallbackStart() {
            assertTrue(new Helper() instanceof Callable<?>);
        }

        @Test
        void looksAtAPage() {
            new ChromeDriver().get("about:blank");
        }

        @ParameterizedTest
        @ValueSource(ints = {10, 20})
        void hasASize(int whole) {
            assertTrue(TestSize.of(1, whole) > 0);
        }

        @Test
        @Tag("slow")
        @Tag("process")
        void startsAndSaysSo() throws Exception {
            Callable<Process> later = () -> new Helper().call();
            later.call();
        }

        @Test
        void startsNothing() {
            assertEquals(List.of(), List.of());
        }
    }

    private static final class Helper implements Callable<Process> {

        @Override
        public Process call() throws IOException {
            return new ProcessBuilder("true").start();
        }
    }

    abstract static class Around {

        private Process process;

        @BeforeEach
        void start() throws Exception {
            process = new Helper().call();
        }

        @Test
        void isStartedBefore() {
            assertTrue(process.isAlive());
        }
    }

    @Tag("process")
    abstract static class Tagged {

        @Test
        void startsInALambda() throws Exception {
            Callable<Process> later = () -> new ProcessBuilder("true").start();
            later.call();
        }
    }
}
