package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import steward.Internal;
import steward.examples.MatchInside;
import steward.examples.SimulatorBot;

/** The lists that people read are the lists that the code keeps: rooms in CONTRIBUTING, types in docs/api.md. */
class PublishedListsTest {

    private static final Pattern QUOTED = Pattern.compile("`([^`]+)`");

    private static JavaClasses main;

    @BeforeAll
    static void importClasses() {
        main = HouseClasses.all();
    }

    /**
     * Names between back quotes, in the first column unless told otherwise; {@code .x} stands beside or below a name.
     */
    private static List<String> rooms(String page) {
        List<String> rooms = new ArrayList<>();
        for (String row : rows(page)) {
            String full = null;
            Matcher names = QUOTED.matcher(row.split("\\|")[1]);
            while (names.find()) {
                String name = names.group(1);
                if (name.startsWith(".")) {
                    String above = full.contains(".") ? full.substring(0, full.lastIndexOf('.')) : full;
                    name = House.ROOMS.contains(full + name) ? full + name : above + name;
                } else {
                    full = name;
                }
                rooms.add(name);
            }
        }
        return rooms;
    }

    private static List<String> rows(String page) {
        return page.lines().filter(line -> line.startsWith("| `")).toList();
    }

    @Test
    void contributingListsTheRoomsInTheirOrder() throws IOException {
        String page = Files.readString(Path.of("CONTRIBUTING.md"));
        String section = page.substring(page.indexOf("## Where things are"));
        int end = section.indexOf("\n## ", 1);

        assertEquals(House.ROOMS.subList(1, House.ROOMS.size()), rooms(end < 0 ? section : section.substring(0, end)));
    }

    @Test
    void typesForUsersAreThere() throws IOException {
        TreeSet<String> listed = listed(), missing = new TreeSet<>(listed);
        main.stream().filter(type -> type.isTopLevelClass() && isReachable(type)).map(JavaClass::getName)
            .forEach(missing::remove);

        assertEquals(new TreeSet<>(), missing);
        assertTrue(listed.size() > 40, "the page is read");
    }

    private static TreeSet<String> listed() throws IOException {
        TreeSet<String> listed = new TreeSet<>();
        for (String row : rows(Files.readString(Path.of("docs/api.md")))) {
            String room = row.split("`")[1];
            Matcher names = QUOTED.matcher(row.substring(row.lastIndexOf('|', row.length() - 2)));
            while (names.find()) {
                listed.add(room + "." + names.group(1));
            }
        }
        return listed;
    }

    /** A signature of a listed type names only listed types, unless the method is marked. */
    @Test
    void whatIsListedNeedsNothingElse() throws IOException {
        TreeSet<String> listed = listed();

        assertEquals(new TreeSet<>(), namesBeyond(listed));
        listed.remove("steward.scene.Plan");
        assertTrue(namesBeyond(listed).contains("steward.game.GameSetup.plan: steward.scene.Plan"), "it can fail");
    }

    private static TreeSet<String> namesBeyond(Set<String> listed) {
        TreeSet<String> beyond = new TreeSet<>();
        for (JavaClass type : main) {
            if (listed.contains(outermost(type).getName()) && isReachable(type)) {
                Stream.concat(type.getSuperclass().stream(), type.getInterfaces().stream())
                    .forEach(above -> add(beyond, type.getName() + " is one", above, listed));
                for (JavaCodeUnit unit : type.getCodeUnits()) {
                    if (isReachable(unit)) {
                        Stream.of(Stream.of(unit.getReturnType()), unit.getParameterTypes().stream(),
                            unit.getExceptionTypes().stream()).flatMap(each -> each)
                            .forEach(named -> add(beyond, type.getName() + "." + unit.getName(), named, listed));
                    }
                }
                for (JavaField field : type.getFields()) {
                    if (isReachable(field)) {
                        add(beyond, type.getName() + "." + field.getName(), field.getType(), listed);
                    }
                }
            }
        }
        return beyond;
    }

    private static void add(Set<String> beyond, String where, JavaType named, Set<String> listed) {
        for (JavaClass each : named.getAllInvolvedRawTypes()) {
            JavaClass type = each.getBaseComponentType();
            if (type.getPackageName().startsWith("steward")
                && !(listed.contains(outermost(type).getName()) && isReachable(type))) {
                beyond.add(where + ": " + type.getName());
            }
        }
    }

    private static JavaClass outermost(JavaClass type) {
        return type.getEnclosingClass().map(PublishedListsTest::outermost).orElse(type);
    }

    private static boolean isReachable(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC)
            && type.getEnclosingClass().map(PublishedListsTest::isReachable).orElse(true);
    }

    private static boolean isReachable(JavaMember member) {
        Set<JavaModifier> modifiers = member.getModifiers();
        return (modifiers.contains(JavaModifier.PUBLIC) || modifiers.contains(JavaModifier.PROTECTED))
            && !modifiers.contains(JavaModifier.SYNTHETIC) && !modifiers.contains(JavaModifier.BRIDGE)
            && !member.isAnnotatedWith(Internal.class);
    }

    @Test
    void examplesUseOnlyWhatIsListed() throws IOException {
        TreeSet<String> listed = listed();
        TreeSet<String> used = new TreeSet<>();
        for (JavaClass example : new ClassFileImporter().importClasses(SimulatorBot.class, MatchInside.class)) {
            example.getDirectDependenciesFromSelf().stream().map(each -> outermost(each.getTargetClass()))
                .filter(type -> type.getPackageName().startsWith("steward")).map(JavaClass::getName)
                .filter(name -> !name.startsWith("steward.examples.")).forEach(used::add);
        }
        assertTrue(used.contains("steward.match.Referee"), "dependencies are seen");

        used.removeAll(listed);
        assertEquals(new TreeSet<>(), used);
    }
}
