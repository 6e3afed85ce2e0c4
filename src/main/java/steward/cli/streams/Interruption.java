package steward.cli.streams;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;

/**
 * Message that tells where the replay is when a match ends by Ctrl-C. Nothing else is needed then: each turn was
 * written when it was played, and no bot outlives this process.
 */
public final class Interruption implements AutoCloseable {

    private final EndHooks hooks;
    private final Thread hook;
    private final AtomicBoolean over = new AtomicBoolean();

    /** @param kept says where the results so far are, or {@code null} to print nothing */
    public Interruption(Streams streams, String kept) {
        this(streams, kept == null ? null : () -> kept);
    }

    /**
     * @param kept is called at the interruption, on another thread; gives {@code null} to print nothing. It must not
     *             wait for who closes this
     */
    public Interruption(Streams streams, Supplier<String> kept) {
        hooks = streams.hooks();
        hook = kept == null ? null : new Thread(() -> {
            String told = over.getAndSet(true) ? null : kept.get();
            if (told != null) {
                streams.err().println("steward: interrupted; " + told);
            }
        }, "interruption");
        if (hook != null) {
            hooks.add(hook);
        }
    }

    /** The match has its result. @return false if it was interrupted before: then this process is about to end */
    public boolean over() {
        return !over.getAndSet(true);
    }

    /** Waits if it has begun to say where the results are: it needs what is closed after this. */
    @Override
    public void close() {
        over();
        if (hook == null) {
            return;
        }
        hooks.remove(hook);
        boolean interrupted = false;
        while (hook.isAlive()) {
            try {
                hook.join();
            } catch (InterruptedException again) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
