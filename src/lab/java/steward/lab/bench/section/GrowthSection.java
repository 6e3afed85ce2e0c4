package steward.lab.bench.section;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.game.GameSetup;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.match.MatchListener;

/**
 * Growth of the cost of a match with its players and its turns.
 *
 * @param scenes by their descriptions; the others are compared with the first
 */
record GrowthSection(MatchFixture fixture, Map<String, GameSetup> scenes) implements Section {

    private static final MatchListener NO_LISTENER = new MatchListener() { };
    private static final int SEEDS = 20;

    @Override
    public String name() {
        return "growth";
    }

    @Override
    public String about() {
        return "Whole matches without replay between bots that look at the game, by CPU time: what a turn costs with"
            + " more players, of two pods each, and what it costs in shorter and longer matches.";
    }

    @Override
    public int steps(Effort effort) {
        return scenes.size() * (1 + effort.rounds());
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        List<Contender> contenders = new ArrayList<>();
        scenes.forEach((name, setup) -> {
            MatchFixture other = new MatchFixture(fixture.types(), setup, fixture.direct(), fixture.lines(),
                fixture.responder(), fixture.launcher(), fixture.plain());
            int[] next = new int[1];
            contenders.add(new Contender(name, () ->
                MatchSection.match(other, MatchSection.direct(other), next[0]++ % SEEDS, NO_LISTENER).turns()));
        });
        new Meter().compare(name(), "turns", contenders, effort, about, rows);
    }
}
