package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import steward.bot.Burner;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.bot.UnstartablePlayer;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.cli.shared.Games;
import steward.contest.Contest.Entrant;
import steward.match.Protocol;
import steward.match.TimeControl;

/** How often a game is played that a bot lost on time. */
class AttemptsTest {

    private static final long MS = 1_000_000;

    private final TreeMap<String, HoldPolicy> started = new TreeMap<>();
    private final Contest contest = new Contest(Games.open("duel"), List.of(entrant("hog"), entrant("honest")),
            new TimeControl(1000 * MS, 75 * MS), 1)
        .isolatedBy(() -> Isolation.at(SandboxLevel.LIGHT)).startedBy((entrant, isolation, others) -> {
            started.put(entrant.name(), isolation.hold());
            return new UnstartablePlayer(entrant.name(), "not to be played");
        });

    private static Entrant entrant(String name) {
        return new Entrant(name, name, Protocol.JSON, List.of(name));
    }

    /** A failure of the second bot on time. */
    private static List<Failure> late(boolean starved, Burner burner) {
        TimeSpent time = new TimeSpent(75 * MS, 76 * MS, 0, 10 * MS, (starved ? 60 : 5) * MS, 0, 10 * MS,
            TimeSpent.Shows.ALL, false);
        return List.of(new Failure(1, 5, "no answer", List.of(), "", List.of(), time, burner));
    }

    private static List<Failure> beside(boolean holdable) {
        return late(true, new Burner(0, 1.5, holdable));
    }

    private Attempts attempts(Hiccups hiccups) {
        return new Attempts(contest, hiccups, 0);
    }

    @Test
    void aGameBesideABurnerIsPlayedAgainOnceWithTheBurnerHeld() {
        Attempts attempts = attempts(Hiccups.REPLAY);
        assertSame(contest, attempts.contest());
        assertTrue(attempts.demandAnother(beside(true)));
        attempts.contest().player(contest.entrants().get(0));
        attempts.contest().player(contest.entrants().get(1));
        assertEquals("{hog=ALWAYS, honest=BURNERS}", started.toString());
        assertFalse(attempts.demandAnother(beside(true)), "the second counts, however it ends");
        assertNull(attempts.discarded());
    }

    @Test
    void whereTheBurnerCannotBeHeldTheThirdGameDoesNotCount() {
        Attempts attempts = attempts(Hiccups.REPLAY);
        assertTrue(attempts.demandAnother(beside(false)));
        assertTrue(attempts.demandAnother(beside(false)));
        assertSame(contest, attempts.contest());
        assertNull(attempts.discarded());
        assertFalse(attempts.demandAnother(beside(false)));
        assertEquals("not counted: hog computed on 1.50 processors while honest was asked, in each of 3 attempts, and "
            + "cannot be held here", attempts.discarded());
    }

    @Test
    void anAttemptThatIsNotLostCounts() {
        Attempts attempts = attempts(Hiccups.REPLAY);
        assertTrue(attempts.demandAnother(beside(false)));
        assertFalse(attempts.demandAnother(List.of()));
        assertNull(attempts.discarded());
    }

    /** Each of the two reasons is good for one more game. */
    @Test
    void aStarvedGameAndOneBesideABurnerAreThreeGames() {
        Attempts attempts = attempts(Hiccups.REPLAY);
        assertTrue(attempts.demandAnother(late(true, null)));
        assertTrue(attempts.demandAnother(beside(true)));
        assertFalse(attempts.demandAnother(late(true, null)));
        assertEquals(Attempts.MOST, attempts.played());
        Attempts twice = attempts(Hiccups.REPLAY);
        assertTrue(twice.demandAnother(late(true, null)));
        assertEquals(TimeBasis.UNSTARVED, twice.contest().time().basis());
        assertTrue(twice.demandAnother(late(true, null)), "the machine was too busy for ten times the limit");
        assertFalse(twice.demandAnother(late(true, null)));
        assertEquals("not counted: honest waited for a processor that other programs used, in each of 3 attempts",
            twice.discarded());
    }

    @Test
    void aBotThatIsLateByItselfHasLost() {
        assertFalse(attempts(Hiccups.REPLAY).demandAnother(late(false, null)));
    }

    /** It slept and waited for ten times its CPU time, and used none of it: waiting was a seventh of that. */
    @Test
    void aBotThatHangsUnderALimitOfCpuTimeHasLostThoughItWaitedAWhile() {
        TimeSpent time = new TimeSpent(750 * MS, 751 * MS, 0, 0, 110 * MS, 641 * MS, 0, TimeSpent.Shows.ALL, false);
        List<Failure> hung = List.of(new Failure(1, 5, "no answer", List.of(), "", List.of(), time, null));
        assertFalse(new Attempts(contest.limitedBy(TimeBasis.CPU), Hiccups.REPLAY, 0).demandAnother(hung));
        assertTrue(attempts(Hiccups.REPLAY).demandAnother(hung));
    }

    @Test
    void allCountsIfThatIsWanted() {
        for (boolean holdable : List.of(true, false)) {
            assertFalse(attempts(Hiccups.COUNT).demandAnother(beside(holdable)));
        }
    }

    /** With the sides changed the bots are named by their places in the call. */
    @Test
    void theBurnerIsFoundBehindItsPlace() {
        Attempts attempts = new Attempts(contest, Hiccups.REPLAY, 1);
        List<Failure> failures = new ArrayList<>(beside(true));
        assertTrue(attempts.demandAnother(failures));
        attempts.contest().player(contest.entrants().get(1));
        assertEquals("{honest=ALWAYS}", started.toString());
    }
}
