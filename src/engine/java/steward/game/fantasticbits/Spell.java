package steward.game.fantasticbits;

import java.util.Locale;

/** Spells of wizards; the last three in the order in which they work within a turn. */
public enum Spell {

    /** A bludger leaves the caster's team alone. */
    OBLIVIATE,
    /** The target stands still. */
    PETRIFICUS,
    /** The target is drawn to the caster. */
    ACCIO,
    /** The target is pushed away from the caster. */
    FLIPENDO;

    private static final Spell[] ALL = values();

    private final String text = name().toLowerCase(Locale.ROOT);

    public static Spell of(int number) {
        return ALL[number];
    }

    public static int count() {
        return ALL.length;
    }

    /** Its name in frames. */
    public String text() {
        return text;
    }

    /** True if it may be aimed at an entity of this kind; that a wizard is of the other team is asked elsewhere. */
    boolean suits(EntityKind target) {
        return switch (target) {
            case BLUDGER -> true;
            case SNAFFLE, HELD_SNAFFLE -> this != OBLIVIATE;
            case WIZARD -> this == PETRIFICUS || this == FLIPENDO;
            default -> false;
        };
    }
}
