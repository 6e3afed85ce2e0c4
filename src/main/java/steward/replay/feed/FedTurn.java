package steward.replay.feed;

import java.util.List;
import steward.replay.verify.ReplayDifference;

/**
 * A bot's answer to a turn of a recorded match, beside the recorded answer.
 *
 * @param number        of the turn, counted from 1
 * @param replaced      whether its answer was played in place of the recorded one
 * @param fault         what is wrong with its answer, or why there is none; or {@code null}
 * @param recordedFault the same as it was recorded
 * @param differences   between the commands, if both are good
 * @param gone          whether the bot can be asked no more
 */
public record FedTurn(int number, boolean replaced, String fault, String recordedFault,
                      List<ReplayDifference> differences, boolean gone) {

    public FedTurn {
        differences = List.copyOf(differences);
    }

    /** True if it did what was recorded. */
    public boolean same() {
        return differences.isEmpty() && (fault == null ? recordedFault == null : fault.equals(recordedFault));
    }
}
