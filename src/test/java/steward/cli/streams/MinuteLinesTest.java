package steward.cli.streams;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** A run without a terminal tells once a minute how far it is. */
class MinuteLinesTest {

    private final ByteArrayOutputStream said = new ByteArrayOutputStream();
    private long seconds;

    private MinuteLines lines() {
        return new MinuteLines(new PrintStream(said, true, StandardCharsets.UTF_8),
            () -> TimeUnit.SECONDS.toNanos(seconds));
    }

    @Test
    void aStepInEachMinuteIsTold() {
        try (ProgressLine progress = new ProgressLine(lines(), "games", 100)) {
            for (int game = 1; game <= 40; game++) {
                seconds += 5;
                progress.step("mine 0.500");
            }
        }
        assertEquals("""
            games: 12 of 100, about 7 minutes left
            games: 24 of 100, about 6 minutes left
            games: 36 of 100, about 5 minutes left
            """, said.toString(StandardCharsets.UTF_8));
    }

    /** The standing takes time to find: it is asked for each line, not for each step. */
    @Test
    void theStandingIsAskedWhereALineIsPrinted() {
        int[] asked = new int[1];
        ProgressLine progress = new ProgressLine(lines(), "turns", 100);
        for (int turn = 1; turn <= 60; turn++) {
            seconds += 2;
            progress.step(() -> "asked " + ++asked[0]);
        }
        assertEquals("""
            turns: 30 of 100, about 2 minutes left, asked 1
            turns: 60 of 100, about 1 minute left, asked 2
            """, said.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aShortRunSaysNothing() {
        ProgressLine progress = new ProgressLine(lines(), "turns", 3);
        seconds = 59;
        progress.step();
        progress.close();
        assertEquals("", said.toString(StandardCharsets.UTF_8));
    }
}
