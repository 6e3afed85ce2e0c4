package steward.bots;

/** What makes one bot different from another: it decides, and neither reads nor writes. */
interface Strategy {

    /**
     * Decides one turn. The same calls in the same order get the same commands: no clock, no chance.
     *
     * @param race     fixed for the match
     * @param pods     all pods as they stand
     * @param commands receives a command for every pod of {@code race.player}
     */
    void decide(Race race, Pods pods, Commands commands);
}
