package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Projects whose Maven fails; its words are those of Maven 3.8. */
class SdkProjectTest {

    private static final String BEGINNING = "\033[0m\033[0m[ERROR] Failed to execute goal on project b: Could not "
        + "resolve dependencies for project a:b:jar:1: The following artifacts could not be resolved: "
        + "com.codingame.gameengine:core:jar:9.9.9, com.codingame.gameengine:module-entities:jar:9.9.9: ";
    private static final String END = " -> [Help 1]\n[ERROR] \n[ERROR] To see the full stack trace, use -e.\n";

    /** Each row: the end of what Maven says, the version that was asked for, and the refusal. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", textBlock = """
        Could not find artifact com.codingame.gameengine:core:jar:9.9.9 in central (https://repo) | 9.9.9 \
        | engine: found 9.9.9, which needs com.codingame.gameengine:core:jar:9.9.9, which is not to be had, expected \
        a version such as 4.3.0, the newest that is published
        com.codingame.gameengine:core:jar:9.9.9 was not found in https://repo during a previous attempt | none \
        | p: needs com.codingame.gameengine:core:jar:9.9.9, which is not to be had: build it yourself, or try \
        another engine, such as 4.3.0, the newest that is published
        """)
    void anEngineThatIsNotThereIsNamedWithTheNewest(String said, String engine, String refusal) {
        assertEquals(refusal, SdkProject.refusal(Path.of("p"), BEGINNING + said + END, engine).getMessage());
    }

    /** Without a network nobody knows; a project may need another version beside the one asked for. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        Cannot access central in offline mode and the artifact com.codingame.gameengine:core:jar:9.9.9 has not been \
        downloaded from it before. | 9.9.9
        Could not find artifact com.codingame.gameengine:core:jar:9.9.9 in central (https://repo) | 4.3.0
        """)
    void otherFailuresAreToldAsMavenSaysThem(String said, String engine) {
        assertEquals("p: its Maven failed: " + BEGINNING.substring(BEGINNING.indexOf('[', 8)) + said + " -> [Help 1] | "
            + "[ERROR] To see the full stack trace, use -e.", SdkProject.refusal(Path.of("p"), BEGINNING + said + END,
            engine).getMessage());
    }
}
