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
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
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

    private static final JavaClasses ALL = ArchConfiguration.withThreadLocalScope(imports -> {
        imports.setClassResolverArguments("org.junit.jupiter");               // nothing is asked of our own classes
        return new ClassFileImporter().importPaths(HouseClasses.homesOfTests().stream().map(Path::of).toList());
    });

    @Test
    void whatHasASizeSaysSo() {
        assertEquals(Set.of(), untagged(type -> !isPlanted(type)));
    }

    @Test
    void whatIsPlantedIsFound() {
        assertEquals(Set.of("Planted.asksItself", "Planted.hasAHelperAsk"), untagged(TagsTest::isPlanted));
    }

    private static boolean isPlanted(JavaClass type) {
        return type.isEquivalentTo(Planted.class);
    }

    private static Set<String> untagged(Predicate<JavaClass> which) {
        Set<String> found = new TreeSet<>();
        for (JavaClass type : ALL) {
            for (JavaMethod test : type.getMethods()) {
                if (which.test(type) && test.isMetaAnnotatedWith(Testable.class) && !saysSo(test) && !saysSo(type)
                        && hasASize(test)) {
                    found.add(type.getSimpleName() + "." + test.getName());
                }
            }
        }
        return found;
    }

    /** Campaigns are large anyway. */
    private static boolean saysSo(HasAnnotations<?> annotated) {
        Set<String> tags = new HashSet<>();
        annotated.tryGetAnnotationOfType(Tag.class).ifPresent(tag -> tags.add(tag.value()));
        annotated.tryGetAnnotationOfType(Tags.class).ifPresent(all -> List.of(all.value())
            .forEach(tag -> tags.add(tag.value())));
        return tags.contains("sized") || tags.contains("campaign");
    }

    private static boolean hasASize(JavaMethod test) {
        Set<JavaCodeUnit> seen = new HashSet<>(Set.of(test));
        test.getOwner().getStaticInitializer().ifPresent(seen::add);
        test.getOwner().getCodeUnits().stream().filter(unit -> unit instanceof JavaConstructor
            || unit.isAnnotatedWith(BeforeEach.class) || unit.isAnnotatedWith(BeforeAll.class)).forEach(seen::add);
        Deque<JavaCodeUnit> open = new ArrayDeque<>(seen);
        while (!open.isEmpty()) {
            for (JavaAccess<?> access : open.remove().getAccessesFromSelf()) {
                if (access.getTargetOwner().isEquivalentTo(TestSize.class)) {
                    return true;
                }
                if (access.getTarget().resolveMember().orElse(null) instanceof JavaCodeUnit called
                        && ALL.contain(access.getTargetOwner().getName()) && seen.add(called)) {
                    open.add(called);
                }
            }
        }
        return false;
    }

    /** Abstract, so that JUnit does not run it. */
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

        private static int size() {
            return TestSize.of(1, 2);
        }

        @Test
        @Tag("slow")
        @Tag("sized")
        void asksAndSaysSo() {
            assertTrue(size() > 0);
        }

        @Test
        void asksNothing() {
            assertEquals(List.of(), List.of());
        }
    }
}
