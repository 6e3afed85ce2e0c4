package steward.machines.broker;

/** Decides which workers are handed jobs. Called by the broker's threads, which must not wait. */
public interface Gate {

    /** A gate that is open for all. */
    Gate OPEN = new Gate() {
        @Override
        public boolean mayTake(String worker, int jobs) {
            return true;
        }

        @Override
        public void took(String worker) {
            return;
        }
    };

    /** True if a worker that has so many jobs may be handed another. */
    boolean mayTake(String worker, int jobs);

    /** Notes that a worker has been handed a job. */
    void took(String worker);
}
