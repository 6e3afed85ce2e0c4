package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** A new arithmetic must not pass for another one in silence. */
class RungSwitchTest {

    private static final Pattern COMPARISON = Pattern.compile("[!=]= *Arithmetic\\.");

    @Test
    void thePhysicsComparesNoArithmeticsButByExhaustiveSwitches() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/engine/java/steward/physics"))) {
            List<Path> comparing = files.filter(Files::isRegularFile)
                .filter(file -> COMPARISON.matcher(text(file)).find()).toList();
            assertEquals(List.of(), comparing);
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }
}
