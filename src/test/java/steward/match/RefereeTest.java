package steward.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.scene.Time;

/** The loop: which players are asked when, what they are sent at the end, and how matches go on after failures. */
@Timeout(20)
class RefereeTest {

    private static final String LATE = ScriptedPlayer.FAULT + "no answer";

    private final List<String> log = new ArrayList<>();

    private ScriptedPlayer player(String name, IntFunction<String> script) {
        return new ScriptedPlayer(name, log, script);
    }

    /** Idle, and late in one turn. */
    private static IntFunction<String> failingIn(int turn) {
        return question -> question < turn ? ScriptedPlayer.idle(question) : LATE;
    }

    private static MatchResult play(int players, MatchListener listener, Player... all) throws InterruptedException {
        return new Referee(TestScenes.duel(players), 1, List.of(all), TimeControl.UNLIMITED, listener).play();
    }

    private static final MatchListener NOBODY = new MatchListener() { };

    /** In the duel the players' pods are the bodies 0, 1, ...; a finished race is 3 checkpoints passed. */
    private static MatchListener startingWith(int pod, PodState state) {
        return new MatchListener() {
            @Override
            public void start(Game game, GameJson codec) {
                ((PodRace) game).setPod(pod, state);
            }
        };
    }

    private static PodState aboutToFinish() {
        return new PodState(5500, 3000, 0, 0, 0, 0, true, 2);
    }

    @Test
    void setupsFirstThenEveryTurnInTheOrderOfPlayers() throws InterruptedException {
        play(3, NOBODY, player("A", failingIn(2)), player("B", ScriptedPlayer::idle),
            player("C", failingIn(3)));

        assertEquals(List.of("A setup", "B setup", "C setup", "A ask 1", "B ask 1", "C ask 1",
            "A ask 2", "A close", "B ask 2", "C ask 2",
            "B ask 3", "C ask 3", "C close", "B last", "B end"), log);
    }

    @Test
    void everybodyIsAskedAlsoWhenTheFirstHasJustFailed() throws InterruptedException {
        MatchResult result = play(2, NOBODY, player("A", k -> LATE), player("B", k -> LATE));

        assertEquals(List.of("A setup", "B setup", "A ask 1", "A close", "B ask 1", "B close"), log);
        assertEquals(1, result.turns());
        assertEquals("all are out", result.ending());
        assertEquals(-1, result.winner());
        assertEquals(List.of(0, 0), result.players().stream().map(MatchResult.PlayerResult::rank).toList());
        assertTrue(result.anyFault());
    }

    @Test
    void theOtherWinsAndTheTurnOfTheFaultIsPlayed() throws InterruptedException {
        MatchResult result = play(2, NOBODY, player("A", ScriptedPlayer::idle),
            player("B", failingIn(5)));

        assertEquals(5, result.turns());
        assertEquals(0, result.winner());
        assertEquals("all others are out", result.ending());
        assertEquals("no answer", result.players().get(1).fault());
        assertEquals("no answer", result.players().get(1).out());
        assertNull(result.players().get(0).fault());
        assertNull(result.players().get(0).out());
    }

    /** Whether the other one finishes in that turn, or itself would. */
    @ParameterizedTest
    @CsvSource({"1, finished after 1 lap", "0, all others are out"})
    void aPlayerThatFailsInTheTurnOfTheFinishLoses(int finishes, String ending) throws InterruptedException {
        MatchResult result = play(2, startingWith(finishes, aboutToFinish()), player("A", k -> LATE),
            player("B", ScriptedPlayer::idle));

        assertEquals(1, result.winner());
        assertEquals(ending, result.ending());
        assertEquals(1, result.players().get(0).rank());
    }

    @Test
    void whoIsOutByTheRulesIsAskedNoMoreButHearsTheEnd() throws InterruptedException {
        // 51 turns without a checkpoint put A and C out; B stands on its next one and passes it in the first turn.
        PodState atGoal = new PodState(10500, 3500, 0, 0, 0, 0, true, 0);
        play(3, startingWith(1, atGoal), player("A", ScriptedPlayer::idle),
            player("B", failingIn(60)), player("C", ScriptedPlayer::idle));

        assertTrue(log.contains("A ask 51"));
        assertFalse(log.contains("A ask 52"));
        assertTrue(log.contains("A end"));
        assertTrue(log.contains("C end"));
    }

    /** Waiting for one program to exit before sending the end to the next would add up all their times. */
    @Test
    void allAreToldTheEndBeforeAnyIsWaitedFor() throws InterruptedException {
        play(2, startingWith(0, aboutToFinish()), player("A", ScriptedPlayer::idle), player("B", ScriptedPlayer::idle));

        assertEquals(List.of("A last", "B last", "A end", "B end"), log.subList(log.size() - 4, log.size()));
    }

