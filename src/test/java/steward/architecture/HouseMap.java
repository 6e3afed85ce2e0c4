package steward.architecture;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Map of the three parts, drawn from the compiled classes: each room of the top level and the rooms that it rests on,
 * without those that it reaches through another. {@code ./gradlew house} writes it into the tour and prints how large
 * parts and rooms are.
 */
public final class HouseMap {

    static final Path PAGE = Path.of("docs/tour.md");
    private static final String BEGIN = "```text\n";
    private static final String END = "```\n";

    private HouseMap() {
    }

    public static void main(String[] arguments) throws IOException {
        Files.writeString(PAGE, withMap(Files.readString(PAGE)));
        for (String part : HouseClasses.parts().keySet()) {
            System.out.println(size(part));
        }
    }

    /** Returns the page with the map of today in the place of the one in it. */
    static String withMap(String page) {
        int begin = page.indexOf(BEGIN) + BEGIN.length();
        return page.substring(0, begin) + draw() + page.substring(page.indexOf(END, begin));
    }

    /** Draws the map: highest part first. */
    static String draw() {
        Map<String, Map<String, Set<String>>> parts = new LinkedHashMap<>();
        Map<String, Set<String>> uses = new TreeMap<>();
        HouseClasses.parts().forEach((part, type) -> {
            Map<String, Set<String>> rooms = new TreeMap<>();
            for (JavaClass each : HouseClasses.all().that(HouseClasses.in(type))) {
                Set<String> used = rooms.computeIfAbsent(room(each), name -> new TreeSet<>());
                for (Dependency dependency : each.getDirectDependenciesFromSelf()) {
                    JavaClass target = dependency.getTargetClass().getBaseComponentType();
                    if (target.getPackageName().startsWith("steward.") && !room(target).equals(room(each))) {
                        used.add(room(target));
                    }
                }
            }
            rooms.remove("");
            parts.put(part, rooms);
            uses.putAll(rooms);
        });
        StringBuilder map = new StringBuilder();
        List<String> names = new ArrayList<>(parts.keySet());
        Collections.reverse(names);
        for (String part : names) {
            map.append(part).append('\n');
            parts.get(part).keySet().stream().sorted((a, b) -> level(b) - level(a)).forEach(room ->
                map.append(String.format(Locale.ROOT, "    %-16s %s", room, reduced(room, uses)).stripTrailing())
                    .append('\n'));
        }
        return map.toString();
    }

    /** Name of a room of the top level; the lab's rooms are one level further in. Empty for the root. */
    private static String room(JavaClass type) {
        String[] names = type.getPackageName().split("\\.");
        return names.length == 1 ? "" : names[1].equals("lab") ? names[1] + "." + names[2] : names[1];
    }

    private static int level(String room) {
        return Collections.max(House.ROOMS.stream().filter(each -> (each + ".").startsWith(room + "."))
            .map(House.ROOMS::indexOf).toList());
    }

    private static String reduced(String room, Map<String, Set<String>> uses) {
        Set<String> direct = uses.get(room);
        Set<String> further = new TreeSet<>();
        direct.stream().flatMap(each -> uses.get(each).stream()).forEach(each -> addReached(each, uses, further));
        return direct.stream().filter(each -> !further.contains(each))
            .sorted((a, b) -> level(b) - level(a)).collect(Collectors.joining(", "));
    }

    /** Adds a room and all that it rests on; each once, as the number of ways to it grows with every level. */
    private static void addReached(String room, Map<String, Set<String>> uses, Set<String> reached) {
        if (reached.add(room)) {
            uses.get(room).forEach(next -> addReached(next, uses, reached));
        }
    }

    /** Returns lines and files of a part, resources included, and how many classes its rooms have. */
    private static String size(String part) throws IOException {
        long lines = 0;
        int files = 0;
        Map<Path, Integer> rooms = new TreeMap<>();
        try (Stream<Path> all = Files.walk(Path.of("src", part))) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                lines += Files.readString(file).lines().count();
                files++;
                if (file.toString().endsWith(".java")) {
                    rooms.merge(file.getParent(), 1, Integer::sum);
                }
            }
        }
        Map.Entry<Path, Integer> fullest = Collections.max(rooms.entrySet(), Map.Entry.comparingByValue());
        return String.format(Locale.ROOT, "%-6s  %6d lines  %4d files  %3d rooms  mean %.1f classes  fullest %d (%s)",
            part, lines, files, rooms.size(), rooms.values().stream().mapToInt(count -> count).average().orElseThrow(),
            fullest.getValue(), Path.of("src", part, "java", "steward").relativize(fullest.getKey()));
    }
}
