package steward.machines.worker;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import steward.bot.ErrorLine;
import steward.bot.FaultMessages;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.match.MatchListener;
import steward.match.Turn;

/** Tests whether a bot runs on this machine, by asking it once in the first turn of a game against itself. */
final class BotTrial {

    /** Returns why it does not run here, or {@code null}. A late answer says nothing: the machine may be busy. */
    static String problem(Contest contest, Entrant entrant) throws InterruptedException {
        if (entrant.problem() != null) {
            return entrant.problem();
        }
        List<Entrant> all = Collections.nCopies(contest.players(), entrant);
        String[] found = {null};
        try {
            contest.between(all).play(0, 0, null, new MatchListener() {
                @Override
                public void commands(Turn turn) {
                    // A guest's referee asks whom it likes first.
                    int failed = IntStream.range(0, all.size()).filter(k -> turn.fault(k) != null).findAny().orElse(0);
                    String fault = turn.fault(failed);
                    String wrote = ErrorLine.of(turn.stderr(failed));
                    found[0] = fault == null || FaultMessages.isTime(fault) ? null
                        : fault + (wrote.isEmpty() ? "" : "; it wrote: " + wrote);
                    throw new UncheckedIOException(new IOException("the trial is over"));
                }
            });
        } catch (UncheckedIOException over) {
            return found[0];
        }
        return found[0];
    }
}
