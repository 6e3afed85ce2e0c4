package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.podrace.Recordings.Command;
import steward.physics.Impact;

/**
 * Turns of the server of 2026 at full precision: states, and every impact with its time and impulse to the last bit.
 * Impacts tell correctly rounded sine and cosine from {@code StrictMath}'s, and a product with 1/m from a division.
 */
class OfficialTurnsTest {

    private static final int PODS = 4;
    private static final int COLUMNS = 7;
    private static final int HEADING = 4;
    private static final int SHIELD = 5;
    private static final int NEXT = 6;

    /** Turns and impacts compared, over all files. */
    private int turns;
    private int impacts;

    /** Of the file that is read: its map, the race, the state before the turn. */
    private double[][] checkpoints;
    private PodRace race;
    private int[] timers;
    private double[][] before;
    private String[] moves;
    private final List<String[]> recorded = new ArrayList<>();

    @Test
    void everyTurnAndEveryImpactToTheLastBit(TestReporter report) throws IOException {
        try (Stream<Path> files = Files.list(Recordings.folder())) {
            for (Path file : files.filter(each
                -> each.getFileName().toString().startsWith("turns_")).sorted().toList()) {
                forget();
                checkpoints = null;
                Recordings.lines(file).forEach(line -> read(file.getFileName().toString(), line.trim().split(" +")));
            }
        }
        report.publishEntry(turns + " turns and " + impacts + " impacts of the server compared");
        assertTrue(turns > 0 && impacts > 0, "the folder holds turns and impacts");
    }

    private void forget() {
        race = null;
        timers = null;
        moves = null;
        recorded.clear();
    }

    private void read(String file, String[] words) {
        switch (words[0]) {
            case "#" -> {
                if (words[1].equals("GAME") || words[1].equals("timers")) {
                    forget();
                }
                if (words[1].equals("timers")) {
                    timers = Arrays.stream(words, 2, 2 + PODS).mapToInt(Integer::parseInt).toArray();
                }
            }
            case "CHECKPOINTS" -> {
                checkpoints = new double[(words.length - 1) / 2][];
                for (int k = 0; k < checkpoints.length; k++) {
                    checkpoints[k] = new double[] {Double.parseDouble(words[1 + 2 * k]),
                        Double.parseDouble(words[2 + 2 * k])};
                }
            }
            case "S" -> state(file + " S " + words[1], row(words));
            case "M" -> moves = words;
            case "C" -> recorded.add(words);
            default -> { }
        }
    }

    private void state(String where, double[][] state) {
        if (moves == null) {
            begin(state);
        } else {
            compareTurn(where, state);
        }
        before = state;
        moves = null;
        recorded.clear();
    }

    private void begin(double[][] state) {
        // Where no checkpoint of the game is recorded, far-away ones keep the race going.
        double[][] map = checkpoints == null ? new double[][] {{-1e6, -1e6}, {1e6, 1e6}} : checkpoints;
        race = Recordings.official().create(map);
        for (int pod = 0; pod < PODS; pod++) {
            int timer = timers != null ? timers[pod] : state[pod][SHIELD] == 1 ? PodRaceSettings.SHIELD_TURNS : 0;
            race.setPod(pod, new PodState(state[pod][0], state[pod][1], state[pod][2], state[pod][3],
                state[pod][HEADING], timer, true, ((int) state[pod][NEXT] + map.length - 1) % map.length));
        }
    }

    private static double[][] row(String[] words) {
        double[][] pods = new double[PODS][COLUMNS];
        for (int k = 0; k < PODS * COLUMNS; k++) {
            pods[k / COLUMNS][k % COLUMNS] = words[2 + k].equals("null") ? Double.NaN
                : Double.parseDouble(words[2 + k]);
        }
        return pods;
    }

    private void compareTurn(String where, double[][] after) {
        for (int pod = 0; pod < PODS; pod++) {
            Command command = Recordings.command(moves[1 + 3 * pod], moves[2 + 3 * pod], moves[3 + 3 * pod]);
            race.command(pod, command.x(), command.y(), command.thrust());
        }
        race.play();
        turns++;
        for (int pod = 0; pod < PODS; pod++) {
            String what = where + " pod " + pod;
            PodState found = race.pod(pod);
            assertEquals(after[pod][0], found.x(), what);
            assertEquals(after[pod][1], found.y(), what);
            assertEquals(after[pod][2], found.vx(), what);
            assertEquals(after[pod][3], found.vy(), what);
            assertEquals(after[pod][HEADING], found.heading(), what);
            if (checkpoints != null) {
                assertEquals((int) after[pod][NEXT], race.nextCheckpoint(pod), what);
            }
        }
        assertEquals(recorded.size(), race.log().impacts(), where + ": impacts");
        for (int k = 0; k < recorded.size(); k++) {
            compareImpact(where + " impact " + k, recorded.get(k), race.log().impact(k));
        }
    }

    private void compareImpact(String what, String[] words, Impact impact) {
        impacts++;
        assertEquals(Double.parseDouble(words[1]), impact.time(), what);
        assertEquals(Integer.parseInt(words[2]), impact.a(), what);
        assertEquals(Integer.parseInt(words[5]), impact.b(), what);
        assertEquals(Double.parseDouble(words[8]), impact.impulse(), what);
        assertEquals(Long.parseLong(words[3]), Math.round(impact.ax()), what);
        assertEquals(Long.parseLong(words[4]), Math.round(impact.ay()), what);
        assertEquals(Long.parseLong(words[6]), Math.round(impact.bx()), what);
        assertEquals(Long.parseLong(words[7]), Math.round(impact.by()), what);
        assertEquals(Long.parseLong(words[9]), Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2), what);
        assertEquals(Long.parseLong(words[10]), Math.round((impact.vayBefore() + impact.vbyBefore()) / 2), what);
    }
}
