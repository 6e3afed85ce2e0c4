package steward.lab.trial;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.QueueAdvance;
import steward.physics.event.StepAdvance;

/**
 * A rung of accuracy: a way to advance a turn, with an arithmetic.
 *
 * @param name       as in a scene
 * @param isEvent    whether impacts are found by their times; steps necessarily miss and shift impacts
 * @param isExact    whether decisions are exact and results rounded once
 * @param arithmetic of the times of impact
 * @param maker      makes the advance
 * @param crowdMaker makes the advance for many bodies, with the same law and arithmetic
 */
public record Rung(String name, boolean isEvent, boolean isExact, Arithmetic arithmetic,
                   Function<PhysicsParts, Advance> maker, Function<PhysicsParts, Advance> crowdMaker) {

    /**
     * Error bound of the exact rung: half a unit in the last place for one rounding, and a little for the arithmetic
     * before it.
     */
    public static final double EXACT_ULPS = 0.51;

    /** Steps per turn of the two rungs that advance in steps, for comparison. */
    private static final List<Integer> STEPS = List.of(1, 64);

    /** All rungs in the table, cheapest first. */
    public static List<Rung> all() {
        return Stream.concat(STEPS.stream().map(steps -> new Rung("step/" + steps, false, false, Arithmetic.DOUBLE,
            parts -> new StepAdvance(parts, steps))), Arrays.stream(Arithmetic.values()).map(arithmetic ->
            new Rung(arithmetic.text(), true, arithmetic.isExact(), arithmetic, EventAdvance::new,
                QueueAdvance::new))).toList();
    }

    /** With the same advance for few bodies and for many. */
    public Rung(String name, boolean isEvent, boolean isExact, Arithmetic arithmetic, Function<PhysicsParts,
    Advance> maker) {
        this(name, isEvent, isExact, arithmetic, maker, maker);
    }

    /** True if its expressions are chosen by us; the official ones are the server's, with their cancellation. */
    public boolean isOurs() {
        return isEvent && !arithmetic.isOfficial();
    }

    /** An advance for bodies of one kind with finite masses among walls. */
    public Advance advance(ImpactLaw law, Wall... walls) {
        return maker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, false));
    }

    /** Returns an advance for many bodies: event rungs use {@link QueueAdvance}. */
    public Advance crowdAdvance(ImpactLaw law, Wall... walls) {
        return crowdMaker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, false));
    }

    /** An advance for bodies of one kind with any masses among walls. */
    public Advance advanceOfAnyMass(ImpactLaw law, Wall... walls) {
        return maker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, true));
    }
}
