package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import java.util.HashSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** A simple name stands for one thing: no two types of the three parts share one. */
class SimpleNamesTest {

    /** Names that two rooms still share. */
    private static final Set<String> SHARED =
        Set.of("Block", "Difference", "GameFacts", "LeagueJson", "RunCommand", "Standstill");

    private static Set<String> twice(Stream<String> names) {
        Set<String> once = new HashSet<>();
        return names.filter(name -> !once.add(name)).collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void noOtherNameIsTakenTwice() {
        assertEquals(new TreeSet<>(SHARED), twice(HouseClasses.all().stream().filter(JavaClass::isTopLevelClass)
            .map(JavaClass::getSimpleName).filter(name -> !name.equals("package-info"))));
    }

    @Test
    void aNameThatIsTakenTwiceIsFound() {
        assertEquals(Set.of("Wall"), twice(Stream.of("Wall", "Field", "Wall", "Wall")));
    }
}
