package steward.bot.accounting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProcFileTest {

    @TempDir
    private Path folder;

    private ProcFile file(String text) throws IOException {
        ProcFile file = new ProcFile();
        assertTrue(file.read(Files.writeString(folder.resolve("file"), text).toString()));
        return file;
    }

    /** A program may be called anything: proc(5), /proc/pid/stat. */
    @Test
    void theNameOfAProgramMayHoldBracketsSpacesAndNumbers() throws IOException {
        ProcFile file = file("4321 (a) S (7 b) R 17 4321 4321 0 -1 9\n");
        assertTrue(file.skipName());
        assertEquals('R', file.nextCharacter());
        assertEquals(17, file.nextLong());
        file.skipWords(2);
        assertEquals(0, file.nextLong());
    }

    @Test
    void numbersAreReadOneAfterAnother() throws IOException {
        ProcFile file = file("12 3456789012345 7\n");
        assertEquals(12, file.nextLong());
        assertEquals(3456789012345L, file.nextLong());
        assertTrue(file.hasNext());
        assertEquals(7, file.nextLong());
        assertFalse(file.hasNext());
    }

    @Test
    void secondsWithTwoDecimalsAreHundredths() throws IOException {
        ProcFile file = file("12403.28 3138.04\n");
        file.skipWords(1);
        assertEquals(313804, file.nextHundredths());
    }

    @Test
    void aFileThatIsGoneIsNotRead() {
        assertFalse(new ProcFile().read(folder.resolve("gone").toString()));
    }

    @Test
    void withoutABracketThereIsNoName() throws IOException {
        assertFalse(file("1 2 3").skipName());
    }
}
