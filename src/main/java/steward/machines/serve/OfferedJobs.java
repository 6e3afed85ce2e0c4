package steward.machines.serve;

import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import steward.machines.broker.LeagueBroker;
import steward.machines.wire.GameJob;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;

/** Jobs that are offered to workers, until their results arrive or they are given to others. Thread-safe. */
final class OfferedJobs {

    /** Characters of a header that the bots of a job may take, as they may be written. */
    private static final int BOTS_SIZE = WireMessage.LONGEST_HEADER / 2;
    /** How often it is looked whether a job has to go to others, in milliseconds. */
    private static final long LOOK_MS = 1000;
    /** Time for which it counts that somebody had nothing else to play, in nanoseconds. */
    private static final long HURRY_NANOS = TimeUnit.SECONDS.toNanos(2);
    /** How long an offered job waits for a worker when none is connected, in nanoseconds. */
    private static final long ALONE_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final LeagueBroker broker;
    private final BooleanSupplier anyConnected;
    private final Predicate<Collection<String>> canPlay;
    private final BiConsumer<String, String> ended;
    private final Consumer<String> lost;
    private final SecureRandom random = new SecureRandom();
    /** Jobs that others play while the worker may still finish them, and until when, as {@link System#nanoTime}. */
    private final Map<String, Long> recalled = new ConcurrentHashMap<>();
    /** Last time that somebody had nothing else to play, or one that does not count any more. */
    private volatile long hurried = System.nanoTime() - HURRY_NANOS;
    private final Map<String, Offer> offers = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /** Guarded by this. */

    /** Time for which a worker may keep a job. */
    interface Patience {
        /** Returns it in nanoseconds, by what is known now. @param hurry true if others have nothing to play */
        long nanos(boolean hurry);
    }

    /** A job, the bundles that it needs, and what comes of it: {@code null} if somebody else has to play it. */
    private record Offer(Set<String> needs, int games, CompletableFuture<Told> told) { }

    /**
     * A worker's report on the games of a job that it has begun.
     *
     * @param nanos for which it has had the job
     */
    record Told(String worker, List<WorkerWord.Played> games, long nanos) { }

    /**
     * None are offered yet.
     *
     * @param anyConnected whether a worker plays
     * @param canPlay      whether one that plays has these bundles, or may have them
     * @param ended        is told which worker has kept a job for too long, and what to say of it
     * @param lost         is told which worker had a job whose games have gone to others
     */
    OfferedJobs(LeagueBroker broker, BooleanSupplier anyConnected, Predicate<Collection<String>> canPlay,
                BiConsumer<String, String> ended, Consumer<String> lost) {
        this.broker = broker;
        this.anyConnected = anyConnected;
        this.canPlay = canPlay;
        this.ended = ended;
        this.lost = lost;
    }

    /** Returns how many games nobody has taken yet. */
    int waiting() {
        return offers.entrySet().stream().filter(each -> broker.holder(each.getKey()) == null)
            .mapToInt(each -> each.getValue().games()).sum();
    }

    /**
     * Offers games, as many as fit into a message.
     *
     * @param patience after which they are taken away from a worker
     * @return {@code null} if somebody else has to play them
     */
    Told play(List<GameJob.Game> wanted, Patience patience) throws InterruptedException {
        byte[] id = new byte[16];
        random.nextBytes(id);
        String job = HexFormat.of().formatHex(id);
        Set<GameJob.Seat> bots = new HashSet<>();
        List<GameJob.Game> asked = new ArrayList<>();
        int size = 0;
        while (asked.size() < wanted.size() && (asked.isEmpty() || size < BOTS_SIZE)) {
            GameJob.Game game = wanted.get(asked.size());
            size += game.seats().stream().filter(bots::add).mapToInt(OfferedJobs::size).sum();
            asked.add(game);
        }
        Offer offer = new Offer(bots.stream().map(GameJob.Seat::bundle).collect(Collectors.toSet()),
            asked.size(), new CompletableFuture<>());
        offers.put(job, offer);
        try {
            broker.offer(job, offer.needs(), new GameJob(job, asked).bytes());
            Told told = await(job, offer, patience);
            if (told == null) {
                String holder = broker.holder(job);
                broker.withdraw(job);
                if (holder != null && !recalled.containsKey(job)) {
                    lost.accept(holder);
                }
                return null;
            }
            return told.games().size() <= asked.size() ? told
                : new Told(told.worker(), told.games().subList(0, asked.size()), told.nanos());
        } finally {
            offers.remove(job);
            if (!recalled.containsKey(job)) {
                broker.forget(job);
            }
        }
    }

    /** Notes that somebody has nothing to play before jobs end. */
    void hurry() {
        hurried = System.nanoTime();
    }

    /** Complains of recalled jobs that were not finished in time either. A worker has no others meanwhile. */
    void lookAfterRecalled() {
        recalled.forEach((job, until) -> {
            String holder = broker.holder(job);
            if (holder == null) {
                broker.withdraw(job);                  // its worker has gone
            } else if (System.nanoTime() - until < 0) {
                return;
            } else {
                complain(job);
            }
            recalled.remove(job);
            broker.forget(job);
        });
    }

    private void complain(String job) {
        ended.accept(broker.holder(job), "it has not finished its games within "
            + TimeUnit.NANOSECONDS.toSeconds(broker.heldNanos(job)) + " s, and they go to others");
    }

    /** Returns how many characters a bot takes in a header, at most. */
    private static int size(GameJob.Seat bot) {
        return 6 * bot.name().length() + 200;
    }

    private Told await(String job, Offer offer, Patience patience) throws InterruptedException {
        long alone = 0;
        while (!closed) {
            try {
                return offer.told().get(LOOK_MS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException none) {
                alone = anyConnected.getAsBoolean() ? 0 : alone == 0 ? System.nanoTime() : alone;
                if (alone != 0 && System.nanoTime() - alone > ALONE_NANOS) {
                    return null;
                }
                if (!canPlay.test(offer.needs())) {
                    return null;
                }
                long held = broker.heldNanos(job);
                long most = patience.nanos(false);
                if (held > most) {
                    complain(job);
                    return null;
                }
                if (held > patience.nanos(true) && System.nanoTime() - hurried < HURRY_NANOS) {
                    recalled.put(job, System.nanoTime() + most - held);
                    return null;
                }
            } catch (ExecutionException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
        return null;
    }

    /** Takes a worker's result of a job; of no consequence if it is not the worker's, or not any more. */
    void told(String worker, WorkerWord.Result result) {
        Offer offer = offers.get(result.job());
        if (!worker.equals(broker.holder(result.job()))) {
            return;
        }
        if (offer == null) {
            recalled.remove(result.job());             // too late, and no reason to complain
            broker.forget(result.job());
            lost.accept(worker);
            return;
        }
        offer.told().complete(new Told(worker, result.games(), broker.heldNanos(result.job())));
    }

    /** Some bots turn out not to run at a worker: what nobody can play goes to the league itself. */
    void lookWhoCanPlay() {
        offers.values().stream().filter(offer -> !canPlay.test(offer.needs())).forEach(offer ->
            offer.told().complete(null));
    }

    /** Waits for none of them any more. */
    void close() {
        closed = true;
        offers.values().forEach(offer -> offer.told().complete(null));
    }
}
