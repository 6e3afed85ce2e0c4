package steward.contest.seeds;

import java.util.List;
import java.util.Set;

/** Seeds of a series of games by position, counted from 0: consecutive numbers, or a finite list. */
public final class Seeds {

    private final long first;
    private final List<Long> listed;
    private final Set<Long> all;

    private Seeds(long first, List<Long> listed) {
        this.first = first;
        this.listed = listed;
        all = listed == null ? Set.of() : Set.copyOf(listed);
    }

    /** Returns the seeds {@code first}, {@code first + 1} and so on. */
    public static Seeds from(long first) {
        return new Seeds(first, null);
    }

    /** Returns the seeds of a list, in its order. */
    public static Seeds of(List<Long> listed) {
        return new Seeds(0, List.copyOf(listed));
    }

    /** True if they are those of a list. */
    public boolean isListed() {
        return listed != null;
    }

    /** Returns how many there are; {@code Integer.MAX_VALUE} in a row. */
    public int count() {
        return listed == null ? Integer.MAX_VALUE : listed.size();
    }

    /** Returns the seed at a place from 0 on. */
    public long at(int place) {
        return listed == null ? first + place : listed.get(place);
    }

    /** True if a list has a seed. */
    public boolean has(long seed) {
        return all.contains(seed);
    }

    /** Returns those from a place on. */
    public Seeds after(int place) {
        return listed == null ? from(first + place) : of(listed.subList(Math.min(place, count()), count()));
    }
}
