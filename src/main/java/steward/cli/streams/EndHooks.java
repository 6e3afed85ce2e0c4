package steward.cli.streams;

/** Hooks that run when a command is ended from outside, with its process or by its client. */
public interface EndHooks {

    /** Hooks of this process. */
    EndHooks OF_PROCESS = new EndHooks() {
        @Override
        public void add(Thread hook) {
            Runtime.getRuntime().addShutdownHook(hook);
        }

        @Override
        public void remove(Thread hook) {
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException shutdown) {
                // The hook is already running or has run.
                return;
            }
        }
    };

    /** @param hook not started yet */
    void add(Thread hook);

    /** Removes a hook; if it is running or has run, nothing happens. */
    void remove(Thread hook);
}
