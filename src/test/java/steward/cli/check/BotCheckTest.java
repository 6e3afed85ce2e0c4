package steward.cli.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.Answer;
import steward.bot.FaultMessages;
import steward.bot.Player;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.match.Protocol;

/**
 * Checks of a correct program on a busy machine. What is measured is made up: the program computes 5 ms for an answer,
 * and by the wall clock it waits for a processor besides, in as many games as the test says.
 */
class BotCheckTest {

    private static final long MS = 1_000_000;
    private static final long COMPUTED = 5 * MS;

    /** Basis of the limits in each game that was begun. */
    private final List<TimeBasis> begun = new ArrayList<>();

    /** The first answer, as in a class with many programs at once, and a later one. */
    @ParameterizedTest
    @ValueSource(ints = {1, 7})
    void aProgramThatWaitsForAProcessorIsTriedWithoutThat(int lateTurn) throws InterruptedException {
        BotCheck check = check(lateTurn, Integer.MAX_VALUE, COMPUTED);
        assertEquals(List.of(TimeBasis.WALL, TimeBasis.WALL, TimeBasis.UNSTARVED), begun);
        assertTrue(check.passes(), () -> check.problems().toString());
        assertTrue(check.steps().stream().anyMatch(step -> step.startsWith("  yes  keeps the limit with room")
            && step.endsWith("without waiting for processors that other programs used")),
            () -> check.steps().toString());
    }

    @Test
    void aProgramThatWaitedOnceIsTriedAgainByTheClock() throws InterruptedException {
        BotCheck check = check(3, 1, COMPUTED);
        assertEquals(List.of(TimeBasis.WALL, TimeBasis.WALL), begun);
        assertTrue(check.passes(), () -> check.problems().toString());
    }

    /** Without waiting for a processor it is late as well: the limit of the search race is 50 ms. */
    @Test
    void aProgramThatComputesTooLongFails() throws InterruptedException {
        BotCheck check = check(7, Integer.MAX_VALUE, 60 * MS);
        assertEquals(List.of(TimeBasis.WALL, TimeBasis.WALL, TimeBasis.UNSTARVED), begun);
        assertFalse(check.passes());
        assertNotNull(check.failure());
        assertTrue(check.problems().get(0).contains("It computed all the time"), () -> check.problems().toString());
    }

    /** @param games by the wall clock in which the program waits, from the first on */
    private BotCheck check(int lateTurn, int games, long computed) throws InterruptedException {
        Contest empty = Contest.withoutBots(Games.open("search-race"), 1).startedBy((entrant, isolation, others) ->
            new Measured(lateTurn, games, computed));
        return BotCheck.of(empty, Contest.entrant("mine=/bin/sh", Protocol.CODINGAME));
    }

    /** Drives nowhere; its times are made up. */
    private final class Measured implements Player {

        private final int lateTurn;
        private final int games;
        private final long computed;
        private TimeBasis basis = TimeBasis.WALL;
        private int turn;

        private Measured(int lateTurn, int games, long computed) {
            this.lateTurn = lateTurn;
            this.games = games;
            this.computed = computed;
        }

        @Override
        public String name() {
            return "mine";
        }

        @Override
        public void limitBy(TimeBasis other) {
            basis = other;
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            if (++turn == 1) {
                begun.add(basis);
            }
            answer.clear();
            long used = turn == lateTurn ? computed : MS;
            boolean waits = turn == lateTurn && basis == TimeBasis.WALL && begun.size() <= games;
            long taken = waits ? limitNanos + MS : used;
            answer.setNanos(taken);
            if (taken < limitNanos) {
                byte[] line = "0 0 200".getBytes(StandardCharsets.US_ASCII);
                answer.append(line, 0, line.length);
                return Ending.ANSWERED;
            }
            answer.setFault(FaultMessages.late(limitNanos, taken));
            answer.setTimeSpent(new TimeSpent(limitNanos, taken, 0, used, taken - used, 0, used, TimeSpent.Shows.ALL,
                false));
            return Ending.FAULT;
        }
    }
}
