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
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import steward.machines.broker.LeagueBroker;
import steward.machines.wire.GameJob;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;

/** Jobs that are offered to workers, and what comes of them. Thread-safe. */
final class OfferedJobs {

    /** Characters of a header that the bots of a job may take, as they may be written. */
    private static final int BOTS_SIZE = WireMessage.LONGEST_HEADER / 2;
    /** How often it is looked whether a job has to go to others, in milliseconds. */
    private static final long LOOK_MS = 1000;
    /** How long an offered job waits for a worker when none is connected, in nanoseconds. */
    private static final long ALONE_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final LeagueBroker broker;
    private final BooleanSupplier anyConnected;
    private final Predicate<Collection<String>> canPlay;
    private final BiConsumer<String, String> ended;
    private final SecureRandom random = new SecureRandom();
    private final Map<String, Offer> offers = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /** Guarded by this. */
    private long jobs;
    private long games;

    /** A job, the bundles that it needs, and what comes of it: {@code null} if somebody else has to play it. */
    private record Offer(Set<String> needs, CompletableFuture<Told> told) {
    }

    /**
     * A worker's report on the games of a job that it has begun.
     *
     * @param nanos for which it has had the job
     */
    record Told(String worker, List<WorkerWord.Played> games, long nanos) {
    }

    /**
     * None are offered yet.
     *
     * @param anyConnected whether a worker plays
     * @param canPlay      whether one that plays has these bundles, or may have them
     * @param ended        is told which worker has kept a job for too long, and what to say of it
     */
    OfferedJobs(LeagueBroker broker, BooleanSupplier anyConnected, Predicate<Collection<String>> canPlay,
                BiConsumer<String, String> ended) {
        this.broker = broker;
        this.anyConnected = anyConnected;
        this.canPlay = canPlay;
        this.ended = ended;
    }

    /** Returns how many have gone together, on average; 1 if none have. */
    synchronized double perJob() {
        return jobs == 0 ? 1 : (double) games / jobs;
    }

    /**
     * Offers games, as many as fit into a message.
     *
     * @param lease after how many nanoseconds they are taken away from a worker, as of now: what is known grows
     * @return {@code null} if somebody else has to play them
     */
    Told play(List<GameJob.Game> wanted, LongSupplier lease) throws InterruptedException {
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
        synchronized (this) {
            jobs++;
            games += asked.size();
        }
        Offer offer = new Offer(bots.stream().map(GameJob.Seat::bundle).collect(Collectors.toSet()),
            new CompletableFuture<>());
        offers.put(job, offer);
        try {
            broker.offer(job, offer.needs(), new GameJob(job, asked).bytes());
            Told told = await(job, offer, lease);
            if (told == null) {
                broker.withdraw(job);
                return null;
            }
            return told.games().size() <= asked.size() ? told
                : new Told(told.worker(), told.games().subList(0, asked.size()), told.nanos());
        } finally {
            offers.remove(job);
            broker.forget(job);
        }
    }

    /** Returns how many characters a bot takes in a header, at most. */
    private static int size(GameJob.Seat bot) {
        return 6 * bot.name().length() + 200;
    }

    private Told await(String job, Offer offer, LongSupplier lease) throws InterruptedException {
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
                if (broker.heldNanos(job) > lease.getAsLong()) {
                    ended.accept(broker.holder(job), "it has not finished its games within "
                        + TimeUnit.NANOSECONDS.toSeconds(broker.heldNanos(job)) + " s, and they go to others");
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
        if (offer == null || !worker.equals(broker.holder(result.job()))) {
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
