import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;

class Bot {
    static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    static volatile Object sink;

    static void burn(long ms, LongSupplier clock, Runnable step) {
        for (long end = clock.getAsLong() + ms * 1_000_000; clock.getAsLong() < end;) {
            step.run();
        }
    }

    static void compute() {
        double sum = 0;
        for (int k = 1; k < 2000; k++) {
            sum += 1.0 / k;
        }
        sink = sum;
    }

    static void turn(String kind, boolean first) throws Exception {
        LongSupplier own = THREADS::getCurrentThreadCpuTime;
        switch (kind) {
            case "clock" -> burn(45, System::nanoTime, Bot::compute);
            case "work" -> burn(45, own, Bot::compute);
            case "sleep" -> Thread.sleep(45);
            case "read" -> sink = Files.readString(Path.of("big.txt")).split("7").length;
            case "threads" -> {
                List<Thread> all = new ArrayList<>();
                for (int k = 0; k < 4; k++) {
                    all.add(new Thread(() -> burn(10, own, Bot::compute)));
                    all.get(k).start();
                }
                for (Thread each : all) {
                    each.join();
                }
            }
            case "garbage" -> burn(30, own, () -> sink = new int[20_000]);
            default -> {
                if (first) {
                    Thread.sleep(300);
                    burn(200, own, Bot::compute);
                }
            }
        }
    }

    public static void main(String[] words) throws Exception {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        boolean first = true;
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            if (line.startsWith("{\"type\":\"turn\"")) {
                turn(words[0], first);
                first = false;
                System.out.println("{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}");
            }
        }
    }
}
