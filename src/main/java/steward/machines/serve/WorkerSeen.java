package steward.machines.serve;

/**
 * A worker, for people.
 *
 * @param name     its name
 * @param slots    games at the same time; 0 if it is not there
 * @param games    that were believed
 * @param rate     in a second
 * @param faults   of bots
 * @param repeated games that were played again because the machine was starved
 * @param version  of its program
 * @param silentMs since its last word
 * @param caught   whether it was caught
 */
public record WorkerSeen(String name, int slots, long games, double rate, long faults, long repeated, String version,
                   long silentMs, boolean caught) {
}
