package steward.architecture;

import com.tngtech.archunit.core.domain.JavaClass;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Comparator;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Map of the three parts, drawn from the compiled classes: each room of the top level and the rooms that it rests on,
 * without those that it reaches through another. {@code ./gradlew house} writes it into the tour and prints how large
 * parts and rooms are.
 */
public final class HouseMap {

    static final Path PAGE = Path.of("docs/tour.md");
    private static final String BEGIN = "```text\n";
    private static final String END = "```\n";

    /** Order of rooms by the highest room within each. */
    private static final Comparator<String> HIGHEST_FIRST = Comparator.<String>comparingInt(room ->
        House.ROOMS.lastIndexOf(House.ROOMS.stream().filter(each -> (each + ".").startsWith(room + "."))
            .reduce((lower, higher) -> higher).orElseThrow())).reversed();

    private HouseMap() {
    }

    public static void main(String[] arguments) throws IOException {
        Files.writeString(PAGE, withMap(Files.readString(PAGE)));
        for (String part : House.PARTS) {
            System.out.println(size(part));
        }
    }

    /** Returns the page with the map of today in the place of the one in it. */
    static String withMap(String page) {
        int begin = page.indexOf(BEGIN) + BEGIN.length();
        return page.substring(0, begin) + draw() + page.substring(page.indexOf(END, begin));
    }

    /** Draws the map: highest part first. */
    private static String draw() {
        Map<String, Set<String>> uses = new TreeMap<>();
        for (House.Touch touch : House.TOUCHES) {
            String room = room(touch.origin());
            Set<String> used = uses.computeIfAbsent(room, name -> new TreeSet<>());
            if (touch.target().getPackageName().startsWith("steward.") && !room(touch.target()).equals(room)) {
                used.add(room(touch.target()));
            }
        }
        uses.remove("");
        StringBuilder map = new StringBuilder();
        for (int part = House.PARTS.size() - 1; part >= 0; part--) {
            Path folder = Path.of("src", House.PARTS.get(part), "java", "steward");
            map.append(House.PARTS.get(part)).append('\n');
            uses.keySet().stream().filter(room -> Files.isDirectory(folder.resolve(room.replace('.', '/'))))
                .sorted(HIGHEST_FIRST).forEach(room -> map.append(String.format(Locale.ROOT, "    %-16s %s", room,
                    reduced(room, uses)).stripTrailing()).append('\n'));
        }
        return map.toString();
    }

    /** Name of a room of the top level; the lab's rooms are one level further in. Empty for the root. */
    private static String room(JavaClass type) {
        return House.room(type).replaceFirst("^((lab\\.)?\\w+).*", "$1");
    }

    private static String reduced(String room, Map<String, Set<String>> uses) {
        Set<String> further = new TreeSet<>();
        uses.get(room).forEach(each -> uses.get(each).forEach(next -> addReached(next, uses, further)));
        return uses.get(room).stream().filter(each -> !further.contains(each)).sorted(HIGHEST_FIRST)
            .collect(Collectors.joining(", "));
    }

    /** Adds a room and all that it rests on; each once, as the number of ways to it grows with every level. */
    private static void addReached(String room, Map<String, Set<String>> uses, Set<String> reached) {
        if (reached.add(room)) {
            uses.get(room).forEach(next -> addReached(next, uses, reached));
        }
    }

    /** Returns lines and files of a part, resources included, and how many classes its rooms have. */
    private static String size(String part) {
        Map<String, String> files = SourceText.ofKind("", "src/" + part);
        Map<String, Long> rooms = files.keySet().stream().filter(file -> file.endsWith(".java")).collect(
            Collectors.groupingBy(file -> file.replaceFirst("(src/\\w+/java/steward/?)?(.*)/.*", "$2"), TreeMap::new,
                Collectors.counting()));
        Map.Entry<String, Long> fullest = Collections.max(rooms.entrySet(), Map.Entry.comparingByValue());
        return String.format(Locale.ROOT, "%-6s  %6d lines  %4d files  %3d rooms  mean %.1f classes  fullest %d (%s)",
            part, files.values().stream().mapToLong(text -> text.lines().count()).sum(), files.size(), rooms.size(),
            rooms.values().stream().mapToLong(count -> count).average().orElseThrow(), fullest.getValue(),
            fullest.getKey());
    }
}
