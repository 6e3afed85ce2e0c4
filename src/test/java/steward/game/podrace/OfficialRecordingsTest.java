package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import steward.game.podrace.Recordings.Command;
import steward.game.podrace.Recordings.Recording;
import steward.game.podrace.Recordings.Round;

/**
 * Ground truth: whole official games of 2016, as CodinGame's server computed them. Every value of every pod of every
 * round is compared. Games of 2026, with their impacts, are {@link OfficialTurnsTest}'s.
 */
class OfficialRecordingsTest {

    /** Columns of a state: x y vx vy headingDegrees nextCheckpoint shield boosted. */
    private static final String[] COLUMNS = {"x", "y", "vx", "vy", "heading", "nextCheckpoint", "shield", "boosted"};
    private static final int HEADING = 4;
    private static final int NEXT_CHECKPOINT = 5;

    /**
     * On the very last round of a game, the recordings keep 0 as the next checkpoint of the pod that has just passed
     * it and won. These are all such values in all seven games; nothing else may differ.
     */
    private static final Set<String> LAST_ROUND_EXCEPTIONS = Set.of(
        "replay_Lirkinvsepoxy.txt round 435 of 435 pod 0 nextCheckpoint: recorded 0.0, found 1.0",
        "replay_MagusvsTheSauce.txt round 218 of 218 pod 1 nextCheckpoint: recorded 0.0, found 1.0",
        "replay_NeumannvsMadKnight_1.txt round 442 of 442 pod 3 nextCheckpoint: recorded 0.0, found 1.0",
        "replay_pb4vsNeumann_1.txt round 339 of 339 pod 1 nextCheckpoint: recorded 0.0, found 1.0",
        "replay_sethvsMadKnight_1.txt round 317 of 317 pod 0 nextCheckpoint: recorded 0.0, found 1.0",
        "replay_sethvsSwagColoredKitteh.txt round 372 of 372 pod 1 nextCheckpoint: recorded 0.0, found 1.0");

    @Test
    void everyRoundFromItsOwnState() {
        List<String> differences = new ArrayList<>();
        int rounds = 0;
        for (Recording recording : Recordings.all()) {
            PodRace race = Recordings.contest().create(recording.checkpoints());
            for (int r = 0; r < recording.rounds().size(); r++) {
                Round round = recording.rounds().get(r);
                for (int pod = 0; pod < 4; pod++) {
                    race.setPod(pod, state(round.before()[pod], recording.checkpoints().length));
                }
                playRound(race, recording, r, differences);
                race = race.isOver() ? Recordings.contest().create(recording.checkpoints()) : race;
                rounds++;
            }
        }
        check(differences, rounds);
    }

    @Test
    void wholeGamesRunFreely() {
        List<String> differences = new ArrayList<>();
        int rounds = 0;
        for (Recording recording : Recordings.all()) {
            PodRace race = Recordings.contest().create(recording.checkpoints());
            for (int r = 0; r < recording.rounds().size(); r++) {
                playRound(race, recording, r, differences);
                rounds++;
            }
        }
        check(differences, rounds);
    }

    private static void check(List<String> differences, int rounds) {
        assertTrue(rounds > 0, "the folder holds games");
        differences.removeAll(LAST_ROUND_EXCEPTIONS);
        assertEquals(List.of(), differences);
    }

    private static void playRound(PodRace race, Recording recording, int r, List<String> differences) {
        Round round = recording.rounds().get(r);
        for (int pod = 0; pod < 4; pod++) {
            Command command = round.commands()[pod];
            race.command(pod, command.x(), command.y(), command.thrust());
        }
        race.play();
        for (int pod = 0; pod < 4; pod++) {
            double[] expected = round.after()[pod];
            double[] found = columns(race.pod(pod), recording.checkpoints().length);
            for (int column = 0; column < COLUMNS.length; column++) {
                boolean same = column == HEADING ? sameAngle(expected[column], found[column])
                    : expected[column] == found[column];
                if (!same) {
                    differences.add(recording.name() + " round " + (r + 1) + " of " + recording.rounds().size()
                        + " pod " + pod + " " + COLUMNS[column] + ": recorded " + expected[column] + ", found "
                        + found[column]);
                }
            }
        }
    }

    private static boolean sameAngle(double a, double b) {
        double difference = Math.abs(a - b) % 360;
        return Math.min(difference, 360 - difference) <= 1e-9;
    }

    private static PodState state(double[] row, int checkpoints) {
        int timer = row[6] == 0 ? 0 : (int) row[6] + 1;
        int passed = ((int) row[NEXT_CHECKPOINT] + checkpoints - 1) % checkpoints;
        return new PodState(row[0], row[1], row[2], row[3], Math.toRadians(row[HEADING]), timer, row[7] == 0, passed);
    }

    private static double[] columns(PodState pod, int checkpoints) {
        return new double[] {pod.x(), pod.y(), pod.vx(), pod.vy(), Math.toDegrees(pod.heading()),
            (pod.passed() + 1) % checkpoints, Math.max(0, pod.shieldTimer() - 1), pod.boostLeft() ? 0 : 1};
    }
}
