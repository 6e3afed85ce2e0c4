package steward.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import steward.game.podrace.PodRace;
import steward.game.podrace.Recordings;
import steward.game.podrace.protocol.PodRaceText;

/** The example bot plays whole races against itself in CodinGame's lines: no fault, and it wins by finishing. */
class SimulatorBotTest {

    @Test
    void finishesRacesWithoutAFault() {
        for (long seed = 1; seed <= 3; seed++) {
            PodRace race = Recordings.official().create(seed);
            PodRaceText text = new PodRaceText(race);
            SimulatorBot[] bots = {new SimulatorBot(3, race.checkpoints()), new SimulatorBot(3, race.checkpoints())};
            while (!race.isOver()) {
                for (int player = 0; player < 2; player++) {
                    StringBuilder lines = new StringBuilder();
                    text.writeTurn(lines, player);
                    byte[] answer = bots[player].answer(lines.toString().split("\n")).strip()
                        .getBytes(StandardCharsets.UTF_8);
                    assertNull(text.readAnswer(player, answer, answer.length), "seed " + seed);
                }
                race.play();
            }
            assertEquals("finished after 3 laps", race.ending(), "seed " + seed);
            assertTrue(race.turn() < 300, "seed " + seed + ": " + race.turn() + " turns");
        }
    }
}
