package steward.guest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Players whom a referee throws out: its words decide, and no score alone. */
class ExpulsionsTest {

    private static final String RED = "\u00a4RED\u00a4";
    private static final String END = "\u00a7RED\u00a7";

    private final Expulsions expulsions = new Expulsions(2);

    private void answers(int... players) {
        for (int player : players) {
            expulsions.answered(player, 1, 0);
        }
    }

    @Test
    void theRefereesWordsAndAScoreOfMinusOneAreAFailure() {
        answers(0, 1);
        expulsions.said(List.of("$0: moves", "found x", RED + "$1: no such cell" + END, RED + "2 errors of $1" + END));
        assertEquals("found x; no such cell; 2 errors of player 1", expulsions.of(1, -1));
        assertNull(expulsions.of(0, -1));
        assertNull(expulsions.of(1, -2), "another negative score is one of the game");
    }

    @Test
    void aScoreAloneAndALineWithoutColourAreNone() {
        answers(0, 1);
        expulsions.said(List.of("$1: moves", "\u00a4GREEN\u00a4$1 won\u00a7GREEN\u00a7"));
        assertNull(expulsions.of(1, -1));
    }

    /** What comes first in red is the name of who was wrong; others are those it hit, or its own words. */
    @Test
    void whoIsOnlyMentionedIsNotBlamed() {
        answers(0, 1);
        expulsions.said(List.of(RED + "$0: expected MOVE, got '$1'" + END, RED + "fire" + END + " hits $1",
            RED + "$12 is no player here" + END));
        assertNull(expulsions.of(1, -1));
        assertEquals("expected MOVE, got '$1'", expulsions.of(0, -1));
    }

    /** A line before the last answer is a warning; once the other player has answered twice, this one is out. */
    @Test
    void whoIsNotAskedAnyMoreWhileOthersAreIsOut() {
        answers(0, 1);
        expulsions.said(List.of(RED + "$1 was disqualified" + END));
        assertNull(expulsions.of(1, 0));
        answers(0);
        assertNull(expulsions.of(1, 0), "the other had its turn, and the game may end with it");
        answers(0);
        assertEquals("was disqualified", expulsions.of(1, 0));
        answers(1);
        assertNull(expulsions.of(1, -1));
    }

    @Test
    void theThirdLateAnswerStrikesOutUnlessThePlayerGoesOn() {
        for (int ms : new int[] {50, 51, 40, 99}) {
            expulsions.answered(0, ms, 50);
        }
        assertNull(expulsions.of(0, -1));
        expulsions.answered(0, 60, 50);
        assertEquals("late 3 times, after 51, 99, 60 ms, expected answers within 50 ms", expulsions.of(0, 12));
        expulsions.answered(0, 1, 50);
        assertNull(expulsions.of(0, 12));
    }
}
