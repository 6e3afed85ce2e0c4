package steward.cli;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.BrokenInputs.Kind;
import steward.machines.wire.IncomingBytes;
import steward.match.Protocol;
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
    private Path folder;

    private static int inputs() {
        return Integer.getInteger("steward.inputs", TestSize.of(10, 60));
    }

    static Stream<Kind> kinds() throws IOException {
        return BrokenInputs.kinds().stream();
    }

    @ParameterizedTest
    @MethodSource("kinds")
    @Timeout(7200)
    @Tag("sized")
    void endsWithAStatusAndOneMessage(Kind kind) throws IOException {
        BrokenInputs inputs = new BrokenInputs(folder, SEED);
        inputs.prepare(kind);
        int refused = 0;
        for (int number = 0; number < inputs(); number++) {
            byte[] broken = inputs.broken(kind, number);
            try {
                refused += inputs.check(kind, broken) ? 1 : 0;
            } catch (AssertionError | RuntimeException problem) {
                fail(kind.name() + ", steward.seed " + SEED + ", input " + number + ": " + problem.getMessage()
                    + "\n--- the input:\n" + BrokenInputs.shown(broken), problem);
            }
        }
        assertTrue(refused > 0, "nothing was refused");
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

    /** Found by fuzzing: a null that stands in the file is named as what it is. */
    @Test
    void aNullWhereAWordIsExpected() throws IOException {
        Kind kind = kind("scene duel");
        String broken = new String(kind.original(), StandardCharsets.UTF_8).replace("\"truncate\"", "null");
        assertTrue(new BrokenInputs(folder, SEED).check(kind, broken.getBytes(StandardCharsets.UTF_8)));
    }

    /** Found by fuzzing: a message may repeat a word of the file. */
    @Test
    void aWordOfTheFileIsRepeated() throws IOException {
        Kind kind = kind("scene duel");
        String broken = new String(kind.original(), StandardCharsets.UTF_8).replace("\"truncate\"", "int");
        assertTrue(new BrokenInputs(folder, SEED).check(kind, broken.getBytes(StandardCharsets.UTF_8)));
    }

    /** Found by fuzzing: a number of an impact that is too great for a double is shown as it was recorded. */
    @Test
    void anImpulseBeyondAllNumbers() throws IOException {
        Kind kind = kind("replay --impacts --json");
        String whole = new String(kind.original(), StandardCharsets.UTF_8);
        String broken = whole.replaceFirst("\"impulse\":[-0-9.eE]+", "\"impulse\":1e999");
        assertFalse(broken.equals(whole), "there is no impact");
        assertFalse(new BrokenInputs(folder, SEED).check(kind, broken.getBytes(StandardCharsets.UTF_8)));
    }

    /** Found by fuzzing: the name of a field may look like a class. */
    @Test
    void aFieldThatLooksLikeAClassIsNamed() throws IOException {
        Kind kind = kind("figures");
        String broken = new String(kind.original(), StandardCharsets.UTF_8).replace("\"largestError\"",
            "\"LargestError\"");
        BrokenInputs inputs = new BrokenInputs(folder, SEED);
        inputs.prepare(kind);
        assertTrue(inputs.check(kind, broken.getBytes(StandardCharsets.UTF_8)));
    }

    /** Found by fuzzing: what a file has in place of frames may have names of any length. */
    @Test
    void anImportWithoutFramesHasNamesOfAnyLength() throws IOException {
        String broken = "{\"f" + "x".repeat(2000) + "rames\":[]}";
        assertTrue(new BrokenInputs(folder, SEED).check(kind("import"), broken.getBytes(StandardCharsets.UTF_8)));
    }

    private static Kind kind(String name) throws IOException {
        return BrokenInputs.kinds().stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
    }

    @Test
    @Tag("sized")
    void anAnswerInJson() throws InterruptedException {
        answers( Protocol.JSON, "{\"pods\":[{\"x\":1,\"y\":2.5,\"thrust\":100}],\"message\":\"hello\"}");
        answers( Protocol.JSON, "{\"pods\":[{\"x\":1,\"y\":2,\"shield\":true}]}");
    }

    @Test
    @Tag("sized")
    void anAnswerInWords() throws InterruptedException {
        answers( Protocol.CODINGAME, "1000 2000 100 hello");
        answers( Protocol.CODINGAME, "1000 -20 SHIELD");
    }

    @Test
    @Tag("process")                                     // whether a bundle can be started is tried
    @Tag("sized")
    void whatArrivesFromOtherMachines() throws IOException {
        IncomingBytes incoming = new IncomingBytes(Files.createDirectory(folder.resolve("incoming")), SEED);
        for (IntPredicate target : List.<IntPredicate>of(incoming::word, incoming::league, incoming::job,
                incoming::bundle)) {
            int refused = 0;
            for (int number = 0; number < 10 * inputs(); number++) {
                try {
                    refused += target.test(number) ? 1 : 0;
                } catch (AssertionError | RuntimeException problem) {
                    fail("steward.seed " + SEED + ", input " + number + ": " + problem.getMessage(), problem);
                }
            }
            assertTrue(refused > 0 && refused < 10 * inputs(), "some are refused and some are not: " + refused);
        }
    }

    private void answers(Protocol protocol, String original) throws InterruptedException {
        int faults = 0;
        for (int number = 0; number < 10 * inputs(); number++) {
            faults += new BrokenInputs(folder, SEED).answer(protocol, original, number) ? 1 : 0;
        }
        assertTrue(faults > 0, "no answer was refused");
    }

    @Test
    @Tag("sized")
    void aCommandOfABot() {
        int refused = 0;
        for (int number = 0; number < 10 * inputs(); number++) {
            try {
                refused += new BrokenInputs(folder, SEED).command(Fuzz.COMMAND, number) ? 1 : 0;
            } catch (AssertionError | RuntimeException problem) {
                fail("steward.seed " + SEED + ", input " + number + ": " + problem.getMessage(), problem);
            }
        }
        assertTrue(refused > 0, "no command was refused");
    }
}
