package steward.lab.bench.section;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;

/**
 * Bench section on tools of others: the CPU time of their games with our referee, beside the same tool with a referee
 * in Go. Referees take turns within each round, so the ratio is the median of pairs of runs.
 */
record ToolSection(MatchFixture fixture, Path tools) implements Section {

    private static final double NANOS = 1e9;
    /** Games of a run; cg-brutaltester plays each seed from both sides. */
    private static final int GAMES = 30;
    private static final int QUICK_GAMES = 4;

    @Override
    public String name() {
        return "tools";
    }

    @Override
    public String about() {
        return "Games of two bots of `steward new cpp` under the tools of others, by the CPU time of everything"
            + " together: the tool, the referee, the bots, and the resident referee. Compared with the tool and the"
            + " referee in Go of robostac/coders-strike-back-referee, which has the old mode of cg-brutaltester (for"
            + " psyleague, by a script in Python of 30 lines). A run is of " + 2 * GAMES + " games under"
            + " cg-brutaltester and of " + GAMES + " under psyleague; the start of a resident is part of the first"
            + " run that it serves.";
    }

    @Override
    public int steps(Effort effort) {
        return 2 * effort.fewRounds() * ToolGames.Referee.values().length;
    }

    @Override
    public boolean isRough(Effort effort) {
        return effort == Effort.QUICK;
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        List<String> missing = new ArrayList<>();
        for (ToolGames.Tool tool : ToolGames.Tool.values()) {
            List<Path> absent = tool.files(tools).stream().filter(file -> !Files.exists(file)).toList();
            if (absent.isEmpty()) {
                compare(tool, effort.fewRounds(), effort == Effort.QUICK ? QUICK_GAMES : GAMES, about, rows);
            } else {
                missing.add(tool.word() + " is skipped: there is no " + absent.get(0));
            }
        }
        if (!missing.isEmpty()) {
            throw new IOException(String.join("; ", missing));
        }
    }

    private void compare(ToolGames.Tool tool, int rounds, int games, Consumer<String> about, Consumer<Row> rows)
            throws Exception {
        ToolGames.Referee[] referees = ToolGames.Referee.values();
        double[][] nanos = new double[referees.length][rounds];
        try (ToolGames played = new ToolGames(fixture.launcher(), tools, tool)) {
            for (int round = 0; round < rounds; round++) {
                for (int k = 0; k < referees.length; k++) {
                    about.accept(tool.word());
                    nanos[k][round] = played.nanos(referees[k], games, round + 1);
                }
                played.endResident();
            }
        }
        for (int k = 0; k < referees.length; k++) {
            double[] ratios = Meter.ratios(nanos[k], nanos[0], rounds);
            rows.accept(new Row(name(), tool.word() + ", " + referees[k].word(), "games",
                NANOS / Meter.median(nanos[k]), 1 / Meter.median(ratios), Double.NaN, k == 0 ? ""
                : String.format(Locale.ROOT, "%.3f times the CPU of Go's (%.3f to %.3f in %d pairs)",
                Meter.median(ratios), ratios[0], ratios[rounds - 1], rounds)));
        }
    }
}
