package steward.scene;

import java.util.function.BiFunction;

/** A plan as text: one line per part with in or out, its name and why. */
public final class PlanTable {

    private PlanTable() {
    }

    /** Plain text, every line ended by a newline. */
    public static String of(Plan plan) {
        return of(plan, (part, line) -> line);
    }

    /**
     * @param dress adds colour, or whatever else, to the line of a part; columns are already in place
     */
    public static String of(Plan plan, BiFunction<Part, String, String> dress) {
        int width = plan.parts().stream().mapToInt(part -> part.name().length()).max().orElse(1);
        StringBuilder table = new StringBuilder();
        for (Part part : plan.parts()) {
            String use = part.in() ? "in" : "out";
            String line = String.format("%-3s  %-" + width + "s  %s", use, part.name(), part.why());
            table.append(dress.apply(part, line)).append('\n');
        }
        return table.toString();
    }
}
