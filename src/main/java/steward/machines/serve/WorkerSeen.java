package steward.machines.serve;

import java.util.List;

/**
 * State of a worker as it is shown to people.
 *
 * @param slots    games at the same time; 0 if it is not there
 * @param rate     games in a second that were believed, in this run
 * @param silentMs since its last word
 * @param suspended true if its games do not count until somebody decides
 * @param doubts   what is doubtful by the answers of its bots, a sentence each
 */
public record WorkerSeen(String name, int slots, double rate, String version, long silentMs, boolean caught,
                         boolean suspended, List<String> doubts) { }
