package steward.lab.bench;

import java.util.List;
import java.util.function.Consumer;

/**
 * Contenders given by the caller, in groups; the others of a group are compared with its first.
 *
 * @param groups by unit
 */
public record GroupSection(String name, String about, List<Group> groups) implements Section {

    /**
     * Several ways to do the same work.
     *
     * @param contenders the textbook's way first
     */
    public record Group(String unit, List<Contender> contenders) { }

    @Override
    public int steps(Effort effort) {
        return steps(groups.stream().mapToInt(group -> group.contenders().size()).sum(), effort);
    }

    /** Returns how many steps this many contenders take, however they are grouped. */
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
