package steward.scene;

import java.util.function.BiFunction;
import java.util.function.Function;

/** A plan as text: one line per part with in or out, optionally its price, its name and the reason. */
public final class PlanTable {

    private PlanTable() { }

    /** Plain text, every line ended by a newline. */
    public static String of(Plan plan) {
        return of(plan, part -> "", (part, line) -> line);
    }

    /**
     * @param price    a word for each part, in a column of its own; no column if all are empty
     * @param decorate changes the line of a part after the columns are aligned, for example by colour
     */
    public static String of(Plan plan, Function<Part, String> price, BiFunction<Part, String, String> decorate) {
        int width = plan.parts().stream().mapToInt(part -> part.name().length()).max().orElse(1);
        int prices = plan.parts().stream().mapToInt(part -> price.apply(part).length()).max().orElse(0);
        String column = prices == 0 ? "%s" : "%" + prices + "s  ";
        StringBuilder table = new StringBuilder();
        for (Part part : plan.parts()) {
            String line = String.format("%-3s  " + column + "%-" + width + "s  %s", part.in() ? "in" : "out",
                price.apply(part), part.name(), part.why());
            table.append(decorate.apply(part, line)).append('\n');
        }
        return table.toString();
    }
}
