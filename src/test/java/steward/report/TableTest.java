package steward.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import steward.json.JsonObject;
import steward.text.TextFormat;

/** One description of columns, as text, JSON and CSV; the expected lines are drawn by hand. */
class TableTest {

    private record Row(String name, int games, double points) { }

    private static final List<Row> ROWS = List.of(new Row("a, b", 12, 0.5), new Row("longer", 3, Double.NaN));

    private static Table<Row> table() {
        return new Table<Row>().left("bot", 0, Row::name).value("name", Row::name).value("games", Row::games)
            .shown("games", 8).value("points [share]", Row::points).shown("points", 9, 3);
    }

    @Test
    void peopleReadAlignedColumns() {
        assertEquals(List.of(
            "bot      games   points",
            "a, b        12    0.500",
            "longer       3        -"), table().lines(ROWS));
    }

    @Test
    void noLineEndsInBlanks() {
        assertEquals(List.of("bot      note", "a, b", "longer   3"), new Table<Row>().left("bot", 0, Row::name)
            .left("note", 3, row -> row.games() > 5 ? "" : "" + row.games()).lines(ROWS));
    }

    @Test
    void coloursTakeNoWidth() {
        assertEquals(List.of("   games", "<     12>", "       3"), new Table<Row>().value("games", Row::games)
            .shown("games", 8).painted((row, word) -> row.games() > 5 ? "<" + word.substring(1) + ">" : word)
            .lines(ROWS));
    }

    @Test
    void programsReadTheNamesWithoutUnitsInJsonAndWithThemInCsv() {
        assertEquals("{\"rows\":[{\"name\":\"a, b\",\"games\":12,\"points\":0.5},"
            + "{\"name\":\"longer\",\"games\":3,\"points\":null}]}",
            JsonObject.text(Fields.of("rows", table().json(ROWS))::write));
        assertEquals("name,games,points [share]\n\"a, b\",12,0.5\nlonger,3,\n",
            table().csv(ROWS, number -> TextFormat.number(number, 6), false));
        assertEquals("\"longer\",3,\n", table().csvRows(ROWS.subList(1, 2), String::valueOf, true));
    }
}
