package steward.lab.stability;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.lab.timing.Machine;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;

/**
 * Table of numerical extremes: every case on every rung, in files for {@code docs} that are written to
 * {@code build/pages}. {@code -Psteward.length=long} plays the long versions, in hours, and
 * {@code -Psteward.rows='piles, .*'} only rows whose case and rung match. It takes long because heaps
 * come to rest and millions of pairs are computed exactly: 10 minutes on two quiet cores.
 */
@Tag("campaign")
@Execution(ExecutionMode.CONCURRENT)
class StabilityTableTest {

    private static final RunLength LENGTH = RunLength.of(System.getProperty("steward.length", "normal"));
    private static final String ROWS = System.getProperty("steward.rows", ".*");
    private static final Map<String, StabilityRow> SEEN = new ConcurrentHashMap<>();

    static Stream<Arguments> rows() {
        List<Arguments> rows = StabilityCases.all().stream().flatMap(each -> Rung.all().stream()
            .map(rung -> Arguments.of(each.name() + ", " + rung.name(), each, rung)))
            .filter(row -> row.get()[0].toString().matches(ROWS)).toList();
        assertFalse(rows.isEmpty(), "steward.rows: no row is named as '" + ROWS + "', expected one as 'piles, double'");
        return rows.stream();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("rows")
    void theDemandIsMet(String name, StabilityCase each, Rung rung) {
        StabilityRow row = StabilityRow.of(each, rung, LENGTH);
        SEEN.put(name, row);
        assertFalse(row.failed(), row::toString);
    }

    @AfterAll
    static void write() throws IOException {
        List<StabilityRow> rows = rows().map(row -> SEEN.get(row.get()[0])).toList();
        StabilityRun run = new StabilityRun(LENGTH, LocalDate.now(ZoneOffset.UTC).toString(),
            System.getProperty("steward.version"), Machine.line(), rows);
        Path pages = Path.of("build/pages");
        run.writePage(pages);
        Files.writeString(pages.resolve(StabilityRun.CSV), run.csv());
    }
}
