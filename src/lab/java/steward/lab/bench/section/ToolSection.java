package steward.lab.bench.section;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import steward.lab.bench.Comparison;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.lab.timing.TimingEffort;

/** Bench section on another project's tool: CPU time of its games with our referee, and with a referee in Go. */
public record ToolSection(MatchFixture fixture, Path tools) implements Section {

    /** Games of a run; cg-brutaltester plays each seed from both sides. */
    private static final int GAMES = 30;
    private static final int QUICK_GAMES = 4;

    @Override
    public String name() {
        return "tools";
    }

    @Override
    public String about() {
        return "Games of two bots of `steward new cpp` under cg-brutaltester. The CPU time is that of everything"
            + " together: the tool, the referee, the bots, and the resident referee. Compared with the referee in Go"
            + " of robostac/coders-strike-back-referee, which has the tool's old mode."
            + " A run is of " + 2 * GAMES + " games.";
    }

    @Override
    public int steps(Effort effort) {
        return timing(effort).steps(ToolGames.Referee.values().length);
    }

    private static TimingEffort timing(Effort effort) {
        return new TimingEffort(1, effort.few().rounds(), 0, 0, 0);
    }

    @Override
    public void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception {
        for (String file : ToolGames.FILES) {
            if (!Files.exists(tools.resolve(file))) {
                throw new IOException("found no " + tools.resolve(file));
            }
        }
        int games = effort == Effort.QUICK ? QUICK_GAMES : GAMES;
        try (ToolGames played = new ToolGames(fixture.launcher(), tools)) {
            List<Contender> contenders = Stream.of(ToolGames.Referee.values()).map(referee ->
                new Contender("cg-brutaltester, " + referee.word(), least -> played.play(referee, games))).toList();
            new Comparison(name(), "games", contenders, Comparison::paired).run(timing(effort), step, rows);
        }
    }
}
