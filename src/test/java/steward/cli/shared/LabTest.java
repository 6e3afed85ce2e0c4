package steward.cli.shared;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.URL;
import java.util.Collections;
import java.util.Enumeration;
import org.junit.jupiter.api.Test;
import steward.cli.Cli;

/** The program without the lab's jar: as if its entry as a service were not on the class path. */
class LabTest {

    private static Cli withoutLab(String... arguments) {
        Thread here = Thread.currentThread();
        ClassLoader usual = here.getContextClassLoader();
        here.setContextClassLoader(new ClassLoader(null) {
            @Override
            public Enumeration<URL> getResources(String name) {
                return Collections.emptyEnumeration();
            }
        });
        try {
            return Cli.run(arguments);
        } finally {
            here.setContextClassLoader(usual);
        }
    }

    @Test
    void itsCommandsNameTheMissingJar() {
        String[][] calls = {{"tradeoff"}, {"bench", "--only", "start"}};
        for (String[] call : calls) {
            Cli cli = withoutLab(call);
            assertEquals("steward: " + call[0] + ": found no lab, expected steward-lab.jar on the class path (an "
                + "installation has it in lib)\n", cli.err());
            assertEquals("", cli.out());
            assertEquals(ExitStatus.UNUSABLE, cli.status());
        }
    }

    @Test
    void otherCommandsNeedNoLab() {
        assertEquals(ExitStatus.DONE, withoutLab("explain", "duel").status());
        assertEquals(ExitStatus.DONE, withoutLab("help").status());
    }
}
