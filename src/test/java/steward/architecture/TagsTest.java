package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaConstructor;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.properties.HasAnnotations;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
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
import steward.match.TestSize;

/**
 * Tests that ask {@link TestSize}, themselves or by what they call, carry the tag {@code sized}, so that
 * {@code gradle campaigns} runs them too. What starts a process or a browser and lacks the tag fails in
 * {@code quickTest}, in whose JVM no process can be started.
 */
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class TagsTest {

    @Test
    void whatHasASizeSaysSoButForWhatIsPlanted() throws ClassNotFoundException {
        Class<?> ofLab = Class.forName("steward.lab.cli.LabCommandsTest");
        JavaClasses tests = ArchConfiguration.withThreadLocalScope(imports -> {
            imports.setClassResolverArguments("org.junit.jupiter");           // nothing is asked of our own classes
            return House.importHomesOf(TestSize.class, TagsTest.class, ofLab);
        });
        Set<JavaCodeUnit> sized = callersOf(tests.get(TestSize.class));
        Set<String> untagged = new TreeSet<>();
        for (JavaClass type : tests) {
            boolean always = type.getCodeUnits().stream()
                .anyMatch(unit -> isRunBeforeTests(unit) && sized.contains(unit));
            for (JavaMethod test : type.getMethods()) {
                if (test.isMetaAnnotatedWith(Testable.class) && (always || sized.contains(test)) && !saysSo(test)
                        && !saysSo(type)) {
                    untagged.add(type.getSimpleName() + "." + test.getName());
                }
            }
        }
        assertEquals(Set.of("Planted.asksItself", "Planted.hasAHelperAsk", "PlantedBefore.usesTheSize"), untagged);
    }

    /** Returns what calls a class, directly or through others. */
    private static Set<JavaCodeUnit> callersOf(JavaClass type) {
        Set<JavaCodeUnit> callers = new HashSet<>();
        Deque<JavaAccess<?>> open = new ArrayDeque<>(type.getAccessesToSelf());
        while (!open.isEmpty()) {
            JavaCodeUnit caller = open.remove().getOrigin();
            if (callers.add(caller)) {
                open.addAll(caller.getAccessesToSelf());
            }
        }
        return callers;
    }

    private static boolean isRunBeforeTests(JavaCodeUnit unit) {
        return unit instanceof JavaConstructor || unit.getName().equals("<clinit>")
            || unit.isAnnotatedWith(BeforeEach.class) || unit.isAnnotatedWith(BeforeAll.class);
    }

    /** Campaigns are large anyway. */
    private static boolean saysSo(HasAnnotations<?> annotated) {
        return Stream.concat(annotated.tryGetAnnotationOfType(Tag.class).stream(),
            annotated.tryGetAnnotationOfType(Tags.class).stream().flatMap(all -> Stream.of(all.value())))
            .anyMatch(tag -> Set.of("sized", "campaign").contains(tag.value()));
    }

    /** Abstract, so that JUnit does not run it; what carries the tag, or asks nothing, stands in other classes. */
    abstract static class Planted {

        @ParameterizedTest
        @ValueSource(ints = {10, 20})
        void asksItself(int whole) {
            assertTrue(TestSize.of(1, whole) > 0);
        }

        @Test
        void hasAHelperAsk() {
            assertTrue(size() > 0);
        }

        static int size() {
            return TestSize.of(1, 2);
        }
    }

    /** Abstract too; its size is asked before each test. */
    abstract static class PlantedBefore {
        private final int size = Planted.size();

        @Test
        void usesTheSize() {
            assertTrue(size > 0);
        }
    }
}
