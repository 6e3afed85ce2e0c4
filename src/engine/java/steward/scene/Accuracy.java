package steward.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.physics.Advance;
import steward.physics.Arithmetic;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.event.EventAdvance;
import steward.physics.event.OfficialAdvance;
import steward.physics.event.QueueAdvance;
import steward.physics.event.StepAdvance;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonNumber;
import steward.scene.json.JsonValue.JsonObject;
import steward.scene.json.JsonValue.JsonText;
import steward.scene.json.SourcePosition;
import steward.scene.json.Wording;
import steward.text.NearestName;

/**
 * Accuracy of a scene: a rung of the ladder from {@code step/1}, the cheapest, to {@code event/exact}.
 *
 * @param way        how a turn is advanced
 * @param steps      steps per turn, 1..{@value StepAdvance#MOST_STEPS}; 0 for {@code EVENT}
 * @param arithmetic how times of impact are computed; {@code DOUBLE} for steps, which compute none
 */
public record Accuracy(Way way, int steps, Arithmetic arithmetic) {

    /**
     * From this number of bodies on, {@link QueueAdvance} is used instead of {@link EventAdvance}; measured by
     * {@code QueueBenchmark}. With half an impact per body the two are equal at about 8 bodies, in turns without
     * impacts at about 32; at 24 bodies the queue costs a quarter more without impacts, and a third or less of the scan
     * with them.
     */
    static final int FEWEST_FOR_CELLS = 24;

    /** Way to advance a turn. */
    public enum Way {
        /** From impact to impact at exact times. */
        EVENT,
        /** In fixed steps. */
        STEP;

        /** Its name in a scene. */
        public String text() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** @throws IllegalArgumentException if the values contradict each other */
    public Accuracy {
        if (way == Way.EVENT && steps != 0) {
            throw new IllegalArgumentException("accuracy: steps " + steps + ", expected 0 with advance event");
        }
        if (way == Way.STEP && (steps < 1 || steps > StepAdvance.MOST_STEPS)) {
            throw new IllegalArgumentException(
                "accuracy: steps " + steps + ", expected a whole number 1.." + StepAdvance.MOST_STEPS);
        }
        if (way == Way.STEP && arithmetic != Arithmetic.DOUBLE) {
            throw new IllegalArgumentException(
                "accuracy: arithmetic \"" + arithmetic.text() + "\", expected " + ONLY_DOUBLE);
        }
    }

    /** The arithmetic expected with steps, with the reason; for errors. */
    static final String ONLY_DOUBLE = "\"double\", because steps look for overlaps and compute no times of impact";

    /** From impact to impact. */
    public static Accuracy event(Arithmetic arithmetic) {
        return new Accuracy(Way.EVENT, 0, arithmetic);
    }

    /** {@code steps} steps per turn. */
    public static Accuracy step(int steps) {
        return new Accuracy(Way.STEP, steps, Arithmetic.DOUBLE);
    }

    /**
     * The rungs, cheapest first: {@code step/1}, {@code step/2}, {@code step/4}, ... {@code step/1024}, then the
     * arithmetics of {@code event}.
     */
    public static List<Accuracy> ladder() {
        return Stream.concat(IntStream.iterate(1, steps -> steps <= StepAdvance.MOST_STEPS, steps -> 2 * steps)
            .mapToObj(Accuracy::step), Arrays.stream(Arithmetic.values()).map(Accuracy::event)).toList();
    }

