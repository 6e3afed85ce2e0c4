import java.util.Scanner;
import java.util.Timer;
import java.util.TimerTask;
import java.util.stream.IntStream;

/** Answers each number by what several threads compute; a timer goes all the time, and the collector works. */
public final class Threads {

    private static volatile int ticks;

    private Threads() {
    }

    private static long work(long seed) {
        long value = seed;
        for (int k = 0; k < 100_000; k++) {
            value = (value * 1_103_515_245 + 12_345) % (1L << 31);
        }
        return value;
    }

    /** Reads numbers, answers numbers. */
    public static void main(String[] none) {
        new Timer(true).schedule(new TimerTask() {
            @Override
            public void run() {
                ticks++;
            }
        }, 3, 3);
        Scanner lines = new Scanner(System.in);
        while (lines.hasNextLine()) {
            long seed = Long.parseLong(lines.nextLine());
            long sum = IntStream.range(0, 4).parallel().mapToLong(k -> work(seed + k)).sum();
            byte[][] garbage = new byte[200][];
            for (int k = 0; k < garbage.length; k++) {
                garbage[k] = new byte[10_000];
            }
            System.out.println(sum + garbage.length);
        }
    }
}
