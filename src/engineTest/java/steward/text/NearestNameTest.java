package steward.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Slips of the pen find the word that was meant, other words find none. */
class NearestNameTest {

    private static final List<String> KNOWN = List.of("radius", "mass", "restitution", "minimumImpulse", "x", "ax");

    @ParameterizedTest
    @CsvSource({
        "raduis, radius", "radus, radius", "radiuss, radius", "redius, radius", "RADIUS, radius", "masss, mass",
        "mas, mass", "msas, mass", "restituton, restitution", "restetutoin, restitution",
        "minimum-impulse, minimumImpulse", "minimumimpulse, minimumImpulse", "minImpulse, minimumImpulse",
        "radi, radius", "ay, ax"})
    void aSlipFindsWhatWasMeant(String word, String meant) {
        assertEquals(Optional.of(meant), NearestName.of(word, KNOWN));
    }

    @ParameterizedTest
    @CsvSource({"''", "y", "length", "rad", "maximumBatch", "impulse"})
    void anotherWordFindsNone(String word) {
        assertEquals(Optional.empty(), NearestName.of(word, KNOWN));
    }

    @Test
    void theFirstOfEquallyNearOnesWins() {
        assertEquals(Optional.of("maps"), NearestName.of("mats", List.of("maps", "mass")));
        assertEquals(Optional.of("mass"), NearestName.of("mats", List.of("mass", "maps")));
        assertEquals(Optional.empty(), NearestName.of("mats", List.of()));
    }

    @Test
    void theQuestionEndsAMessage() {
        assertEquals("; did you mean 'mass'?", NearestName.question("mas", KNOWN, "'"));
        assertEquals("; did you mean mass?", NearestName.question("mas", KNOWN, ""));
        assertEquals("", NearestName.question("length", KNOWN, "'"));
    }
}
