package steward.lab.cli.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.game.podrace.protocol.PodRaceType;
import steward.game.podrace.simulator.ParallelBatch;
import steward.game.podrace.simulator.PodRaceBatch;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.GroupSection;
import steward.lab.bench.Row;
import steward.lab.bench.Section;

/**
 * Bench section on the turn of the official pod race, by every implementation that can play it: {@link BenchPodGames}.
 *
 * @param threads how many threads play the batches of the last rows
 */
record PodTurnSection(PodRaceType.PodRaceSetup setup, int threads) implements Section {

    /** Number of contenders, in a race and in a brawl. */
    private static final int CONTENDERS = 10;

    @Override
    public String name() {
        return "pods";
    }

    @Override
    public String about() {
        return "Turns of four pods by the official rules, by CPU time, on threads by the wall clock: "
            + BenchPodGames.GAMES + " games of " + BenchPodGames.TURNS + " turns, which have to end alike for"
            + " everybody. In a race each pod is after its checkpoints, in a brawl after another pod. A plain port of"
            + " the rules; the engine of matches; the simulator for bots that search; all games in a batch.";
    }

    @Override
    public int steps(Effort effort) {
        return GroupSection.steps(CONTENDERS, effort);
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        for (boolean brawl : new boolean[] {false, true}) {
            String crowd = brawl ? "brawl, " : "race, ";
            BenchPodGames games = new BenchPodGames(setup, brawl);
            PodRaceBatch batch = games.batch();
            try (ParallelBatch parallel = new ParallelBatch(batch, threads)) {
                List<Contender> contenders = new ArrayList<>(games.alone(crowd));
                contenders.add(games.onThreads(crowd, batch, parallel));
                new GroupSection(name(), about(), List.of(new GroupSection.Group("turns", contenders)))
                    .run(effort, about, rows);
            }
        }
    }
}
