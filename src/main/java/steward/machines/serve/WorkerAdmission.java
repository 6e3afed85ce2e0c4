package steward.machines.serve;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.machines.broker.Admission;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerPauses;

/**
 * Admission of workers by the league's list, which is read anew after each change of its file. Jobs are handed to
 * workers that are neither paused nor suspended, as many as they said they can play. Thread-safe.
 */
final class WorkerAdmission implements Admission {

    private final LeagueFolder folder;
    private final WorkerPauses pauses;
    private final Consumer<String> teller;
    /** Jobs that each worker may have at the same time: twice its places, as a report and its job's end are apart. */
    private final Map<String, Integer> most = new ConcurrentHashMap<>();
    /** Workers that may not play until somebody decides. */
    private final Set<String> suspended = ConcurrentHashMap.newKeySet();
    private volatile WorkerList list;
    /** Stamp of the file when a worker was not on the list. */
    private volatile String missed = "";
    /** Used by one thread. */
    private String stamp;

    /** @param teller is told who comes with an invitation, and when the list cannot be read */
    WorkerAdmission(LeagueFolder folder, WorkerPauses pauses, Consumer<String> teller) {
        this.folder = folder;
        this.pauses = pauses;
        this.teller = teller;
        stamp = WorkerList.stamp(folder);
        list = WorkerList.read(folder);
    }

    /** True if the worker may play; one that has just been added is found in the file. */
    @Override
    public boolean admits(String worker, String secret) {
        return list.admits(worker, secret) || admitsAnew(worker, secret);
    }

    /** Looks into the file; of several threads that come at once, the first one reads it for all. */
    private synchronized boolean admitsAnew(String worker, String secret) {
        if (list.admits(worker, secret)) {
            return true;
        }
        String now = WorkerList.stamp(folder);
        if (now.equals(missed)) {
            return false;
        }
        missed = now;
        try {
            list = WorkerList.read(folder);
        } catch (InputException problem) {
            return false;                              // said by the thread that looks for changes
        }
        return list.admits(worker, secret);
    }

    @Override
    public String enrol(String worker, String secret, String invitation) {
        try {
            String refusal = WorkerList.enrol(folder, worker, secret, invitation, Instant.now());
            if (refusal == null) {
                list = WorkerList.read(folder);
                teller.accept("worker " + worker + " has come with the invitation "
                    + list.of(worker).map(WorkerList.Worker::invited).orElse(""));
            }
            return refusal;
        } catch (InputException problem) {
            teller.accept(problem.getMessage());
            return "the league cannot change its list of workers";
        }
    }

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

    List<WorkerList.Worker> workers() {
        return list.workers();
    }

    /** Reads the list if its file has changed. @return false if it has not, or cannot be read */
    boolean isChanged() {
        String now = WorkerList.stamp(folder);
        if (now.equals(stamp)) {
            return false;
        }
        stamp = now;
        try {
            list = WorkerList.read(folder);
            return true;
        } catch (InputException problem) {
            teller.accept(problem.getMessage() + "; the workers stay as they were");
            return false;
        }
    }

    /** Revokes a worker that was caught; its games are to be set aside. */
    void revoke(String worker, String why) {
        change(() -> WorkerList.revoke(folder, worker, why, true));
    }

    /** Keeps a doubt about the answers of a worker. @return whether it is suspended by that */
    boolean doubt(String worker, String why) {
        boolean[] kept = new boolean[1];
        change(() -> kept[0] = WorkerList.doubt(folder, worker, why));
        return kept[0];
    }

    private void change(Runnable how) {
        boolean interrupted = Thread.interrupted();    // which would keep the list from being written
        try {
            how.run();
        } catch (InputException gone) {
            teller.accept(gone.getMessage());
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
        list = WorkerList.read(folder);
    }
}
