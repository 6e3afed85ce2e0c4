package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.GroundTruth;
import steward.game.podrace.Recordings.Command;
import steward.game.podrace.Recordings.Recording;
import steward.game.podrace.Recordings.Round;

/**
 * Ground truth: whole official games of 2016, as CodinGame's server computed them. Every value of every pod of every
 * round is compared. Games of 2026, with their impacts, are {@link OfficialTurnsTest}'s.
 */
@Execution(ExecutionMode.CONCURRENT)
class OfficialRecordingsTest {

    /** Columns of a state: x y vx vy headingDegrees nextCheckpoint shield boosted. */
    private static final String[] COLUMNS = {"x", "y", "vx", "vy", "heading", "nextCheckpoint", "shield", "boosted"};
    private static final int PODS = 4;
    private static final int HEADING = 4;
    private static final int NEXT_CHECKPOINT = 5;

    @Test
    void everyRoundFromItsOwnState(TestReporter report) {
        compareAll(report, "pod-race of 2016, each round by itself", true);
    }

    @Test
    void wholeGamesRunFreely(TestReporter report) {
        compareAll(report, "pod-race of 2016, whole", false);
    }

    /** @param afresh true if each round starts from its own recorded state */
    private static void compareAll(TestReporter report, String name, boolean afresh) {
        GroundTruth.Report all = new GroundTruth.Report(report, name);
        for (Recording recording : Recordings.all()) {
            int checkpoints = recording.checkpoints().length;
            PodRace race = Recordings.contest().create(recording.checkpoints());
            String difference = null;
            for (int r = 0; r < recording.rounds().size(); r++) {
                for (int pod = 0; afresh && pod < PODS; pod++) {
                    race.setPod(pod, state(recording.rounds().get(r).before()[pod], checkpoints));
                }
                String found = playRound(race, recording, r);
                difference = difference == null ? found : difference;
                race = afresh && race.isOver() ? Recordings.contest().create(recording.checkpoints()) : race;
            }
            int rounds = recording.rounds().size();
            all.add(recording.name(), rounds, (long) rounds * PODS * COLUMNS.length, difference,
                List.of("impacts, which are not told", "headings to more than whole degrees"));
        }
        assertEquals(List.of(), all.differences());
        assertTrue(all.values() > 0, "the folder holds games");
    }

    /** @return the first difference, or {@code null} */
    private static String playRound(PodRace race, Recording recording, int r) {
        Round round = recording.rounds().get(r);
        for (int pod = 0; pod < PODS; pod++) {
            Command command = round.commands()[pod];
            race.command(pod, command.x(), command.y(), command.thrust());
        }
        race.play();
        String difference = null;
        for (int pod = 0; pod < PODS; pod++) {
            double[] expected = round.after()[pod];
            double[] found = columns(race.pod(pod), recording.checkpoints().length);
            for (int column = 0; column < COLUMNS.length; column++) {
                boolean same = column == HEADING ? sameAngle(expected[column], found[column])
                    : expected[column] == found[column] || column == NEXT_CHECKPOINT && expected[column] == 0
                        && found[column] == 1 && hasPassedStart(recording, r, pod);
                if (!same && difference == null) {
                    difference = "round " + (r + 1) + " of " + recording.rounds().size() + " pod " + pod + " "
                        + COLUMNS[column] + ": recorded " + expected[column] + ", found " + found[column];
                }
            }
        }
        return difference;
    }

    /** True in the very last round for a pod that goes to checkpoint 0: of the winner 0 is kept as the next. */
    private static boolean hasPassedStart(Recording recording, int r, int pod) {
        return r == recording.rounds().size() - 1 && recording.rounds().get(r).before()[pod][NEXT_CHECKPOINT] == 0;
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
