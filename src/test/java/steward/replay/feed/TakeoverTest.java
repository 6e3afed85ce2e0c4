package steward.replay.feed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;
import steward.game.GameSetup;
import steward.match.Protocol;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.RecordedMatch;
import steward.replay.ReplayReader;
import steward.replay.verify.Verification;

/** A bot plays on in place of a player of a recorded match; what comes of it is a match that verifies. */
class TakeoverTest {

    private static final long SEED = 4;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final List<FedTurn> fed = new ArrayList<>();

    private static Bot seeded(int player) {
        return new SeededBot(31 * SEED + player, 0.3);
    }

    private Takeover.Outcome play(Recorded recorded, int player, int from, Bot bot) {
        RecordedMatch match;
        try (ReplayReader reader = Recorded.reader(recorded.bytes())) {
            match = RecordedMatch.read(reader);
        }
        out.reset();
        fed.clear();
        return new Takeover(match, TestScenes.TYPES, player, Protocol.JSON, new InProcessPlayer("new", bot), from,
            "./new", out).run(turn -> { }, fed::add);
    }

    private Recorded written() {
        return new Recorded(out.toByteArray(), null);
    }

    /** The recordings are the same but for header and times, and the name of the new bot. */
    private void assertSameMatch(Recorded recorded, int player) {
        List<String> before = recorded.withoutTimes().lines().skip(1).toList();
        List<String> after = written().withoutTimes().lines().skip(1).toList();
        int last = before.size() - 1;
        assertEquals(before.subList(0, last), after.subList(0, last));
        String name = recorded.result().players().get(player).name();
        assertEquals(withoutHash(before.get(last)).replace("\"name\":\"" + name + "\"", "\"name\":\"new\""),
            withoutHash(after.get(last)));
    }

    private static String withoutHash(String result) {
        return result.replaceFirst("\"resultHash\":\"[0-9a-f]*\"", "");
    }

    @ParameterizedTest
    @CsvSource({"mad-pod-racing, 0, 1", "mad-pod-racing, 1, 30", "walled-race, 0, 57", "duel, 1, 2"})
    void theSameBotPlaysTheSameMatch(String scene, int player, int from) {
        Recorded recorded = Recorded.of(scene, SEED);
        Takeover.Outcome outcome = play(recorded, player, from, seeded(player));
        assertEquals(recorded.result().turns(), outcome.turns());
        assertEquals(recorded.result().winner(), outcome.result().winner());
        assertSameMatch(recorded, player);
        assertEquals(Recorded.whole(outcome.turns()), written().verify());
        assertEquals(from - 1, fed.stream().filter(turn -> !turn.replaced()).count());
        assertTrue(fed.stream().allMatch(FedTurn::same));
        assertTrue(written().lines().get(0).contains("\"bot\":\"./new\",\"protocol\":\"json\"}"));
    }

    @Test
    void anotherBotPlaysAnotherMatchThatVerifies() {
        Recorded recorded = Recorded.of("mad-pod-racing", SEED);
        Takeover.Outcome outcome = play(recorded, 0, 20, new SeededBot(99, 0.9));
        Verification verification = written().verify();
        assertNull(verification.difference());
        assertEquals(outcome.turns(), verification.turns());
        List<String> before = recorded.withoutTimes().lines().skip(1).limit(19).toList();
        assertEquals(before, written().withoutTimes().lines().skip(1).limit(19).toList());
        assertTrue(!recorded.lines().get(25).equals(written().lines().get(25)));
    }

    /** The other one wins in turn 51 by the recording, but now there is an opponent. */
    @Test
    void aMatchThatGoesOnLongerThanTheRecordingHasNoResult() {
        Bot idle = TestBots.answering(line -> "{\"pods\":[{\"x\":0,\"y\":0,\"thrust\":0}]}");
        Recorded recorded = Recorded.of(TestScenes.open("duel"), SEED, List.of(new SeededBot(1, 0), idle));
        assertEquals(51, recorded.result().turns());
        Takeover.Outcome outcome = play(recorded, 1, 1, new SeededBot(2, 0));
        assertNull(outcome.result());
        assertEquals("the recording ends", outcome.reason());
        assertEquals(51, outcome.turns());
        assertEquals(51, written().verify().turns());
        assertTrue(written().verify().agrees());
        assertEquals("r.jsonl: cut off after turn 51: there is no result", written().verify().warning());
        assertTrue(!outcome.ahead().isEmpty());
    }

    @Test
    void anOpponentWhoFailedThenFailsAgain() {
        Bot failing = new AlteredBot(seeded(1), 9, answer -> "nonsense");
        Recorded recorded = Recorded.of(TestScenes.open("duel"), SEED, List.of(seeded(0), failing));
        Takeover.Outcome outcome = play(recorded, 0, 5, seeded(0));
        assertNotNull(outcome.result());
        assertEquals(0, outcome.result().winner());
        assertEquals(recorded.result().players().get(1).fault(), outcome.result().players().get(1).fault());
        assertEquals(9, outcome.turns());
        assertEquals(Recorded.whole(9), written().verify());
    }

    @Test
    void aBotThatFailsIsOutAndTheOtherWins() {
        Recorded recorded = Recorded.of("duel", SEED);
        Bot failing = new AlteredBot(seeded(0), 12, answer -> "nonsense");
        Takeover.Outcome outcome = play(recorded, 0, 10, failing);
        assertNotNull(outcome.result());
        assertEquals(12, outcome.turns());
        assertEquals(1, outcome.result().winner());
        assertTrue(outcome.result().players().get(0).fault().endsWith("received: nonsense"));
        assertEquals(Recorded.whole(12), written().verify());
    }

    @Test
    void aBotThatIsGoneBeforeItsTurnPlaysNothing() {
        Recorded recorded = Recorded.of("duel", SEED);
        Bot gone = new AlteredBot(seeded(0), 3, answer -> null);
        Takeover.Outcome outcome = play(recorded, 0, 10, gone);
        assertEquals("the bot has ended before turn 10", outcome.reason());
        assertEquals(2, outcome.turns());
        assertTrue(written().verify().agrees());
    }

    /** A player who is out by the rules has no commands any more; the other two race on. */
    @Test
    void amongThreeTheMatchGoesOnWhenOneIsOut() {
        GameSetup three = TestScenes.duel(3);
        Bot idle = TestBots.answering(line -> "{\"pods\":[{\"x\":0,\"y\":0,\"thrust\":0}]}");
        Recorded recorded = Recorded.of(three, SEED, List.of(seeded(0), idle, seeded(2)));
        assertTrue(recorded.result().turns() > 50, recorded.result()::ending);
        Takeover.Outcome outcome = play(recorded, 0, 30, seeded(0));
        assertNotNull(outcome.result(), outcome::reason);
        assertSameMatch(recorded, 0);
        assertTrue(written().verify().verified());
    }
}
