package steward.lab.bench;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The sentences of the page of measured speed follow from its rows. */
class PerformancePageTest {

    private static Row row(String name, double nanos) {
        return new Row("crowds", name, "impacts", 1e9 / nanos, Double.NaN, Double.NaN, "");
    }

    /** 2,200 ns are longer than 600 by 16 lines of 100 ns; without a row of memory nothing is said. */
    @Test
    void whatMemoryCostsIsSaidInLines() {
        List<Row> rows = new ArrayList<>(List.of(row("queue, 1000 bodies", 600), row("queue, 100000 bodies", 2200)));
        String without = PerformancePage.of(List.of(), rows, "a machine", "2030-01-02", "none");
        assertFalse(without.contains("- With memory"), without);
        rows.add(row("memory, 100000 bodies", 100));
        String page = PerformancePage.of(List.of(), rows, "a machine", "2030-01-02", "none");
        assertTrue(page.contains("by as much as reading 16 lines (100000 bodies) of 64 bytes"), page);
    }
}
