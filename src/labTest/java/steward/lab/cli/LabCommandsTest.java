package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import steward.cli.shared.Lab;

/** The lab as the program finds it. */
class LabCommandsTest {

    @Test
    void theLabIsFoundAsAService() {
        assertEquals(LabCommands.class, Lab.find().orElseThrow().getClass());
    }
}
