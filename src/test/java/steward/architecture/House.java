package steward.architecture;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.cli.Main;
import steward.cli.shared.Lab;
import steward.game.Game;

/** The classes of the three parts, wherever they were compiled to, the rooms that they are in, and what they touch. */
final class House {

    /** Names of the parts' source sets, lowest first. */
    static final List<String> PARTS = List.of("engine", "main", "lab");

    static final JavaClasses CLASSES = importHomesOf(Game.class, Main.class, Lab.find().orElseThrow().getClass());

    /**
     * Rooms in the order of CONTRIBUTING, lowest first. The root package, which holds only what marks the others, is
     * the lowest of all and has no name.
     */
    static final List<String> ROOMS = rooms(SourceText.section("CONTRIBUTING.md", "Where things are"));

    static final List<Touch> TOUCHES = touches(CLASSES);

    private House() {
    }

    /**
     * A class or member that a class uses.
     *
     * @param name of the class; {@code class#member} for a member, {@code changing-static} for a class that has one
     */
    record Touch(JavaClass origin, JavaClass target, String name) {

        private Touch(JavaClass origin, JavaClass target) {
            this(origin, target.getBaseComponentType(), target.getBaseComponentType().getName());
        }

        private Touch(JavaAccess<?> access) {
            this(access.getOriginOwner(), access.getTargetOwner(),
                access.getTargetOwner().getName() + "#" + access.getName());
        }

        @Override
        public String toString() {
            return origin.getName() + " -> " + name;
        }
    }

    /** Returns what classes touch, each of them itself too. */
    static List<Touch> touches(JavaClasses classes) {
        return classes.stream().flatMap(type -> Stream.of(
            Stream.of(new Touch(type, type)),
            type.getDirectDependenciesFromSelf().stream().map(each -> new Touch(type, each.getTargetClass())),
            type.getAccessesFromSelf().stream().map(Touch::new),
            type.getCodeUnitReferencesFromSelf().stream().map(Touch::new),
            type.getFields().stream().map(each -> each.getModifiers())
                .filter(each -> each.contains(JavaModifier.STATIC) && !each.contains(JavaModifier.FINAL))
                .map(each -> new Touch(type, type, "changing-static"))).flatMap(each -> each)).distinct().toList();
    }

    /** Returns the place of a class in the order of rooms; -1 if its room is not listed. */
    static int level(JavaClass type) {
        return ROOMS.indexOf(room(type));
    }

    /** Returns the package without the root; empty for the root itself. */
    static String room(JavaClass type) {
        return type.getPackageName().replaceFirst("^steward(\\.|$)", "");
    }

    static JavaClass outermost(JavaClass type) {
        return type.getEnclosingClass().map(House::outermost).orElse(type);
    }

    /** Names between back quotes in the first column; {@code .x} stands below a name, or else beside it. */
    private static List<String> rooms(String section) {
        Set<String> existing = CLASSES.stream().map(House::room).collect(Collectors.toSet());
        List<String> rooms = new ArrayList<>(List.of(""));
        for (String row : rows(section)) {
            String full = "";
            for (String name : quoted(row.split("\\|")[1])) {
                full = name.startsWith(".") ? full : name;
                rooms.add(full.equals(name) ? name : existing.contains(full + name) ? full + name
                    : full.replaceFirst("\\.\\w+$", "") + name);
            }
        }
        return rooms;
    }

    /** Returns rows of tables of a page that begin with a name. */
    static List<String> rows(String page) {
        return page.lines().filter(line -> line.startsWith("| `")).toList();
    }

    /** Returns what a text has between back quotes. */
    static List<String> quoted(String text) {
        return Pattern.compile("`([^`]+)`").matcher(text).results().map(found -> found.group(1)).toList();
    }

    /** Returns the classes that were compiled to the places of some classes. */
    static JavaClasses importHomesOf(Class<?>... types) {
        List<Path> homes = new ArrayList<>();
        for (Class<?> type : types) {
            try {
                homes.add(Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()));
            } catch (URISyntaxException problem) {
                throw new IllegalStateException(problem);
            }
        }
        return new ClassFileImporter().importPaths(homes);
    }
}
