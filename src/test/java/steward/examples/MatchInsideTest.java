package steward.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import steward.match.MatchResult;
import steward.replay.Recorded;

/** The example of a match inside the JVM: the bot that is faster wins, and the replay is whole. */
class MatchInsideTest {

    @Test
    void theMatchIsPlayedAndItsReplayVerifies() throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        MatchResult result = MatchInside.play(7, replay);

        assertEquals("fast", result.players().get(result.winner()).name());
        assertTrue(Recorded.verify(replay.toString(StandardCharsets.UTF_8)).verified());
    }
}
