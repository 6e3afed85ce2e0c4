package steward.game.pokerchiprace;

import steward.game.pokerchiprace.protocol.PokerChipRaceType.PokerChipRaceSetup;

/** Games of Poker Chip Race with tables of tests. */
public final class ChipTables {

    private ChipTables() { }

    /** A table without chips. @param capacity maximum number of chips */
    public static ChipTable empty(int players, int capacity) {
        return new ChipTable(players, capacity);
    }

    /**
     * A game of a scene with other chips.
     *
     * @param lost per player when it has lost its last chip, below 0 while it is in; the others are out
     */
    public static PokerChipRace game(PokerChipRaceSetup setup, ChipTable table, double... lost) {
        PokerChipRace game = new PokerChipRace(setup.settings(), setup.plan(), table);
        for (int player = 0; player < game.players(); player++) {
            game.lost[player] = lost[player];
            if (lost[player] >= 0) {
                game.eliminate(player, "out before");
            }
        }
        return game;
    }
}
