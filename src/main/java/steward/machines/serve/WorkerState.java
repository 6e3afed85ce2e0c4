package steward.machines.serve;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * State of a worker as the league tracks it: its free slots, version, games, last word, and which bundles do not run
 * there. Guarded by {@link RemoteGames}.
 */
final class WorkerState {

    /** Number of workers whose reasons are told. */
    private static final int MOST_REASONS = 3;

    final String name;
    int slots;
    String version = "";
    String machine = "";
    /** Factor of its time limits besides the league's own. */
    double scale = 1;
    long games;
    long checked;
    long began;
    long lastWord;
    boolean caught;
    /** Bundles that do not run there, and why. */
    final Map<String, String> unfit = new TreeMap<>();

    WorkerState(String name) {
        this.name = name;
    }

    /** Returns what is shown of it. @param doubts a sentence each */
    WorkerSeen seen(boolean suspended, List<String> doubts) {
        return new WorkerSeen(name, slots, games / (Math.max(1, System.nanoTime() - began) / 1e9), version,
            System.currentTimeMillis() - lastWord, caught, suspended, doubts);
    }

    /** Returns why no worker that is there can play with these bundles, as each has said; {@code null} if one may. */
    static String obstacle(Collection<WorkerState> workers, List<String> needs) {
        List<String> reasons = new ArrayList<>();
        for (WorkerState worker : workers) {
            String why = needs.stream().map(worker.unfit::get).filter(Objects::nonNull).findFirst().orElse(null);
            if (worker.slots > 0 && why == null) {
                return null;
            } else if (worker.slots > 0) {
                reasons.add("worker " + worker.name + ": " + why);
            }
        }
        return reasons.isEmpty() ? null : reasons.stream().limit(MOST_REASONS).collect(Collectors.joining("; "));
    }

    /** Describes the difference between two programs that do not compute the same. */
    String apart(String theirs, String theirResults, String ours, String ourResults) {
        return "found Steward " + theirs + " (results " + theirResults + ") on worker " + name + " and Steward " + ours
            + " (results " + ourResults + ") in the league, expected versions that compute the same";
    }

    /** Describes a worker that takes no guests, where the scene has a referee of its own. */
    String withoutGuests() {
        return "worker " + name + " plays nothing: the scene has a referee of its own, and the worker runs none "
            + "without --guests";
    }
}
