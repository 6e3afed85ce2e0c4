package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The tour: its map is that of the code, and each of its three ways has at most eight files. */
class HouseMapTest {

    @Test
    void theMapIsThatOfTheCode() throws IOException {
        String page = Files.readString(HouseMap.PAGE);
        assertEquals(HouseMap.withMap(page), page, "./gradlew house draws it anew");
    }

    @Test
    void eachWayIsShort() throws IOException {
        List<Integer> files = Stream.of(Files.readString(HouseMap.PAGE).split("\n## "))
            .map(part -> (int) part.lines().filter(line -> line.matches("\\| \\d+ \\| \\[`.*")).count())
            .filter(count -> count > 0).toList();
        assertEquals(3, files.size(), "a match, a league, a worker");
        assertTrue(files.stream().allMatch(count -> count <= 8), files::toString);
    }
}
