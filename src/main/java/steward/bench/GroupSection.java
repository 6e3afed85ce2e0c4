package steward.bench;

import java.util.List;
import java.util.function.Consumer;

/**
 * Contenders that the caller brings, in groups; in each the first is what the others are compared with.
 *
 * @param name   a word
 * @param about  what is measured
 * @param groups by unit
 */
public record GroupSection(String name, String about, List<Group> groups) implements Section {

    /**
     * Ways to do the same.
     *
     * @param unit       what is counted
     * @param contenders the textbook's way first
     */
    public record Group(String unit, List<Contender> contenders) {
    }

    @Override
    public int steps(Effort effort) {
        return steps(groups.stream().mapToInt(group -> group.contenders().size()).sum(), effort);
    }

    /** How many steps so many contenders take, in whatever groups. */
    public static int steps(int contenders, Effort effort) {
        return contenders * (1 + effort.rounds());
    }

    @Override
    public void run(Effort effort, Consumer<String> progress, Consumer<Row> rows) throws Exception {
        for (Group group : groups) {
            new Meter().compare(name, group.unit(), group.contenders(), effort, progress, rows);
        }
    }
}
