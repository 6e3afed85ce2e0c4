package steward.lab.bench.section;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;

/** Rows and steps of the section on crowds. */
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class CrowdSectionTest {

    private final List<Row> rows = new ArrayList<>();

    /** Few bodies beside the textbook's way, and one more than it is measured with. */
    @ParameterizedTest
    @CsvSource({"30, 'textbook, 30 bodies|queue, 30 bodies|memory, 30 bodies'",
        "3001, 'queue, 3001 bodies|memory, 3001 bodies'"})
    void eachCrowdHasItsRowsAndReportsAllSteps(int bodies, String names) throws Exception {
        CrowdSection section = new CrowdSection(List.of(bodies));
        int[] steps = new int[1];
        section.run(Effort.QUICK, () -> steps[0]++, rows::add);
        assertEquals(names, String.join("|", rows.stream().map(Row::name).toList()));
        assertEquals(section.steps(Effort.QUICK), steps[0]);
        for (Row row : rows) {
            assertEquals(row.name().endsWith("%"), row.ratio() > 0 && !names.contains("textbook")
                && row != rows.get(0), row.name() + ": " + row.ratio());
        }
    }

    @Test
    @Tag("campaign")
    void manyBodiesAreAlsoDenseWithARatioToTheSparseOnes() throws Exception {
        eachCrowdHasItsRowsAndReportsAllSteps(10_000, "queue, 10000 bodies|queue, 10000 bodies at 60%|"
            + "queue, 10000 bodies at 75%|memory, 10000 bodies");
    }
}
