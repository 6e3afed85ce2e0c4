package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Rows as RFC 4180 has them. */
class CsvRowTest {

    @Test
    void cellsAreDividedByCommas() {
        assertEquals("crowds,1.5,,7\n", new CsvRow().words("crowds", "1.5", "", "7").line());
        assertEquals("1,\"two\",3\n", new CsvRow().words("1").text("two").words("3").line());
    }

    @Test
    void textIsAlwaysQuotedAndItsQuotesDoubled() {
        assertEquals("\"plain\"\n", new CsvRow().text("plain").line());
        assertEquals("\"\"\n", new CsvRow().text("").line());
        assertEquals("\"a, b\",\"says \"\"hello\"\"\",\"two\nlines\"\n",
            new CsvRow().text("a, b").text("says \"hello\"").text("two\nlines").line());
    }

    @Test
    void aWordIsQuotedOnlyWhereItMustBe() {
        assertEquals("\"1,5\",\"\"\"\",\"a\nb\",\"a\rb\",a b\n",
            new CsvRow().words("1,5", "\"", "a\nb", "a\rb", "a b").line());
    }

    @Test
    void anEmptyFirstCellIsACell() {
        assertEquals(",1\n", new CsvRow().words("", "1").line());
    }

    /** Spreadsheets compute what begins so, also when it is quoted. */
    @Test
    void noTextBeginsAsAFormula() {
        for (String text : new String[] {"=cmd()", "+1+1", "-x", "@SUM(A1)", "\t=1", "\r=1", "'=1", "''-x",
            "1E400-1"}) {
            String line = new CsvRow().words(text).line();
            String cell = line.substring(0, line.length() - 1).replaceAll("^\"|\"$", "");
            assertEquals(text.startsWith("1") ? text : "'" + text, cell);
            assertEquals('"' + cell + "\"\n", new CsvRow().text(text).line());
        }
        assertEquals("-1,-1.5E-7,-Infinity,'mine' x,'\n",
            new CsvRow().words("-1", "-1.5E-7", "-Infinity", "'mine' x", "'").line());
    }
}
