package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import steward.Internal;
import steward.game.Game;

/** The lists that people read are the lists that the code keeps: rooms in the README, types in docs/api.md. */
class PublishedListsTest {

    private static final Pattern QUOTED = Pattern.compile("`([^`]+)`");

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
    void theReadmeListsTheRoomsInTheirOrder() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        String section = readme.substring(readme.indexOf("## Where things are"));
        int end = section.indexOf("\n## ", 1);

        assertEquals(House.ROOMS.subList(1, House.ROOMS.size()), rooms(end < 0 ? section : section.substring(0, end)));
    }

    @Test
    void whatUsersMayBuildOnIsWhatCarriesNoMark() throws IOException, URISyntaxException {
        TreeSet<String> listed = new TreeSet<>();
        for (String row : rows(Files.readString(Path.of("docs/api.md")))) {
            String room = row.split("`")[1];
            Matcher names = QUOTED.matcher(row.substring(row.lastIndexOf('|', row.length() - 2)));
            while (names.find()) {
                listed.add(room + "." + names.group(1));
            }
        }
        TreeSet<String> unmarked = new TreeSet<>();
        for (JavaClass type : new ClassFileImporter().importPath(
                Path.of(Game.class.getProtectionDomain().getCodeSource().getLocation().toURI()))) {
            if (isForUsers(type)) {
                unmarked.add(type.getName());
            }
        }
        assertFalse(unmarked.contains("steward.replay.InputHash"), "a mark on a type counts");
        assertFalse(unmarked.contains("steward.physics.time.TimeOfImpact"), "a mark on a room counts");
        assertTrue(unmarked.size() > 40, "some are for users");

        assertEquals(unmarked, listed);
    }

    private static boolean isForUsers(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC) && type.isTopLevelClass()
            && !type.getSimpleName().equals("package-info") && !type.isEquivalentTo(Internal.class)
            && !type.isAnnotatedWith(Internal.class) && !type.getPackage().isAnnotatedWith(Internal.class);
    }
}
