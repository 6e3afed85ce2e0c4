package steward.lab.trial;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.Contacts;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.event.EventAdvance;
import steward.physics.event.StepAdvance;
import steward.physics.queue.QueueAdvance;

/**
 * A way to compute a turn: how it is advanced and with what arithmetic.
 *
 * @param name       as in a scene
 * @param isEvent    whether impacts are found by their times; steps miss and shift impacts by their nature
 * @param isExact    whether decisions are exact and results rounded once
 * @param arithmetic of the times of impact
 * @param maker      makes the advance
 * @param crowdMaker makes one for many bodies, at the same law and arithmetic
 */
public record Rung(String name, boolean isEvent, boolean isExact, Arithmetic arithmetic,
                   Function<PhysicsParts, Advance> maker, Function<PhysicsParts, Advance> crowdMaker) {

    /** Of the exact rung: half a unit in the last place for rounding once, and a little for the arithmetic before. */
    public static final double EXACT_ULPS = 0.51;

    /** Of the rungs that advance in steps, two for comparison. */
    private static final List<Integer> STEPS = List.of(1, 64);

    /** All rungs that the table shows, cheapest first. */
    public static List<Rung> all() {
        List<Rung> rungs = new ArrayList<>();
        for (int steps : STEPS) {
            rungs.add(new Rung("step/" + steps, false, false, Arithmetic.DOUBLE,
                parts -> new StepAdvance(parts, steps)));
        }
        for (Arithmetic arithmetic : Arithmetic.values()) {
            rungs.add(new Rung(arithmetic.text(), true, arithmetic == Arithmetic.EXACT, arithmetic,
                EventAdvance::new, QueueAdvance::new));
        }
        return List.copyOf(rungs);
    }

    /** The same advance for few bodies and for many. */
    public Rung(String name, boolean isEvent, boolean isExact, Arithmetic arithmetic, Function<PhysicsParts,
    Advance> maker) {
        this(name, isEvent, isExact, arithmetic, maker, maker);
    }

    /** Whether its expressions are ours to choose; the official ones are the server's, cancellation and all. */
    public boolean isOurs() {
        return isEvent && arithmetic != Arithmetic.OFFICIAL;
    }

    /** Bodies of one kind and finite masses among walls. */
    public Advance advance(ImpactLaw law, Wall... walls) {
        return maker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, false));
    }

    /** The same where there are many bodies: event rungs by {@link QueueAdvance}. */
    public Advance crowdAdvance(ImpactLaw law, Wall... walls) {
        return crowdMaker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, false));
    }

    /** Bodies of one kind and any masses among walls. */
    public Advance advanceOfAnyMass(ImpactLaw law, Wall... walls) {
        return maker.apply(new PhysicsParts(law, arithmetic, new Contacts(1), List.of(walls), null, true));
    }
}
