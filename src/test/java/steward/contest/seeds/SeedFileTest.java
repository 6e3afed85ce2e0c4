package steward.contest.seeds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Map;
import org.junit.jupiter.api.Test;
import steward.files.InputException;

/** Seeds in a row and of a file. */
class SeedFileTest {

    private static final String IDENTITY = "0123456789abcdef0123456789abcdef";

    private static String error(String text) {
        return assertThrows(InputException.class, () -> SeedFile.read(text, "s.txt")).getMessage();
    }

    @Test
    void aLineHasASeedAndAComment() {
        SeedFile file = SeedFile.read("# of a map\n\n 7 # first\n-9223372036854775808\n" + SeedFile.chooser(IDENTITY,
            "the old one") + "\n12#x", "s.txt");
        assertEquals(3, file.seeds().count());
        assertEquals(7, file.seeds().at(0));
        assertEquals(Long.MIN_VALUE, file.seeds().at(1));
        assertEquals(12, file.seeds().at(2));
        assertEquals(Map.of(IDENTITY, "the old one"), file.choosers());
    }

    /** Notepad begins a file with it. */
    @Test
    void aByteOrderMarkIsNoPartOfTheFirstSeed() {
        assertEquals(7, SeedFile.read("\uFEFF7\n8\n", "s.txt").seeds().at(0));
        assertEquals(1, SeedFile.read("\uFEFF" + SeedFile.chooser(IDENTITY, "old") + "\n7", "s.txt").choosers().size());
    }

    @Test
    void errorsNameTheLine() {
        assertEquals("s.txt:2: found '8 9', expected a seed, a whole number of 64 bits, and behind # a comment",
            error("7\n8 9\n"));
        assertEquals("s.txt:1: found '9223372036854775808', expected a seed, a whole number of 64 bits, and behind # a "
            + "comment", error("9223372036854775808"));
        assertEquals("s.txt:3: found the seed 7 a second time, expected each once; it stands in line 1, too",
            error("7\n8\n7"));
        assertEquals("s.txt: found no seed, expected one a line", error("# none\n"));
    }

    @Test
    void seedsInARowHaveNoEnd() {
        Seeds row = Seeds.from(5);
        assertFalse(row.isListed());
        assertEquals(5, row.at(0));
        assertEquals(8, row.at(3));
        assertEquals(9, row.after(4).at(0));
        assertEquals(Integer.MAX_VALUE, row.count());
        Seeds listed = SeedFile.read("3\n1\n2", "s").seeds();
        assertEquals(2, listed.after(1).count());
        assertEquals(1, listed.after(1).at(0));
        assertEquals(0, listed.after(7).count());
    }
}
