package steward.game.fantasticbits;

import java.util.Arrays;
import steward.numerics.StateHash;

/**
 * Spells of all wizards: active ones with their targets, and spells cast in the last turn, which become active in the
 * next.
 */
public final class SpellBook {

    private static final int NONE = -1;

    private final int[] turns = new int[Pitch.WIZARDS * Spell.count()];
    private final int[] targets = new int[Pitch.WIZARDS * Spell.count()];
    private final int[] cast = new int[Pitch.WIZARDS];
    private final int[] castAt = new int[Pitch.WIZARDS];

    SpellBook() {
        Arrays.fill(targets, NONE);
        Arrays.fill(cast, NONE);
        Arrays.fill(castAt, NONE);
    }

    void copyFrom(SpellBook other) {
        System.arraycopy(other.turns, 0, turns, 0, turns.length);
        System.arraycopy(other.targets, 0, targets, 0, targets.length);
        System.arraycopy(other.cast, 0, cast, 0, cast.length);
        System.arraycopy(other.castAt, 0, castAt, 0, castAt.length);
    }

    private static int place(int wizard, Spell spell) {
        return wizard * Spell.count() + spell.ordinal();
    }

    /** Returns how many turns a wizard's spell works on, the one that is played or was last played included. */
    public int turns(int wizard, Spell spell) {
        return turns[place(wizard, spell)];
    }

    /** The id of the target of a wizard's spell at work, or -1. */
    public int target(int wizard, Spell spell) {
        return targets[place(wizard, spell)];
    }

    /** The spell that a wizard has cast in the last turn, or {@code null}. */
    public Spell cast(int wizard) {
        return cast[wizard] < 0 ? null : Spell.of(cast[wizard]);
    }

    /** The id of its target, or -1. */
    public int castAt(int wizard) {
        return castAt[wizard];
    }

    /** Sets a spell at work, or with 0 turns ends it, whose target is then -1. */
    public void set(int wizard, Spell spell, int left, int target) {
        turns[place(wizard, spell)] = left;
        targets[place(wizard, spell)] = target;
    }

    /** A wizard casts a spell, which works from the next turn on. */
    public void cast(int wizard, Spell spell, int target) {
        cast[wizard] = spell.ordinal();
        castAt[wizard] = target;
    }

    /** A wizard's spells count down, the one that it has cast begins, and those that are over forget their targets. */
    void beginTurn(int wizard, Variant variant) {
        for (int k = wizard * Spell.count(); k < (wizard + 1) * Spell.count(); k++) {
            turns[k] = Math.max(0, turns[k] - 1);
        }
        if (cast[wizard] >= 0) {
            Spell spell = Spell.of(cast[wizard]);
            set(wizard, spell, variant.turns(spell), castAt[wizard]);
            cast[wizard] = NONE;
            castAt[wizard] = NONE;
        }
        for (int k = wizard * Spell.count(); k < (wizard + 1) * Spell.count(); k++) {
            targets[k] = turns[k] == 0 ? NONE : targets[k];
        }
    }

    void addTo(StateHash hash) {
        for (int k = 0; k < turns.length; k++) {
            hash.add(turns[k]).add(targets[k]);
        }
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            hash.add(cast[wizard]).add(castAt[wizard]);
        }
    }
}
