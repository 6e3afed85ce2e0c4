package steward.bots;

/** The decision of a bot, which makes one bot different from another; it neither reads nor writes. */
interface Strategy {

    /**
     * Decides one turn. Equal calls in equal order get equal commands: no clock, no randomness.
     *
     * @param race     fixed for the match
     * @param pods     the current state of all pods
     * @param commands receives a command for every pod of {@code race.player}
     */
    void decide(Race race, Pods pods, Commands commands);
}
