package steward.lab.timing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/*
 * The kinds take turns in each round, every other round in the opposite order, so that a slow period of the machine
 * affects all of them. Starting and warming up is done for as many at once as there are processors; rounds are measured
 * one at a time, while all the other JVMs wait for a word.
 */

/** Times some kinds of turns against each other, each in a place of its own. */
public final class Timing {

    private final TimingEffort effort;
    private final Function<byte[], TimedPlace> start;

    /** @param start makes the place where a job is timed */
    public Timing(TimingEffort effort, Function<byte[], TimedPlace> start) {
        this.effort = effort;
        this.start = start;
    }

    /** In a JVM for each job, whose main class serves as {@link TimingChild}. */
    public static Timing inJvms(TimingEffort effort, Class<?> main) {
        return new Timing(effort, job -> new TimingJvm(main, job));
    }

    /** Returns how many steps of progress {@link #run} makes with so many jobs. */
    public int steps(int jobs) {
        return effort.repeats() * (jobs + effort.rounds());
    }

    /**
     * Times all jobs.
     *
     * @param step called after each step, by any thread
     * @throws IllegalStateException if a place cannot be made or fails
     */
    public TimingSamples run(List<byte[]> jobs, Runnable step) {
        TimingSamples samples = new TimingSamples(jobs.size(), effort.repeats(), effort.rounds());
        for (int repeat = 0; repeat < effort.repeats(); repeat++) {
            TimedPlace[] places = new TimedPlace[jobs.size()];
            try {
                open(jobs, places, samples, step);
                for (int round = 0; round < effort.rounds(); round++) {
                    for (int k = 0; k < places.length; k++) {
                        int job = round % 2 == 0 ? k : places.length - 1 - k;
                        samples.add(job, repeat, round, places[job].round(effort.round()));
                    }
                    step.run();
                }
            } finally {
                Arrays.stream(places).filter(place -> place != null).forEach(TimedPlace::close);
            }
        }
        return samples;
    }

    private void open(List<byte[]> jobs, TimedPlace[] places, TimingSamples samples, Runnable step) {
        ExecutorService threads = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors(), task -> {
            Thread thread = new Thread(task, "timing");
            thread.setDaemon(true);
            return thread;
        });
        try {
            List<Future<?>> all = new ArrayList<>();
            for (int k = 0; k < places.length; k++) {
                int job = k;
                all.add(threads.submit(() -> {
                    places[job] = start.apply(jobs.get(job));
                    places[job].warmUp(effort.warmLeast(), effort.warmMost());
                    step.run();
                }));
            }
            for (Future<?> each : all) {
                each.get();
            }
        } catch (ExecutionException problem) {
            throw new IllegalStateException(problem.getCause().getMessage(), problem.getCause());
        } catch (InterruptedException interruption) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while timing", interruption);
        } finally {
            threads.shutdownNow();
            awaitEnd(threads);
        }
    }

    /** A place that is just being made is closed with the others. */
    private static void awaitEnd(ExecutorService threads) {
        try {
            threads.awaitTermination(1, TimeUnit.MINUTES);
        } catch (InterruptedException interruption) {
            Thread.currentThread().interrupt();
        }
    }
}
