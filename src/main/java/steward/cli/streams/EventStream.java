package steward.cli.streams;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.function.Supplier;

/** Stream of a program's log: each line with its time, as text or as a JSON object. Thread-safe. */
final class EventStream extends OutputStream {

    private static final String PROGRAM = "steward: ";

    private final PrintStream log;
    private final boolean json;
    private final Supplier<Instant> clock;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();

    /** @param json true for objects with the fields {@code time} and {@code event} */
    EventStream(PrintStream log, boolean json, Supplier<Instant> clock) {
        this.log = log;
        this.json = json;
        this.clock = clock;
    }

    @Override
    public synchronized void write(int each) {
        if (each == '\n') {
            String text = line.toString(StandardCharsets.UTF_8);
            line.reset();
            print(text.startsWith(PROGRAM) ? text.substring(PROGRAM.length()) : text);
        } else {
            line.write(each);
        }
    }

    private void print(String event) {
        Instant now = clock.get().truncatedTo(ChronoUnit.MILLIS);
        if (event.isBlank()) {
            return;
        }
        if (json) {
            Json.print(log, out -> {
                out.writeStringProperty("time", now.toString());
                out.writeStringProperty("event", event);
            });
        } else {
            log.println(PROGRAM + now + " " + event);
        }
    }
}
