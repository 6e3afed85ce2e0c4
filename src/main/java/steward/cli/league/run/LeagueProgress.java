package steward.cli.league.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import steward.cli.league.view.LeagueOpening;
import steward.cli.league.view.ReferenceOptions;
import steward.cli.league.view.TableText;
import steward.cli.streams.Colour;
import steward.league.LeagueSettings;
import steward.league.StoredGame;
import steward.league.play.LeagueRun;
import steward.league.rating.LeagueTable;
import steward.league.rating.Results;
import steward.league.store.GameStore;
import steward.text.TextFormat;

/** Counters of a run, updated as games end. Thread-safe. */
final class LeagueProgress {

    private static final int MOST_ROWS = 20;
    private static final double NANOS = 1e9;

    private final GameStore store;
    private final LeagueRun.Limits limits;
    private final Map<Integer, Boolean> random = new HashMap<>();
    private Results results;
    private LeagueTable.Reference reference = LeagueTable.Reference.NONE;
    /** How all games are read, once some have been set aside. */
    private Supplier<Results> anew;
    private long began = System.nanoTime();
    private long played;
    /** Games of this run, where a plan says how many, or -1. */
    private long planned = -1;

    LeagueProgress(GameStore store, LeagueRun.Limits limits) {
        this.store = store;
        this.limits = limits;
    }

    /** Begins, with what was played before. */
    synchronized void goOn(Results before) {
        results = before;
        began = System.nanoTime();
    }

    /** Ratings and differences are told against these bots from now on. */
    synchronized void tellAgainst(ReferenceOptions options, LeagueSettings settings) {
        reference = options.reference(results, LeagueOpening.entries(settings, store.versions()));
    }

    /** A plan has so many games that are to be played. */
    synchronized void planned(long games) {
        planned = games;
    }

    /** Number of planned games, in words. */
    synchronized String planned() {
        return planned == 0 ? "no game is to be played" : TextFormat.count(planned, "game")
            + (planned == 1 ? " is to be played" : " are to be played");
    }

    /** A game has ended. */
    synchronized void add(StoredGame game) {
        results.add(game, version -> random.computeIfAbsent(version, id -> store.versions().stream()
            .anyMatch(each -> each.id() == id && each.random())));
        played += game.counts() ? 1 : 0;
    }

    /**
     * Games that counted do no more: all are read anew. One that ends just then may be missing, or twice, until {@link
     * #settle}.
     */
    synchronized void replace(Supplier<Results> stored) {
        anew = stored;
        results = stored.get();
    }

    /** The run is over and all of its games are stored. */
    synchronized void settle() {
        if (anew != null) {
            results = anew.get();
        }
    }

    /** Games of this run. */
    synchronized long played() {
        return played;
    }

    /** The table as it stands. */
    synchronized LeagueTable table(LeagueSettings settings) {
        return LeagueTable.of(results, LeagueOpening.entries(settings, store.versions()), reference);
    }

    /** In a second, in this run. */
    synchronized double rate() {
        return played * NANOS / Math.max(1, System.nanoTime() - began);
    }

    /**
     * The lines of a terminal.
     *
     * @param machines that play, too, or {@code null}
     */
    List<String> lines(LeagueRun run, Serving.Service machines, Supplier<Colour> colour) {
        LeagueTable table = table(run.roster().settings());
        List<String> rows = TableText.rows(table, colour.get());
        List<String> lines = new ArrayList<>(rows.subList(0, Math.min(rows.size(), 1 + MOST_ROWS)));
        if (rows.size() > 1 + MOST_ROWS) {
            lines.add("    and " + (rows.size() - 1 - MOST_ROWS) + " more");
        }
        if (machines != null) {
            machines.workers().forEach(worker -> lines.addAll(worker.lines()));
        }
        lines.add(standing(run));
        return lines;
    }

    /** Games, games a second, time left. */
    String standing(LeagueRun run) {
        double rate = rate();
        long done = planned < 0 ? run.games() : played();
        long most = planned < 0 ? limits.games() : planned;
        StringBuilder line = new StringBuilder(TextFormat.count(done, "game"));
        if (most != Long.MAX_VALUE) {
            line.append(" of ").append(most);
        }
        line.append(", ").append(TextFormat.number(rate, rate < 10 ? 2 : 0)).append(" games/s");
        double left = Double.POSITIVE_INFINITY;
        if (limits.nanos() != Long.MAX_VALUE) {
            left = (limits.nanos() - (System.nanoTime() - began)) / NANOS;
        }
        if (most != Long.MAX_VALUE && rate > 0) {
            left = Math.min(left, (most - done) / rate);
        }
        return line + (left < TimeUnit.DAYS.toSeconds(365) ? ", " + TextFormat.about(Math.max(0, left)) + " left" : "")
            + "; Ctrl-C ends it";
    }
}
