package steward.league.page;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import steward.text.TextFormat;

/**
 * Row of the workers' table: a machine that plays games of a league, in readable form.
 *
 * @param state    such as {@code away}, {@code caught} or {@code suspended}; empty where the league is not being played
 * @param games    that count
 * @param aside    that were set aside or are suspended
 * @param rate     games a second in this run, or NaN
 * @param faults   of bots in its games
 * @param repeated games that were played again because the machine was starved
 * @param version  of its program, or {@code null}
 * @param silentMs since its last word, or -1
 * @param doubts   what is doubtful, a sentence each
 */
public record WorkerRow(String name, String state, long games, long aside, double rate, long faults, long repeated,
                        String version, long silentMs, List<String> doubts) {

    /** State of a worker whose games do not count until somebody decides. */
    public static final String SUSPENDED = "suspended";

    public WorkerRow {
        doubts = List.copyOf(doubts);
    }

    /** A line for the worker, and one for each doubt. */
    public List<String> lines() {
        StringBuilder line = new StringBuilder("worker " + name + ": " + (state.isEmpty() ? "" : state + ", ")
            + TextFormat.count(games, "game"));
        if (aside > 0) {
            line.append(", ").append(aside).append(" more set aside");
        }
        if (!Double.isNaN(rate)) {
            line.append(String.format(Locale.ROOT, ", %.2f games/s", rate));
        }
        line.append(", ").append(TextFormat.count(faults, "fault")).append(", ")
            .append(TextFormat.count(repeated, "hiccup"));
        if (version != null) {
            line.append(", steward ").append(version);
        }
        if (silentMs >= 0) {
            line.append(", last word ").append(TimeUnit.MILLISECONDS.toSeconds(silentMs)).append(" s ago");
        }
        List<String> lines = new ArrayList<>(List.of(TextFormat.plain(line.toString())));
        doubts.forEach(doubt -> lines.add(TextFormat.plain("  doubtful: " + doubt)));
        return lines;
    }
}
