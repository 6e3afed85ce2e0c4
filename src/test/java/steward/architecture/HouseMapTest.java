package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;

/** The tour: its map is that of the code, and its way goes through twelve files. */
class HouseMapTest {

    @Test
    void theMapIsThatOfTheCode() throws IOException {
        String page = Files.readString(HouseMap.PAGE);
        assertEquals(HouseMap.withMap(page), page, "./gradlew house draws it anew");
    }

    @Test
    void theMapShowsKnownArrows() {
        String map = HouseMap.draw();
        assertTrue(map.matches("(?s)lab\\n.*main\\n.*engine\\n.*"), map);
        assertTrue(map.contains("    scene            physics, text\n"), map);
        assertTrue(map.contains("    numerics\n"), map);
    }
}
