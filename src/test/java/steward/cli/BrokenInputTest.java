package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.BrokenInputs.Kind;
import steward.match.TestSize;

/**
 * Files and answers that are broken in ways nobody has thought of, see {@link BrokenInputs}.
 *
 * <p>{@code -Dsteward.inputs=N} tries so many of each kind, {@code -Dsteward.seed=S} others. Campaigns try more, and
 * {@link Fuzz} far more.
 */
class BrokenInputTest {

    private static final long SEED = Long.getLong("steward.seed", 12);

    @TempDir
    private static Path folder;

    private static int inputs() {
        return Integer.getInteger("steward.inputs", TestSize.of(10, 60));
    }

    static List<Kind> kinds() throws IOException {
        return BrokenInputs.kinds();
    }

    static List<Fuzz.Named> files() throws IOException {
        return Fuzz.files(folder, SEED);
    }

    static List<Fuzz.Named> words() {
        return Fuzz.words(folder, SEED);
    }

    static List<Fuzz.Named> incoming() throws IOException {
        return Fuzz.incoming(folder, SEED);
    }

    private static int refused(Fuzz.Named each, int inputs) throws Exception {
        int refused = 0;
        for (int number = 0; number < inputs; number++) {
            try {
                refused += each.target().check(number) ? 1 : 0;
            } catch (AssertionError | RuntimeException problem) {
                fail(each + ", steward.seed " + SEED + ", input " + number + ": " + problem.getMessage(), problem);
            }
        }
        assertTrue(refused > 0, "nothing was refused");
        return refused;
    }

    @ParameterizedTest
    @MethodSource("files")
    @Timeout(7200)
    @Tag("sized")
    void aFileEndsWithAStatusAndOneMessage(Fuzz.Named target) throws Exception {
        refused(target, inputs());
    }

    @ParameterizedTest
    @MethodSource("words")
    @Tag("sized")
    void anAnswerOrACommandIsUsedOrRefused(Fuzz.Named target) throws Exception {
        refused(target, 10 * inputs());
    }

    @ParameterizedTest
    @MethodSource("incoming")
    @Tag("process")                                     // whether a bundle can be started is tried
    @Tag("sized")
    void whatArrivesFromOtherMachinesIsUsedOrRefused(Fuzz.Named target) throws Exception {
        assertTrue(refused(target, 10 * inputs()) < 10 * inputs(), "some are not refused");
    }

    /** Inputs that are refused whatever is done to them show nothing. */
    @ParameterizedTest
    @MethodSource("kinds")
    @Tag("slow")
    void theOriginalIsSound(Kind kind) throws IOException {
        BrokenInputs inputs = new BrokenInputs(folder, SEED);
        inputs.prepare(kind);
        assertFalse(inputs.check(kind, kind.original()), "the original is refused");
    }

    /**
     * Found by fuzzing: a null that stands in the file is named as what it is; a message may repeat a word of the file;
     * a number of an impact that is too great for a double is shown as it was recorded; the name of a field may look
     * like a class; what a file has in place of frames may have names of any length.
     */
    @ParameterizedTest
    @CsvSource({"scene duel, \"truncate\", null, true", "scene duel, \"truncate\", int, true",
        "replay --impacts --json, '\"impulse\":[-0-9.eE]+', '\"impulse\":1e999', false",
        "figures, \"largestError\", \"LargestError\", true", "import, (?s).*, '{\"fLONGrames\":[]}', true"})
    void whatWasFoundIsToldAsItShould(String name, String part, String instead, boolean isRefused) throws IOException {
        Kind kind = BrokenInputs.kinds().stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
        String whole = new String(kind.original(), StandardCharsets.UTF_8);
        String broken = whole.replaceFirst(part, instead.replace("LONG", "x".repeat(2000)));
        assertFalse(broken.equals(whole), "nothing is broken");
        BrokenInputs inputs = new BrokenInputs(folder, SEED);
        inputs.prepare(kind);
        assertEquals(isRefused, inputs.check(kind, broken.getBytes(StandardCharsets.UTF_8)));
    }
}
