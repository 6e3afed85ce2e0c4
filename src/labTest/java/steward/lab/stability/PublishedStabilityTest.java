package steward.lab.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.lab.stability.crowds.TruePathCase;
import steward.lab.stability.TruePathPlot.Figure;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;

/**
 * Published results of the extreme cases, in {@code docs}: page and table are of one whole run. A page that was changed
 * by hand fails. How page and picture must be is left in {@code build/pages}.
 */
class PublishedStabilityTest {

    private static final Path DOCS = Path.of("docs");
    private static final String DATE = "\"\\d{4}-\\d\\d-\\d\\d\"";

    @TempDir
    private Path folder;

    @Test
    void thePageIsWhatTheTableSays() throws IOException {
        StabilityRun run = StabilityRun.read(DOCS.resolve(StabilityRun.CSV));
        Path pages = Path.of("build/pages");
        run.writePage(pages);
        assertEquals(Files.readString(pages.resolve(StabilityRun.PAGE)),
            Files.readString(DOCS.resolve(StabilityRun.PAGE)));
        assertEquals(run.csv().replaceAll(DATE, ""),
            Files.readString(DOCS.resolve(StabilityRun.CSV)).replaceAll(DATE, ""),
            "of one length, version and machine; rows of a changed law are of a later date");
        assertEquals(RunLength.NORMAL, run.length());
        assertTrue(Files.exists(DOCS.resolve(TruePathPlot.PNG)) && Files.exists(DOCS.resolve(TruePathPlot.DARK_PNG)));
        List<String> all = new ArrayList<>();
        for (StabilityCase each : StabilityCases.all()) {
            Rung.all().forEach(rung -> all.add(each.name() + ", " + rung.name() + ": " + each.demand()));
        }
        assertEquals(all, run.rows().stream().map(row -> row.name() + ", " + row.rung() + ": " + row.demand()).toList(),
            "every case on every rung, with the bounds of today");
        assertTrue(run.rows().stream().noneMatch(StabilityRow::failed));
    }

    @Test
    void everyCaseHasASentence() {
        List<String> names = StabilityCases.all().stream().map(StabilityCase::name).toList();
        assertEquals(names, List.copyOf(StabilityPage.meanings().keySet()));
        StabilityPage.meanings().values().forEach(sentence -> assertTrue(sentence.matches("[A-Z].*\\."), sentence));
        assertEquals(names.size(), names.stream().map(StabilityPage::anchor).distinct().count());
    }

    private static StabilityRow path(String rung, int of3, int of10) {
        Finding seen = Finding.reported(String.format(Locale.ROOT,
            "3 discs: %d impacts, %d for each; 10 discs: %d impacts, %d for each", of3 * 3 / 2, of3, of10 * 5, of10));
        return new StabilityRow(TruePathCase.NAME, "some", rung, seen, 1);
    }

    @Test
    void theFiguresOfAPathAreThoseOfItsText() {
        assertEquals(List.of(new Figure(3, 60, 40), new Figure(10, 100, 20)),
            TruePathPlot.figures(path("double", 40, 20).seen()));
        assertEquals(List.of(), TruePathPlot.figures(Finding.reported("not tried")));
    }

    @Test
    @Tag("slow")
    void thePictureShowsEveryRungAndThePageItsRange() throws IOException {
        List<StabilityRow> rows = List.of(path("step/1", 0, 0), path("double", 40, 20), path("exact", 41, 19),
            new StabilityRow("sliding", "a | b", "double", Finding.demanded(false, "1 | 2"), 1));
        TruePathPlot.write(rows, folder);
        BufferedImage picture = ImageIO.read(folder.resolve(TruePathPlot.PNG).toFile());
        assertTrue(picture.getWidth() > 1000, "readable: " + picture.getWidth());
        assertTrue(Files.size(folder.resolve(TruePathPlot.DARK_PNG)) > 0);
        String page = StabilityPage.text(new StabilityRun(RunLength.NORMAL, "2030-01-02", "1.2.3", "a machine",
            rows));
        assertTrue(page.contains("true for 19 to 41 impacts, whatever the arithmetic; with steps not for one."), page);
        assertTrue(page.contains("| [sliding](#sliding) | A body slides along a round wall for a whole turn, and keeps "
            + "its speed. | **fails** |  |"), page);
        assertTrue(page.contains("\n| double | **fails** | 1 \\| 2 |\n"), page);
        assertTrue(page.contains("Of 1 demand\n0 are met and 1 is not, in a run of normal length."), page);
        assertTrue(page.contains("` of Steward 1.2.3 on 2030-01-02: a machine."), page);
    }
}
