package steward.lab.cli.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;

/**
 * The pods of a race turn by turn, copied into another race of the same scene over and over, so that all have moved.
 */
final class BenchRaceStates implements Consumer<Game> {

    private static final int MOST = 256;

    private final List<PodState[]> states = new ArrayList<>();
    private int next;

    /** Plays the race once. */
    BenchRaceStates(GameSetup setup) {
        PodRace race = (PodRace) setup.create(1);
        List<BenchDirectBot> bots = new ArrayList<>();
        for (int player = 0; player < race.players(); player++) {
            bots.add(new BenchDirectBot());
            bots.get(player).start(race, player);
        }
        while (states.size() < MOST && !race.isOver()) {
            bots.forEach(BenchDirectBot::turn);
            race.play();
            states.add(IntStream.range(0, race.settings().pods()).mapToObj(race::pod).toArray(PodState[]::new));
        }
    }

    @Override
    public void accept(Game game) {
        PodRace race = (PodRace) game;
        PodState[] pods = states.get(next);
        next = (next + 1) % states.size();
        for (int pod = 0; pod < pods.length; pod++) {
            race.setPod(pod, pods[pod]);
        }
    }
}
