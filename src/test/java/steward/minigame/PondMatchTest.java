package steward.minigame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.match.MatchResult;
import steward.match.TestSize;
import steward.replay.Recorded;
import steward.replay.verify.Verification;

/** Whole matches of the pond through the referee, the bots in process, recorded, replayed and verified. */
@Execution(ExecutionMode.CONCURRENT)
class PondMatchTest {

    private static List<PondBot> bots() {
        return List.of(new PondBot("cell"), new PondBot("hunter"), new PondBot("fog"));
    }

    private static Verification verify(byte[] replay) {
        return Recorded.verify(replay, MiniScenes.POND);
    }

    /** In these matches everything that can happen does, and every one of them verifies. */
    @Test
    @Tag("sized")
    void matchesVerifyAndEverythingHappens() {
        int matches = TestSize.of(6, 20);
        StringBuilder all = new StringBuilder();
        for (long seed = 1; seed <= matches; seed++) {
            List<PondBot> bots = bots();
            Recorded played = Recorded.of(MiniScenes.pond(), seed, bots);
            Verification verification = verify(played.bytes());
            assertTrue(verification.verified(), "seed " + seed + ": " + verification.difference());
            assertNull(verification.warning());
            assertEquals(played.result().turns(), verification.turns(), "seed " + seed);
            assertFalse(played.result().anyFault(), "seed " + seed + ": " + played.result());
            for (PondBot bot : bots) {
                assertEquals(1, bot.setups, "seed " + seed);
                assertEquals(1, bot.ends, "seed " + seed);
            }
            all.append(played.text());
        }
        String text = all.toString();
        for (String part : List.of("\"text\":\"burst\"", "\"text\":\"split\"", "\"kind\":\"birth\"",
            "\"text\":\"eaten\"", "\"text\":\"in the fog\"", "\"out\":\"eaten by player", "\"passing\":[[",
            "\"wall\":0", "\"messages\":[\"cell\",\"hunter\",\"fog\"]")) {
            assertTrue(text.contains(part), part + " never happened");
        }
        assertFalse(text.contains("\"impactLimit\""));
    }

    @Test
    void theSameSeedGivesTheSameBytes() {
        assertEquals(Recorded.of(MiniScenes.pond(), 5, bots()).withoutTimes(),
            Recorded.of(MiniScenes.pond(), 5, bots()).withoutTimes());
    }

    /** A player that pushes too hard in turn 4 is out with a reason, without a body; the others play on. */
    @Test
    void aFaultTakesAPlayerOutAndTheOthersPlayOn() {
        Bot wild = TestBots.byTurn(turn -> "{\"push\":{\"x\":" + (turn == 4 ? 26 : 3) + ",\"y\":0}}");
        Recorded played = Recorded.of(MiniScenes.pond(), 2,
            List.of(new PondBot("cell"), wild, new PondBot("cell")));
        MatchResult.PlayerResult out = played.result().players().get(1);
        assertTrue(out.fault().startsWith("push: found a length of 26.0, expected at most 25.0"), out.fault());
        assertEquals(2, out.rank());
        assertEquals(4, out.answers());
        assertTrue(played.result().turns() > 4);
        String fourth = played.text().lines().toList().get(4);
        assertTrue(fourth.contains("\"kind\":\"death\",\"time\":0,\"body\":1,"), fourth);
        assertTrue(verify(played.bytes()).verified());
    }

    /** Three players that never move: ranks 0, 0, 0 after the last turn. */
    @Test
    void whoDoesNothingTies() {
        Bot idle = TestBots.answering(line -> "{\"push\":{\"x\":0,\"y\":0}}");
        Recorded played = Recorded.of(MiniScenes.pond("\"bubbles\": 8, \"cells\": 6",
            "\"bubbles\": 0, \"cells\": 0", "\"fogs\": 3", "\"fogs\": 0"), 1, List.of(idle, idle, idle));
        assertEquals("at most 150 turns are played", played.result().ending());
        assertEquals(-1, played.result().winner());
        for (MatchResult.PlayerResult player : played.result().players()) {
            assertEquals(0, player.rank());
            assertEquals(10, player.score());
        }
    }

    /** One digit of one command in the middle of the match. */
    @Test
    void anEditedReplayDoesNotVerify() {
        Recorded played = Recorded.of(MiniScenes.pond(), 3, bots());
        List<String> lines = played.text().lines().toList();
        String line = lines.get(20);
        int digit = line.indexOf("\"commands\":[{\"x\":") + 20;
        char other = line.charAt(digit) == '5' ? '6' : '5';
        String edited = played.text().replace(line, line.substring(0, digit) + other + line.substring(digit + 1));
        Verification verification = verify(edited.getBytes(StandardCharsets.UTF_8));
        assertNotNull(verification.difference());
        assertEquals(20, verification.difference().turn());
    }
}
