package steward.scene;

import java.util.function.BiFunction;

/** Plan of a scene as text: one line per part with in or out, its name and the reason. */
public final class PlanTable {

    private PlanTable() { }

    /**
     * Text, every line ended by a newline.
     *
     * @param decorate changes the line of a part after the columns are aligned, for example by colour
     */
    public static String of(Plan plan, BiFunction<Part, String, String> decorate) {
        int width = plan.parts().stream().mapToInt(part -> part.name().length()).max().orElse(1);
        StringBuilder table = new StringBuilder();
        for (Part part : plan.parts()) {
            String line = String.format("%-3s  %-" + width + "s  %s", part.in() ? "in" : "out", part.name(),
                part.why());
            table.append(decorate.apply(part, line)).append('\n');
        }
        return table.toString();
    }
}
