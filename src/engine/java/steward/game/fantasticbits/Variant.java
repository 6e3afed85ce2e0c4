package steward.game.fantasticbits;

import java.util.Locale;

/**
 * The two forms in which the site has published the game. They differ in how long spells work and what they cost, by
 * spell in the order of {@link Spell}.
 */
public enum Variant {

    /** The contest of 2016. */
    CONTEST(new int[] {3, 1, 6, 3}, new int[] {5, 10, 20, 20}),
    /** The multiplayer game that followed it. */
    PUZZLE(new int[] {4, 1, 6, 3}, new int[] {5, 10, 15, 20});

    private final int[] turns;
    private final int[] costs;
    private final String text = name().toLowerCase(Locale.ROOT);

    Variant(int[] turns, int[] costs) {
        this.turns = turns;
        this.costs = costs;
    }

    /** Returns how many turns a spell works. */
    public int turns(Spell spell) {
        return turns[spell.ordinal()];
    }

    public int cost(Spell spell) {
        return costs[spell.ordinal()];
    }

    /** Its name in scenes. */
    public String text() {
        return text;
    }
}