    @Test
    void ofThreeWhoFailedShareTheLastRankAndOneLineEndsTheMatchForTheOther() throws InterruptedException {
        MatchResult result = play(3, NOBODY, player("A", failingIn(3)), player("B", failingIn(2)),
            player("C", ScriptedPlayer::idle));

        assertEquals(List.of("B close", "A close", "C end"),
            log.stream().filter(line -> line.endsWith("close") || line.endsWith("end")).toList());
        assertEquals(List.of(1, 1, 0), result.players().stream().map(MatchResult.PlayerResult::rank).toList());
        assertEquals(2, result.winner());
    }

    @Test
    void onePlayerPlaysUntilItIsOut() throws InterruptedException {
        MatchResult result = play(1, NOBODY, player("A", ScriptedPlayer::idle));

        assertEquals(51, result.turns());
        assertEquals("all are out", result.ending());
        assertEquals("no checkpoint in 51 turns", result.players().get(0).out());
        assertNull(result.players().get(0).fault());
        assertEquals("A end", log.get(log.size() - 1));
    }

    @Test
    void onePlayerThatFailsEndsItsMatch() throws InterruptedException {
        MatchResult result = play(1, NOBODY, player("A", k -> LATE));

        assertEquals(1, result.turns());
        assertEquals("no answer", result.players().get(0).fault());
    }

    @Test
    void asManyPlayersAsTheSceneHas() {
        for (int count : new int[] {0, 1, 3}) {
            List<Player> players = Collections.nCopies(count, player("P", ScriptedPlayer::idle));
            IllegalArgumentException refusal = assertThrows(IllegalArgumentException.class,
                () -> new Referee(TestScenes.open("duel"), 1, players, TimeControl.UNLIMITED, NOBODY));
            assertEquals(count + " bots, expected 2: the scene \"duel\" is for 2 players", refusal.getMessage());
        }
        assertEquals(List.of(), log);
    }

    @Test
    void theFirstAnswerHasALimitOfItsOwn() throws InterruptedException {
        ScriptedPlayer first = player("A", failingIn(3));
        ScriptedPlayer second = player("B", ScriptedPlayer::idle);
        new Referee(TestScenes.open("duel"), 1, List.of(first, second), TimeControl.of(new Time(1000, 75), 2), NOBODY)
            .play();

        assertEquals(List.of(2_000_000_000L, 150_000_000L, 150_000_000L), first.limits());
        assertEquals(first.limits(), second.limits());
    }

    @Test
    void answerTimesAreSummedUpWithTheFirstApart() throws InterruptedException {
        // The k-th answer takes k thousand nanoseconds, and beyond the second one three more lines were waiting.
        MatchResult result = play(2, NOBODY, player("A", failingIn(4)),
            player("B", ScriptedPlayer::idle));

        MatchResult.PlayerResult a = result.players().get(0);
        assertEquals(4, a.answers());
        assertEquals(1000, a.firstNanos());
        assertEquals(3000, a.averageNanos());
        assertEquals(4000, a.worstNanos());
        assertEquals(1, a.earlyTurns());
    }

    @Test
    void aSingleAnswerIsFirstAverageAndWorst() throws InterruptedException {
        MatchResult.PlayerResult a = play(2, NOBODY, player("A", k -> LATE), player("B", ScriptedPlayer::idle))
            .players().get(0);

        assertEquals(List.of(1000L, 1000L, 1000L), List.of(a.firstNanos(), a.averageNanos(), a.worstNanos()));
    }

    @Test
    void aListenerHearsStartThenCommandsAndPlayedPerTurnThenTheEnd() throws InterruptedException {
        List<String> heard = new ArrayList<>();
        MatchListener listener = new MatchListener() {
            @Override
            public void start(Game game, GameJson codec) {
                heard.add("start");
            }

            @Override
            public void commands(Turn turn) {
                heard.add("commands " + turn.number() + " " + turn.asked(0) + turn.answered(0) + turn.asked(1)
                    + turn.answered(1) + " " + turn.fault(0) + " " + turn.nanos(0));
            }

            @Override
            public void played(Turn turn) {
                heard.add("played " + turn.number());
            }

            @Override
            public void end(MatchResult result) {
                heard.add("end " + result.turns());
            }
        };
        play(2, listener, player("A", failingIn(2)), player("B", ScriptedPlayer::idle));

        assertEquals(List.of("start", "commands 1 truetruetruetrue null 1000", "played 1",
            "commands 2 truefalsetruetrue no answer 2000", "played 2", "end 2"), heard);
        assertEquals("B end", log.get(log.size() - 1), "the listener hears of the end before the players do");
    }
}
