package steward.bot.accounting;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Handle of a thread of this JVM, through which others ask the kernel whether it sleeps in a call or wants to run. */
public final class OwnThread {

    /** State of a thread, as the kernel tells it. */
    public enum State {
        /** It waits for something that has not happened. */
        ASLEEP,
        /** It runs, or would if a processor were free. */
        AWAKE,
        /** The system does not say. */
        UNKNOWN
    }

    private static final Path SELF = Path.of("/proc/thread-self");

    private Thread thread;
    private volatile String file;

    /** Called by the thread itself; free of cost if it was the last to call this. */
    public void enter() {
        Thread now = Thread.currentThread();
        if (now != thread) {
            thread = now;
            file = find();
        }
    }

    private static String find() {
        try {
            return "/proc/" + Files.readSymbolicLink(SELF) + "/stat";
        } catch (IOException none) {
            return null;
        }
    }

    /** The state of the thread that last called {@link #enter}. */
    public State state() {
        String path = file;
        ProcFile stat = new ProcFile();
        if (path == null || !stat.read(path) || !stat.skipName()) {
            return State.UNKNOWN;
        }
        return stat.nextCharacter() == 'S' ? State.ASLEEP : State.AWAKE;
    }
}
