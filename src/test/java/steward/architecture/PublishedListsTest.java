package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import steward.Internal;
import steward.examples.MatchInside;
import steward.examples.SimulatorBot;

/** The lists that people read are those of the code: rooms and words in CONTRIBUTING, types, the map of the tour. */
class PublishedListsTest {

    // ---- docs/api.md: types for users ----

    private final Set<String> listed = listed();

    @Test
    void typesForUsersAreThere() {
        TreeSet<String> missing = new TreeSet<>(listed);
        House.CLASSES.stream().filter(type -> type.isTopLevelClass() && isReachable(type)).map(JavaClass::getName)
            .forEach(missing::remove);

        assertEquals(Set.of(), missing);
        assertTrue(listed.size() > 40, "the page is read");
    }

    private static TreeSet<String> listed() {
        TreeSet<String> listed = new TreeSet<>();
        for (String row : House.rows(SourceText.of("docs/api.md"))) {
            String room = House.quoted(row).get(0);
            House.quoted(row.substring(row.lastIndexOf('|', row.length() - 2)))
                .forEach(name -> listed.add(room + "." + name));
        }
        return listed;
    }

    /** A signature of a listed type names only listed types, unless the method is marked. */
    @Test
    void whatIsListedNeedsNothingElse() {
        assertEquals(Set.of(), namesBeyond());
        listed.remove("steward.scene.Plan");
        assertTrue(namesBeyond().contains("steward.game.GameSetup.plan: steward.scene.Plan"), "it can fail");
    }

    private TreeSet<String> namesBeyond() {
        TreeSet<String> beyond = new TreeSet<>();
        for (JavaClass type : House.CLASSES) {
            if (listed.contains(House.outermost(type).getName()) && isReachable(type)) {
                Stream.concat(type.getSuperclass().stream(), type.getInterfaces().stream())
                    .forEach(above -> add(beyond, type.getName() + " is one", above));
                type.getMembers().stream().filter(member -> isReachable(member)).forEach(member -> types(member)
                    .forEach(named -> add(beyond, type.getName() + "." + member.getName(), named)));
            }
        }
        return beyond;
    }

    /** Types that a signature names. */
    private static Stream<JavaType> types(JavaMember member) {
        return member instanceof JavaCodeUnit unit ? Stream.of(List.of(unit.getReturnType()), unit.getParameterTypes(),
            unit.getExceptionTypes()).flatMap(List::stream) : Stream.of(((JavaField) member).getType());
    }

    private void add(Set<String> beyond, String where, JavaType named) {
        for (JavaClass each : named.getAllInvolvedRawTypes()) {
            JavaClass type = each.getBaseComponentType();
            if (type.getPackageName().startsWith("steward")
                && !(listed.contains(House.outermost(type).getName()) && isReachable(type))) {
                beyond.add(where + ": " + type.getName());
            }
        }
    }

    private static boolean isReachable(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC)
            && type.getEnclosingClass().map(PublishedListsTest::isReachable).orElse(true);
    }

    private static boolean isReachable(JavaMember member) {
        Set<JavaModifier> modifiers = member.getModifiers();
        return !Collections.disjoint(modifiers, Set.of(JavaModifier.PUBLIC, JavaModifier.PROTECTED))
            && Collections.disjoint(modifiers, Set.of(JavaModifier.SYNTHETIC, JavaModifier.BRIDGE))
            && !member.isAnnotatedWith(Internal.class);
    }

    @Test
    void examplesUseOnlyWhatIsListed() {
        Set<String> used = House.touches(new ClassFileImporter().importClasses(SimulatorBot.class, MatchInside.class))
            .stream().map(touch -> House.outermost(touch.target()).getName())
            .filter(name -> name.matches("steward\\.(?!examples\\.).*")).collect(Collectors.toSet());
        assertTrue(used.contains("steward.match.Referee"), "dependencies are seen");

        used.removeAll(listed);
        assertEquals(Set.of(), used);
    }

    // ---- CONTRIBUTING: rooms, and words of names ----

    @Test
    void everyRoomThatExistsIsListedOnce() {
        Set<String> rooms = House.CLASSES.stream().map(House::room).collect(Collectors.toSet());

        assertEquals(List.copyOf(new TreeSet<>(rooms)), House.ROOMS.stream().sorted().toList());
    }

    /** Words that methods may have: hosts of a network, entries of a list. */
    private static final Set<String> FREE_IN_METHODS = Set.of("Host", "Entry");

    private static List<String> names() {
        return House.CLASSES.stream().filter(JavaClass::isTopLevelClass).map(JavaClass::getSimpleName)
            .filter(name -> !name.equals("package-info")).toList();
    }

    /** Names that have a word, with capitals between words; the first letter of a method counts as one. */
    private static Set<String> having(String word, List<String> names) {
        Predicate<String> whole = Pattern.compile("(?<![A-Z])" + word + "(?![a-z])|^" + word.toLowerCase(Locale.ROOT)
            + "(?![a-z])").asPredicate();
        return names.stream().filter(whole).collect(Collectors.toSet());
    }

    @Test
    void noNameIsTakenTwice() {
        List<String> names = names();
        assertEquals(List.of(), names.stream().filter(name -> Collections.frequency(names, name) > 1).toList());
    }

    /** The table in CONTRIBUTING: the word of names, its thing, words that no name has. */
    @Test
    void aThingHasOneWord() {
        List<String> types = names();
        List<String> methods = House.CLASSES.stream().flatMap(type -> type.getMethods().stream())
            .map(JavaMethod::getName).toList();
        List<String> rows = House.rows(SourceText.section("CONTRIBUTING.md", "One word for one thing"));
        assertEquals(4, rows.size());
        for (String row : rows) {
            String[] cells = row.split("\\|");
            assertNotEquals(Set.of(), having(House.quoted(cells[1]).get(0), types), row);
            assertNotEquals(List.of(), House.quoted(cells[3]), row);
            for (String other : House.quoted(cells[3])) {
                assertEquals(Set.of(), having(other, types), row);
                assertEquals(Set.of(), FREE_IN_METHODS.contains(other) ? Set.of() : having(other, methods), row);
            }
        }
        assertEquals(Set.of("FarGames", "GamesFar", "far", "farGames"), having("Far",
            List.of("FarGames", "Farming", "GamesFar", "Safari", "far", "farGames", "farming")));
    }

    // ---- the tour ----

    @Test
    void theMapIsThatOfTheCode() {
        String page = SourceText.of(HouseMap.PAGE.toString());
        assertEquals(HouseMap.withMap(page), page, "./gradlew house draws it anew");
    }

    @Test
    void eachWayIsShort() {
        List<Integer> files = Stream.of(SourceText.of(HouseMap.PAGE.toString()).split("\n## "))
            .map(part -> (int) part.lines().filter(line -> line.matches("\\| \\d+ \\| \\[`.*")).count())
            .filter(count -> count > 0).toList();
        assertEquals(3, files.size(), "a match, a league, a worker");
        assertTrue(files.stream().allMatch(count -> count <= 8), files::toString);
    }
}
