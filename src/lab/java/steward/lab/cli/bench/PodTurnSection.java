package steward.lab.cli.bench;

import java.util.List;
import java.util.function.Consumer;
import steward.game.podrace.protocol.PodRaceType;
import steward.lab.bench.Effort;
import steward.lab.bench.GroupSection;
import steward.lab.bench.Row;
import steward.lab.bench.Section;

/** Bench section on the turn of the official pod race, by all that can play it: {@link BenchPodGames}. */
record PodTurnSection(PodRaceType.PodRaceSetup setup) implements Section {

    /** Number of contenders, in a race and in a brawl. */
    private static final int CONTENDERS = 6;

    @Override
    public String name() {
        return "pods";
    }

    @Override
    public String about() {
        return "Turns of four pods by the official rules, by CPU time: "
            + BenchPodGames.GAMES + " games of " + BenchPodGames.TURNS + " turns, which have to end alike for"
            + " everybody. In a race each pod is after its checkpoints, in a brawl after another pod. A plain port of"
            + " the rules; the engine of matches; the simulator for bots that search.";
    }

    @Override
    public int steps(Effort effort) {
        return GroupSection.steps(CONTENDERS, effort);
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        for (boolean brawl : new boolean[] {false, true}) {
            BenchPodGames games = new BenchPodGames(setup, brawl);
            new GroupSection(name(), about(), List.of(new GroupSection.Group("turns",
                games.contenders(brawl ? "brawl, " : "race, ")))).run(effort, about, rows);
        }
    }
}
