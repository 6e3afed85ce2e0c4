package steward.lab.timing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;

/*
 * The kinds take turns in each round, every other round in the opposite order, so that a slow period of the machine
 * affects all of them. Places in this JVM are warmed up one after the other, JVMs as many at once as there are
 * processors. Rounds are measured by the calling thread, one at a time, while all other JVMs wait for a word.
 */

/**
 * Timing of several kinds of work against each other, each in a place of its own.
 *
 * @param <J> what a place needs to know
 */
public final class Timing<J> {

    private final TimingEffort effort;
    private final Function<J, TimedPlace> start;
    private final int atOnce;

    /** @param start makes the place where a job is timed, in this JVM */
    public Timing(TimingEffort effort, Function<J, TimedPlace> start) {
        this(effort, start, 1);
    }

    Timing(TimingEffort effort, Function<J, TimedPlace> start, int atOnce) {
        this.effort = effort;
        this.start = start;
        this.atOnce = atOnce;
    }

    /** In a JVM for each job, whose main class serves as {@link TimingChild}. */
    public static Timing<RungJob> inJvms(TimingEffort effort, Class<?> main) {
        return new Timing<>(effort, job -> new TimingJvm(main, job), Runtime.getRuntime().availableProcessors());
    }

    /** Returns how many steps of progress {@link #run} makes with so many jobs. */
    public int steps(int jobs) {
        return effort.steps(jobs);
    }

    /**
     * Times all jobs.
     *
     * @param step called after each warm-up, by another thread, and after each round
     * @throws IllegalStateException if a place cannot be made or fails, or this thread is interrupted
     */
    public TimingSamples run(List<J> jobs, Runnable step) {
        try {
            return run(jobs, step, whole -> { });
        } catch (RuntimeException problem) {
            throw problem;
        } catch (InterruptedException interruption) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while timing", interruption);
        } catch (Exception problem) {
            throw new IllegalStateException(problem.getMessage(), problem);
        }
    }

    /**
     * Times all jobs.
     *
     * @param interrupted receives the whole rounds, if there are any, when this thread is interrupted
     * @throws Exception what a place threw, or of the interruption
     */
    public TimingSamples run(List<J> jobs, Runnable step, Consumer<TimingSamples> interrupted) throws Exception {
        TimingSamples samples = new TimingSamples();
        for (int repeat = 0; repeat < effort.repeats(); repeat++) {
            TimedPlace[] places = new TimedPlace[jobs.size()];
            samples.begin();
            try {
                open(jobs, places, step);
                for (int round = 0; round < effort.rounds(); round++) {
                    Stretch[] stretches = new Stretch[places.length];
                    for (int k = 0; k < places.length; k++) {
                        int job = round % 2 == 0 ? k : places.length - 1 - k;
                        stretches[job] = places[job].round(effort.round());
                    }
                    samples.add(stretches);
                    step.run();
                }
            } catch (Exception problem) {              // an interrupt appears as the failure of a write or a match
                if ((Thread.interrupted() || problem instanceof InterruptedException) && samples.rounds() > 0) {
                    interrupted.accept(samples);
                }
                throw problem;
            } finally {
                Arrays.stream(places).filter(place -> place != null).forEach(TimedPlace::close);
            }
        }
        return samples;
    }

    private void open(List<J> jobs, TimedPlace[] places, Runnable step) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(atOnce, task -> {
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
                    return null;
                }));
            }
            for (Future<?> each : all) {
                each.get();
            }
        } catch (ExecutionException problem) {
            throw problem.getCause() instanceof Exception cause ? cause : problem;
        } finally {
            threads.shutdownNow();
            threads.awaitTermination(1, TimeUnit.MINUTES);         // a place that is just being made is closed too
        }
    }
}
