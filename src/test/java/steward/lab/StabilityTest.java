package steward.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every case of the stability table on every rung, in its short version. */
class StabilityTest {

    static Stream<Arguments> rows() {
        return StabilityCases.all().stream()
            .flatMap(each -> Rung.all().stream().map(rung -> Arguments.of(each.name(), rung.name(), each, rung)));
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("rows")
    void theDemandIsMet(String name, String rungName, StabilityCase each, Rung rung) {
        Seen seen = each.run(rung, Size.SMALL);
        assertNotEquals(Seen.Verdict.FAILS, seen.verdict(), seen::text);
    }

    @Test
    void namesAreUniqueAndDemandsAreSaid() {
        List<StabilityCase> all = StabilityCases.all();
        assertEquals(all.size(), new TreeSet<>(all.stream().map(StabilityCase::name).toList()).size());
        assertTrue(all.stream().noneMatch(each -> each.demand().isBlank()));
    }

    @Test
    void aCaseSeesTheSameTwice() {
        for (StabilityCase each : List.of(new RadiusRatioCase(), new MirrorCase(), new OfficialEdgesCase())) {
            for (Rung rung : Rung.all()) {
                assertEquals(each.run(rung, Size.SMALL), each.run(rung, Size.SMALL), each.name());
            }
        }
    }

    /** A rung that never finds an impact: the demands must notice. */
    @Test
    void aRungThatMissesEverythingFails() {
        Rung real = Rung.all().get(Rung.all().size() - 1);
        Rung blind = new Rung("blind", true, true, real.arithmetic(), parts -> (bodies, sink) -> { });
        List<String> unnoticed = StabilityCases.all().stream()
            .filter(each -> !(each instanceof TimeReversalCase || each instanceof LongRunCase))
            .filter(each -> !(each instanceof RandomPairsCase))
            .filter(each -> !failsOn(each, blind)).map(StabilityCase::name).toList();
        assertEquals(List.of("mirror images", "inelastic collapse", "four dense pods", "rounding"), unnoticed,
            "these only demand that something does not happen");
    }

    private static boolean failsOn(StabilityCase each, Rung rung) {
        return each.run(rung, Size.SMALL).verdict() == Seen.Verdict.FAILS;
    }

    @Test
    void anExceptionIsAFailureAndTheNextRowIsTried() {
        Rung real = Rung.all().get(0);
        Rung broken = new Rung("broken", true, true, real.arithmetic(), parts -> {
            throw new IllegalStateException("on purpose");
        });
        List<StabilityRow> rows = new java.util.ArrayList<>();
        StabilityRow.tryAll(List.of(new CradleCase()), List.of(broken, real), Size.SMALL, (each, rung) -> { },
            rows::add);
        assertTrue(rows.get(0).failed() && rows.get(0).seen().text().contains("on purpose"));
        assertFalse(rows.get(1).failed());
    }
}
