package steward.lab.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import steward.cli.shared.Games;
import steward.cli.shared.Lab;
import steward.cli.streams.Streams;
import steward.game.GameSetup;
import steward.scene.Part;
import steward.scene.price.MeasuredPrices;
import steward.scene.price.PartPrice;

/** The lab as the program finds it. */
class LabCommandsTest {

    @Test
    void theLabIsFoundAsAService() {
        assertEquals(LabCommands.class, Lab.of("bench").getClass());
    }

    /** Every part has a price except a broad phase that the scene does without. */
    @Test
    @Tag("slow")
    void everyPartIsMeasured() {
        for (String scene : List.of("mad-pod-racing-silver", "mean-max")) {
            GameSetup setup = Games.open(scene);
            ByteArrayOutputStream err = new ByteArrayOutputStream();
            MeasuredPrices prices = LabCommands.measurePrices(new Streams(new ByteArrayOutputStream(), err, true, true),
                setup, CalibrateTest.HERE);
            List<String> measured = new ArrayList<>(prices.prices().stream().map(PartPrice::part).toList());
            List<String> wanted = Stream.concat(Stream.of(PartPrice.EMPTY), setup.plan().parts().stream()
                .filter(part -> part.in() || !part.name().equals(Part.BROAD_PHASE)).map(Part::name)).toList();
            assertEquals(new TreeSet<>(wanted), new TreeSet<>(measured), scene);
            assertEquals(measured.size(), new TreeSet<>(measured).size(), "each once: " + measured);
            assertTrue(prices.turn().nanos() > 0, prices.toString());
            assertTrue(err.toString(StandardCharsets.UTF_8).contains("measuring"), "progress");
        }
    }
}
