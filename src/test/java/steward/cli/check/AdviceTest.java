package steward.cli.check;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import steward.bot.TimeSpent;
import steward.contest.Failure;

/** Words for a beginner about a failure. */
class AdviceTest {

    private static long ms(long time) {
        return TimeUnit.MILLISECONDS.toNanos(time);
    }

    /** 77 of 458 ms are few by the wall clock, as other programs used the processors; they are all that it may use. */
    @Test
    void whoUsedUpItsCpuTimeHasComputed() {
        TimeSpent time = new TimeSpent(ms(75), ms(458), 0, ms(77), ms(289), ms(92), ms(78), TimeSpent.Shows.ALL, true);
        String advice = Advice.about(new Failure(0, 5, "no answer within 75 ms of CPU time (used 78 ms in 458 ms)",
            List.of(), null, List.of(), time, null));
        assertTrue(advice.startsWith("It computed all the time: let it stop its search by the clock"), advice);
    }
}
