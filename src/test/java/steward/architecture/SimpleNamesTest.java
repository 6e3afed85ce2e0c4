package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaMethod;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Simple names of the three parts: each stands for one thing, and each thing has one word in them. */
class SimpleNamesTest {

    /** A row of the table in CONTRIBUTING: the word of names, its thing, words that no name has. */
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `(\\w+)` \\| [^|]+ \\| ((?:`\\w+`(?:, )?)+) \\|$");

    /** Words that methods may have: hosts of a network, entries of a list. */
    private static final Set<String> FREE_IN_METHODS = Set.of("Host", "Entry");

    private static Stream<String> names() {
        return HouseClasses.all().stream().filter(JavaClass::isTopLevelClass).map(JavaClass::getSimpleName)
            .filter(name -> !name.equals("package-info"));
    }

    /** Names of methods, each with a capital. */
    private static Stream<String> methods() {
        return HouseClasses.all().stream().flatMap(type -> type.getMethods().stream()).map(JavaMethod::getName)
            .map(name -> Character.toUpperCase(name.charAt(0)) + name.substring(1));
    }

    private static Set<String> twice(Stream<String> names) {
        Set<String> once = new HashSet<>();
        return names.filter(name -> !once.add(name)).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Names that have a word, with capitals between words. */
    private static Set<String> having(String word, Stream<String> names) {
        Pattern whole = Pattern.compile("(?<![A-Z])" + word + "(?![a-z])");
        return names.filter(name -> whole.matcher(name).find()).collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void noNameIsTakenTwice() {
        assertEquals(Set.of(), twice(names()));
    }

    @Test
    void aThingHasOneWord() throws IOException {
        List<String> seen = names().toList();
        Matcher row = ROW.matcher(Files.readString(Path.of("CONTRIBUTING.md")));
        int rows = 0;
        while (row.find()) {
            rows++;
            assertFalse(having(row.group(1), seen.stream()).isEmpty(), row.group(1));
            for (String other : row.group(2).replace("`", "").split(", ")) {
                assertEquals(Set.of(), having(other, seen.stream()), "the word is " + row.group(1));
                assertEquals(Set.of(), FREE_IN_METHODS.contains(other) ? Set.of() : having(other, methods()),
                    "the word is " + row.group(1));
            }
        }
        assertEquals(4, rows);
    }

    @Test
    void whatIsForbiddenIsFound() {
        assertEquals(Set.of("Wall"), twice(Stream.of("Wall", "Field", "Wall", "Wall")));
        assertEquals(Set.of("FarGames", "GamesFar"), having("Far",
            Stream.of("FarGames", "Farming", "GamesFar", "Safari")));
    }
}
