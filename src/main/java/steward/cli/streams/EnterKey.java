package steward.cli.streams;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;

/** Wait for the Enter key at the terminal. */
public final class EnterKey {

    private EnterKey() { }

    /** Completes with the next end of a line, or at the end of the input. A thread waits for it, perhaps for ever. */
    public static CompletableFuture<Void> pressed(Streams streams) {
        CompletableFuture<Void> pressed = new CompletableFuture<>();
        Thread reader = new Thread(() -> {
            try {
                int read;
                do {
                    read = streams.in().read();
                } while (read >= 0 && read != '\n');
                pressed.complete(null);
            } catch (IOException unreadable) {
                pressed.complete(null);
            }
        }, "enter");
        reader.setDaemon(true);
        reader.start();
        return pressed;
    }
}
