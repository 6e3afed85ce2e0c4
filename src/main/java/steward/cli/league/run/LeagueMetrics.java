package steward.cli.league.run;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import steward.league.page.WorkerRow;
import steward.league.play.LeagueRun;

/** Metrics of a run in the text format of Prometheus, at {@code /metrics} of the watched port. */
final class LeagueMetrics {

    /**
     * Returns the figures.
     *
     * @param rate     games a second
     * @param machines that play, too, or {@code null}
     */
    static String text(LeagueRun run, double rate, Serving.Service machines) {
        StringBuilder text = new StringBuilder();
        add(text, "games_total", "counter", "Games of the schedule that are over.", run.games());
        add(text, "stored_total", "counter", "Attempts stored in this run.", run.stored());
        add(text, "games_per_second", "gauge", "Rate of this run.", rate);
        add(text, "games_under_way", "gauge", "Games that have been given out and are not over.", run.underWay());
        add(text, "queue_games", "gauge", "Games that wait for a worker.", machines == null ? 0 : machines.waiting());
        add(text, "lag_decisions", "gauge", "Decisions since the first one with a game that is not over.", run.ahead());
        add(text, "lag_limit_decisions", "gauge", "Lag at which the schedule waits, \"lag\" of league.json.",
            run.roster().settings().lag());
        workers(text, machines == null ? List.of() : machines.workers());
        return text.toString();
    }

    static void workers(StringBuilder text, List<WorkerRow> workers) {
        add(text, "workers", "gauge", "Workers that have joined and are there.", workers.stream()
            .filter(worker -> worker.state().endsWith(" at a time")).count());
        add(text, "worker_games", "Games of a worker that count.", workers, WorkerRow::games);
        add(text, "worker_set_aside", "Games of a worker that were set aside.", workers, WorkerRow::aside);
        add(text, "worker_faults", "Faults of bots in games of a worker.", workers, WorkerRow::faults);
        add(text, "worker_hiccups", "Games of a worker that were played again.", workers, WorkerRow::repeated);
        add(text, "worker_suspicions", "Sentences of doubt about a worker.", workers, worker -> worker.doubts().size());
        add(text, "worker_silent_seconds", "Time since the last word of a worker.", workers,
            worker -> worker.silentMs() / 1e3);
    }

    private static void add(StringBuilder text, String name, String type, String help, double value) {
        head(text, name, type, help);
        text.append("steward_").append(name).append(' ').append(number(value)).append('\n');
    }

    private static void add(StringBuilder text, String name, String help, List<WorkerRow> workers,
                            ToDoubleFunction<WorkerRow> value) {
        head(text, name, "gauge", help);
        workers.forEach(worker -> text.append("steward_").append(name).append("{worker=\"").append(worker.name())
            .append("\"} ").append(number(value.applyAsDouble(worker))).append('\n'));
    }

    private static void head(StringBuilder text, String name, String type, String help) {
        text.append("# HELP steward_").append(name).append(' ').append(help).append("\n# TYPE steward_").append(name)
            .append(' ').append(type).append('\n');
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : String.format(Locale.ROOT, "%.3f", value);
    }
}
