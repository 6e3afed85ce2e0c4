package steward.game.fantasticbits;

import java.util.Locale;

/** The two forms in which the site has published the game. */
public enum Variant {

    /** The contest of 2016. */
    CONTEST(3, 20),
    /** The multiplayer game that followed it. */
    PUZZLE(4, 15);

    private final int obliviateTurns;
    private final int accioCost;
    private final String text = name().toLowerCase(Locale.ROOT);

    Variant(int obliviateTurns, int accioCost) {
        this.obliviateTurns = obliviateTurns;
        this.accioCost = accioCost;
    }

    /** How many turns a spell works. */
    public int turns(Spell spell) {
        return switch (spell) {
            case OBLIVIATE -> obliviateTurns;
            case PETRIFICUS -> 1;
            case ACCIO -> 6;
            case FLIPENDO -> 3;
        };
    }

    /** The magic that a spell costs. */
    public int cost(Spell spell) {
        return switch (spell) {
            case OBLIVIATE -> 5;
            case PETRIFICUS -> 10;
            case ACCIO -> accioCost;
            case FLIPENDO -> 20;
        };
    }

    /** Its name in scenes. */
    public String text() {
        return text;
    }
}
