package steward.guest.project;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.files.InputException;
import steward.files.Remedied;

/** Projects whose Maven fails; its words are those of Maven 3.8. */
class ProjectBuildTest {

    private static final String BEGINNING = "\033[0m\033[0m[ERROR] Failed to execute goal on project b: Could not "
        + "resolve dependencies for project a:b:jar:1: The following artifacts could not be resolved: "
        + "com.codingame.gameengine:core:jar:9.9.9, com.codingame.gameengine:module-entities:jar:9.9.9: ";
    private static final String END = " -> [Help 1]\n[ERROR] \n[ERROR] To see the full stack trace, use -e.\n";

    /** Each row: the end of what Maven says, the version that was asked for, and the refusal. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", textBlock = """
        Could not find artifact com.codingame.gameengine:core:jar:9.9.9 in central (https://repo) | 9.9.9 \
        | engine: found 9.9.9, which needs com.codingame.gameengine:core:jar:9.9.9, which no repository has
        com.codingame.gameengine:core:jar:9.9.9 was not found in https://repo during a previous attempt | none \
        | p: needs com.codingame.gameengine:core:jar:9.9.9, which no repository has
        """)
    void anEngineThatIsNotThereIsNamedWithTheRecipe(String said, String engine, String refusal) {
        InputException problem = ProjectBuild.refusal(Path.of("p"), BEGINNING + said + END, engine, false);
        assertEquals(refusal, problem.getMessage());
        assertEquals(engine != null ? List.of() : List.of(new Remedied.Remedy("engine-source",
            "codingame-game-engine builds 9.9.9 from a clone of https://github.com/CodinGame/codingame-game-engine")),
            problem.remedies());
    }

    /** Another version is proposed only of a project that has been compiled with it. */
    @Test
    void anotherVersionIsProposedIfItCompiles() {
        assertEquals(new Remedied.Remedy("engine", "4.3.0 compiles it too"), ProjectBuild.refusal(Path.of("p"),
            BEGINNING + "Could not find artifact com.codingame.gameengine:core:jar:9.9.9 in central" + END, null, true)
            .remedies().get(1));
    }

    /** Without a network nobody knows which versions there are. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        Cannot access central in offline mode and the artifact com.codingame.gameengine:core:jar:9.9.9 has not been \
        downloaded from it before. | Maven has no network, which it needs the first time:
        Compilation failure: cannot find symbol | ''
        """)
    void otherFailuresAreToldAsMavenSaysThem(String said, String first) {
        assertEquals("p: its Maven failed: " + (first.isEmpty() ? "" : first + " ")
            + BEGINNING.substring(BEGINNING.indexOf('[', 8)) + said
            + " -> [Help 1] | [ERROR] To see the full stack trace, use -e.",
            ProjectBuild.refusal(Path.of("p"), BEGINNING + said + END, null, false).getMessage());
    }

    /** The tag of a version, else the next later one, else the newest; without tags, the newest commit. */
    @ParameterizedTest
    @CsvSource({"4.5.0, v4.5.0", "4.6.0, v4.7.2", "4.7.8, v4.10.0", "5.0, v4.10.0", "3, v4.5.0", "LATEST, v4.10.0"})
    void theTagOfAVersionIsChosen(String version, String tag) {
        assertEquals(tag, EngineSource.tag(List.of("v4.10.0", "v4.7.2", "v4.5.0", "v4.7.7-rc1", "latest"), version));
        assertEquals("HEAD", EngineSource.tag(List.of("latest"), version));
    }
}
