package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.bot.command.ProgramTrial;
import steward.cli.Cli;
import tools.jackson.databind.JsonNode;

/** {@code steward doctor}. */
@Tag("process")
class DoctorCommandTest {

    @Test
    void everythingIsAnswered() {
        JsonNode doctor = Cli.run("doctor", "--json").json();
        List<String> names = new ArrayList<>();
        doctor.get("items").forEach(item -> {
            names.add(item.get("name").stringValue());
            assertTrue(item.get("works").isBoolean());
            assertFalse(item.get("detail").stringValue().isEmpty(), item.toString());
        });
        assertTrue(names.containsAll(List.of("JDK", "fused multiply-add", "processors", "setsid", "sandbox light",
            "sandbox strict", "launcher", "resident referee", "control groups", "browser", "python3", "g++", "node",
            "javac", "temporary folder")), names.toString());
        assertTrue(doctor.get("items").get(0).get("detail").stringValue().contains(Runtime.version().toString()));
    }

    @Test
    void itIsReadableAndEndsWellWhateverItFinds() {
        Cli cli = Cli.run("doctor").done();
        assertTrue(cli.out().startsWith("java\n  yes  JDK  "), cli.out());
        assertTrue(cli.out().lines().allMatch(line -> line.length() <= 80), cli.out());
    }

    @Test
    void aTrialTellsWhatAProgramSays() throws InterruptedException {
        assertEquals(new ProgramTrial(3, "hello"),
            ProgramTrial.of(List.of("sh", "-c", "echo; echo hello; exit 3"), 9000));
        assertEquals(-1, ProgramTrial.of(List.of("sh", "-c", "sleep 9"), 50).status());
        assertFalse(ProgramTrial.of(List.of("no-such-program"), 9000).works());
    }
}
