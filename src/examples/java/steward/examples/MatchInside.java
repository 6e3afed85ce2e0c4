package steward.examples;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodSeat;
import steward.game.podrace.PodState;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.DirectBot;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;

/** A match between two bots inside the JVM, recorded: {@code java ... steward.examples.MatchInside match.jsonl}. */
public final class MatchInside {

    private MatchInside() {
    }

    /** Steers at the next checkpoint, against its drift. */
    private static final class Straight implements DirectBot {

        private final int thrust;
        private PodRace race;
        private PodSeat seat;

        Straight(int thrust) {
            this.thrust = thrust;
        }

        @Override
        public void start(Game game, int player) {
            race = (PodRace) game;
            seat = new PodSeat(race, player);
        }

        @Override
        public void turn() {
            double[][] checkpoints = race.checkpoints();
            for (int k = seat.first(); k < seat.end(); k++) {
                PodState pod = race.pod(k);
                double[] next = checkpoints[race.nextCheckpoint(k)];
                seat.thrust(k, next[0] - 3 * pod.vx(), next[1] - 3 * pod.vy(), thrust);
            }
        }
    }

    /** Plays a match and writes its replay. */
    public static MatchResult play(long seed, OutputStream replay) throws InterruptedException {
        GameTypes games = new GameTypes(List.of(new PodRaceType()));
        GameSetup setup = games.open(SceneReader.read(SceneFiles.load("mad-pod-racing"), null));
        List<String> names = List.of("fast", "slow");
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names,
            List.of("thrust 120", "thrust 70"), Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion());
        List<Seat> seats = List.of(Seat.direct(names.get(0), new Straight(120)),
            Seat.direct(names.get(1), new Straight(70)));
        return Referee.of(setup, seed, seats, TimeControl.UNLIMITED, new ReplayWriter(replay, header)).play();
    }

    /** @param arguments the file for the replay */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        if (arguments.length != 1) {
            System.err.println("expected one argument, the file for the replay");
            System.exit(2);
        }
        try (OutputStream replay = Files.newOutputStream(Path.of(arguments[0]))) {
            MatchResult result = play(7, replay);
            System.out.println(result.players().get(result.winner()).name() + " wins: " + result.ending());
        }
    }
}
