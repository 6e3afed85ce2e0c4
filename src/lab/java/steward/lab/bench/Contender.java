package steward.lab.bench;

import steward.lab.timing.TimedPlace;
import steward.lab.timing.TimedWork;
import steward.lab.timing.WorkClock;
import steward.lab.timing.WorkTimer;

/**
 * One way to do some work, which is compared with others.
 *
 * @param place where it is timed; never closed
 */
public record Contender(String name, TimedPlace place) {

    /** Work in this JVM, by a clock. */
    public static Contender of(String name, WorkClock clock, TimedWork work) {
        return new Contender(name, new WorkTimer(clock, work));
    }
}
