package steward.architecture;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.cli.Main;
import steward.cli.shared.Lab;
import steward.game.Game;

/**
 * The classes of the three parts, wherever they were compiled to, the rooms that they are in, and what they touch. As a
 * program, {@code ./gradlew house}, it writes a map of them into the tour and prints how large parts and rooms are.
 */
public final class House {

    static final Path TOUR = Path.of("docs/tour.md");

    static final JavaClasses CLASSES = importHomesOf(Game.class, Main.class, Lab.find().orElseThrow().getClass());

    /**
     * Rooms in the order of CONTRIBUTING, lowest first. The root package, which holds only what marks the others, is
     * the lowest of all and has no name.
     */
    static final List<String> ROOMS = rooms(SourceText.section("CONTRIBUTING.md", "Where things are"));

    static final List<Touch> TOUCHES = touches(CLASSES);

    /** Order of rooms of the top level by the highest room within each. */
    private static final Comparator<String> HIGHEST_FIRST = Comparator.comparingInt(room ->
        -ROOMS.stream().map(House::topOf).toList().lastIndexOf(room));

    private House() {
    }

    /**
     * A class or member that a class uses.
     *
     * @param origin name of the class
     * @param target name of the other; {@code class#member} for a member, {@code changing-static} for a class that has
     *               a static field which is not final
     */
    record Touch(String origin, String target) {

        @Override
        public String toString() {
            return origin + " -> " + target;
        }
    }

    /** Returns what classes touch, each of them itself too. */
    static List<Touch> touches(JavaClasses classes) {
        return classes.stream().flatMap(type -> Stream.of(
            Stream.of(type.getName()),
            type.getDirectDependenciesFromSelf().stream().map(each -> each.getTargetClass().getBaseComponentType()
                .getName()),
            Stream.concat(type.getAccessesFromSelf().stream(), type.getCodeUnitReferencesFromSelf().stream())
                .map(each -> each.getTargetOwner().getName() + "#" + each.getName()),
            type.getFields().stream().map(each -> each.getModifiers())
                .filter(each -> each.contains(JavaModifier.STATIC) && !each.contains(JavaModifier.FINAL))
                .map(each -> "changing-static"))
            .flatMap(each -> each).map(target -> new Touch(type.getName(), target))).distinct().toList();
    }

    /** Returns the place of a class in the order of rooms; -1 if its room is not listed. */
    static int level(String type) {
        return ROOMS.indexOf(room(type));
    }

    /** Returns the package of a class or member without the root; empty for the root itself. */
    static String room(String type) {
        return type.replaceAll("^steward\\.|\\.?\\b(?:\\p{Lu}|package-info$).*", "");
    }

    /** Returns the name of the class that a class or member stands in, in a file of its own. */
    static String outermost(String type) {
        return type.replaceAll("[$#].*", "");
    }

    /** Names between back quotes in the first column; {@code .x} stands below a name, or else beside it. */
    private static List<String> rooms(String section) {
        Set<String> existing = CLASSES.stream().map(JavaClass::getPackageName).collect(Collectors.toSet());
        List<String> rooms = new ArrayList<>(List.of(""));
        for (String row : rows(section)) {
            String full = "";
            for (String name : quoted(row.split("\\|")[1])) {
                full = name.startsWith(".") ? full : name;
                rooms.add(full.equals(name) ? name : existing.contains("steward." + full + name) ? full + name
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
        return new ClassFileImporter().importUrls(Stream.of(types)
            .map(type -> type.getProtectionDomain().getCodeSource().getLocation()).toList());
    }

    public static void main(String[] arguments) throws IOException {
        Files.writeString(TOUR, withMap(Files.readString(TOUR)));
        sizes().forEach(System.out::println);
    }

    /**
     * Returns the page with the map of today in the place of the one in it. The highest part stands first, and beside
     * each room of the top level those that it rests on, without those that it reaches through another.
     */
    static String withMap(String page) {
        Map<String, Set<String>> uses = new TreeMap<>();
        TOUCHES.stream().filter(touch -> level(touch.target()) > 0).forEach(touch ->
            uses.computeIfAbsent(topOf(room(touch.origin())), room -> new TreeSet<>())
                .add(topOf(room(touch.target()))));
        uses.forEach((room, used) -> used.remove(room));
        String map = List.of("lab", "main", "engine").stream().map(part -> part + "\n" + uses.keySet().stream()
            .filter(room -> Files.isDirectory(Path.of("src/" + part + "/java/steward", room.replace('.', '/'))))
            .sorted(HIGHEST_FIRST).map(room -> String.format(Locale.ROOT, "    %-16s %s", room, direct(room, uses))
                .stripTrailing() + "\n").collect(Collectors.joining())).collect(Collectors.joining());
        return page.replaceFirst("(?s)(?<=```text\n).*?(?=```\n)", Matcher.quoteReplacement(map));
    }

    /** Name of a room of the top level; the lab's rooms are one level further in. */
    private static String topOf(String room) {
        return room.replaceFirst("^((lab\\.)?\\w+).*", "$1");
    }

    /** Returns the rooms that a room uses, without those that it reaches through another. */
    private static String direct(String room, Map<String, Set<String>> uses) {
        Set<String> further = new TreeSet<>();
        uses.get(room).forEach(each -> addUsed(each, uses, further));
        return uses.get(room).stream().filter(each -> !further.contains(each)).sorted(HIGHEST_FIRST)
            .collect(Collectors.joining(", "));
    }

    /** Adds all that a room rests on; each once, as the number of ways to it grows with every level. */
    private static void addUsed(String room, Map<String, Set<String>> uses, Set<String> reached) {
        uses.get(room).stream().filter(reached::add).forEach(next -> addUsed(next, uses, reached));
    }

    /** Returns how large the parts of the product and those of its tests are, a line each. */
    static List<String> sizes() {
        return Stream.of("engine", "main", "lab", "engineTest", "test", "labTest").map(House::size).toList();
    }

    /** Returns lines and files of a part, resources included, and how many classes its rooms have. */
    private static String size(String part) {
        Map<String, String> files = SourceText.ofKind("", "src/" + part);
        Map<String, Long> rooms = files.keySet().stream().filter(file -> file.endsWith(".java")).collect(
            Collectors.groupingBy(file -> file.replaceFirst("(src/\\w+/java/steward/?)?(.*)/.*", "$2"), TreeMap::new,
                Collectors.counting()));
        Map.Entry<String, Long> fullest = Collections.max(rooms.entrySet(), Map.Entry.comparingByValue());
        return String.format(Locale.ROOT, "%-10s  %6d lines  %4d files  %3d rooms  mean %.1f classes  fullest %d (%s)",
            part, files.values().stream().mapToLong(text -> text.lines().count()).sum(), files.size(), rooms.size(),
            rooms.values().stream().mapToLong(count -> count).average().orElseThrow(), fullest.getValue(),
            fullest.getKey());
    }
}