    /**
     * A rung from its short form: {@code event/ARITHMETIC}, {@code step/K}, or an arithmetic alone, which means
     * {@code event}; {@code event} alone means {@code event/double}.
     *
     * @throws IllegalArgumentException with what was found, what was expected and the nearest name
     */
    public static Accuracy parse(String text) {
        Map<String, Arithmetic> arithmetics = arithmetics();
        if (arithmetics.containsKey(text)) {
            return event(arithmetics.get(text));
        }
        int slash = text.indexOf('/');
        String way = slash < 0 ? text : text.substring(0, slash);
        String rest = slash < 0 ? "" : text.substring(slash + 1);
        if (way.equals("step")) {
            return step(parseSteps(text, rest));
        }
        if (way.equals("event")) {
            if (slash >= 0 && !arithmetics.containsKey(rest)) {
                throw refusal(text, "event/ and " + Wording.choice(rest, arithmetics.keySet()));
            }
            return event(slash < 0 ? Arithmetic.DOUBLE : arithmetics.get(rest));
        }
        List<String> known = new ArrayList<>(List.of("event", "step"));
        known.addAll(arithmetics.keySet());
        throw refusal(text, "event/ARITHMETIC, step/K or "
            + Wording.oneOf(arithmetics.keySet())
            + NearestName.question(way, known, "\""));
    }

    private static int parseSteps(String text, String steps) {
        String expected = "step/ and a whole number 1.." + StepAdvance.MOST_STEPS;
        if (!steps.matches("[0-9]{1,4}")) {
            throw refusal(text, expected);
        }
        int count = Integer.parseInt(steps);
        if (count < 1 || count > StepAdvance.MOST_STEPS) {
            throw refusal(text, expected);
        }
        return count;
    }

    private static IllegalArgumentException refusal(String text, String expected) {
        return new IllegalArgumentException("accuracy: found \"" + text + "\", expected " + expected);
    }

    /** The short form that {@link #parse} reads. */
    public String text() {
        return way.text() + "/" + (way == Way.STEP ? Integer.toString(steps) : arithmetic.text());
    }

    @Override
    public String toString() {
        return text();
    }

    /** The block {@code accuracy} of a scene that states this rung. */
    JsonObject json() {
        SourcePosition nowhere = new SourcePosition(1, 1);
        Map<String, Entry> entries = new LinkedHashMap<>();
        entries.put("advance", new Entry(nowhere, new JsonText(nowhere, way.text())));
        if (way == Way.STEP) {
            entries.put("steps", new Entry(nowhere, new JsonNumber(nowhere, Integer.toString(steps))));
        }
        entries.put("arithmetic", new Entry(nowhere, new JsonText(nowhere, arithmetic.text())));
        return new JsonObject(nowhere, entries);
    }

    /** The cheapest advance for {@code bodies} bodies on this rung: all candidates give the same impacts. */
    public Advance advance(PhysicsParts parts, int bodies) {
        return usesExpressionsOfGame(parts) ? parts.official().of(parts)
            : usesCells(parts.law(), bodies) ? new QueueAdvance(parts)
            : usesOfficialLoop(parts, bodies) ? new OfficialAdvance(parts) : advance(parts);
    }

    /** True if that is {@link QueueAdvance}: cells and an event queue instead of a scan of all pairs. */
    boolean usesCells(ImpactLaw law, int bodies) {
        return way == Way.EVENT && bodies >= FEWEST_FOR_CELLS && QueueAdvance.refusal(law) == null;
    }

    /** True if that is the game's own, with its referee's expressions. */
    boolean usesExpressionsOfGame(PhysicsParts parts) {
        return way == Way.EVENT && parts.usesExpressionsOfGame();
    }

    /** True if that is {@link OfficialAdvance}. */
    boolean usesOfficialLoop(PhysicsParts parts, int bodies) {
        return way == Way.EVENT && bodies > 0 && bodies <= OfficialAdvance.MOST_BODIES && OfficialAdvance.fits(parts);
    }

    /** The advance on this rung that scans all pairs each time: for few bodies. */
    public Advance advance(PhysicsParts parts) {
        return way == Way.STEP ? new StepAdvance(parts, steps)
            : usesExpressionsOfGame(parts) ? parts.official().of(parts) : new EventAdvance(parts);
    }

    /** The arithmetics by their names, in the order of accuracy. */
    static Map<String, Arithmetic> arithmetics() {
        Map<String, Arithmetic> names = new LinkedHashMap<>();
        for (Arithmetic arithmetic : Arithmetic.values()) {
            names.put(arithmetic.text(), arithmetic);
        }
        return names;
    }
}
