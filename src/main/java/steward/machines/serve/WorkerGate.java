package steward.machines.serve;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import steward.machines.broker.Gate;

/**
 * Says to the broker who may be handed jobs: workers that are neither paused nor suspended, as many as they said they
 * play.
 */
final class WorkerGate implements Gate {

    private final WorkerPauses pauses;
    /** Jobs that each worker may have at the same time: twice its places, as a report and its job's end are apart. */
    private final Map<String, Integer> most = new ConcurrentHashMap<>();

    WorkerGate(WorkerPauses pauses) {
        this.pauses = pauses;
    }

    /** Workers that may not play until somebody decides. */
    private final Set<String> suspended = ConcurrentHashMap.newKeySet();

    void suspend(String worker, boolean held) {
        if (held) {
            suspended.add(worker);
        } else {
            suspended.remove(worker);
        }
    }

    boolean isSuspended(String worker) {
        return suspended.contains(worker);
    }

    void joined(String worker, int slots) {
        most.put(worker, 2 * slots + 2);
        pauses.untested(worker);
    }

    @Override
    public boolean mayTake(String worker, int jobs) {
        return !isSuspended(worker) && jobs < most.getOrDefault(worker, 0) && pauses.mayTake(worker);
    }

    @Override
    public void took(String worker) {
        pauses.took(worker);
    }
}
