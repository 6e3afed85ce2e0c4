package steward.bench.section;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import steward.bench.Contender;
import steward.bench.Effort;
import steward.bench.Meter;
import steward.bench.Row;
import steward.bench.Section;
import steward.game.GameSetup;
import steward.match.MatchListener;

/** How the cost of a match grows with its players and its turns. */
final class GrowthSection implements Section {

    private static final MatchListener NOBODY = new MatchListener() { };
    private static final int SEEDS = 20;

    private final MatchFixture kit;
    private final Map<String, GameSetup> scenes;

    /** @param scenes by what is told of them; the first is what the others are compared with */
    GrowthSection(MatchFixture kit, Map<String, GameSetup> scenes) {
        this.kit = kit;
        this.scenes = scenes;
    }

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
            MatchFixture other = new MatchFixture(kit.types(), setup, kit.direct(), kit.lines(), kit.responder(),
                kit.launcher(), kit.plain());
            int[] next = new int[1];
            contenders.add(new Contender(name, () ->
                MatchSection.match(other, MatchSection.direct(other), next[0]++ % SEEDS, NOBODY).turns()));
        });
        new Meter().compare(name(), "turns", contenders, effort, about, rows);
    }
}
