package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.GroundTruth;
import steward.game.podrace.Recordings.Command;

/**
 * Turns of the server of 2026 at full precision: states, and every impact with its time and impulse to the last bit.
 * Impacts tell correctly rounded sine and cosine from {@code StrictMath}'s, and a product with 1/m from a division.
 */
class OfficialTurnsTest {

    private static final int PODS = 4;
    private static final int HEADING = 4;
    private static final int SHIELD = 5;
    private static final int NEXT = 6;

    /** Of the file that is read: what was compared, and the first difference. */
    private int turns;
    private long values;
    private String difference;

    /** Of the file that is read: its map, the race, the state before the turn. */
    private double[][] checkpoints;
    private PodRace race;
    private int[] timers;
    private double[][] before;
    private String[] moves;
    private final List<String[]> recorded = new ArrayList<>();

    @Test
    void everyTurnAndEveryImpactToTheLastBit(TestReporter report) throws IOException {
        GroundTruth.Report all = new GroundTruth.Report(report, "pod-race of 2026");
        try (Stream<Path> files = Files.list(Recordings.folder())) {
            List<Path> named = files.filter(each -> each.getFileName().toString().startsWith("turns_")).sorted()
                .toList();
            assumeTrue(!named.isEmpty(), () -> "skipped: no turns_* in " + Recordings.folder());
            for (Path file : named) {
                forget();
                checkpoints = null;
                turns = 0;
                values = 0;
                difference = null;
                Recordings.lines(file).forEach(line -> read(line.trim().split(" +")));
                all.add(file.getFileName().toString(), turns, values, difference, List.of("shield timers, boosts",
                    "next checkpoints where the map is not recorded"));
            }
        }
        assertEquals(List.of(), all.differences());
        assertTrue(all.values() > 0, "the folder holds turns");
    }

    private void forget() {
        race = null;
        timers = null;
        moves = null;
        recorded.clear();
    }

    private void read(String... words) {
        switch (words[0]) {
            case "#" -> {
                if (words[1].equals("GAME") || words[1].equals("timers")) {
                    forget();
                }
                if (words[1].equals("timers")) {
                    timers = Arrays.stream(words, 2, 2 + PODS).mapToInt(Integer::parseInt).toArray();
                }
            }
            case "CHECKPOINTS" -> checkpoints = Recordings.map(words);
            case "S" -> state("S " + words[1], Recordings.rows(words, 2));
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
            double[] row = after[pod];
            compare(what, row[0], found.x(), row[1], found.y(), row[2], found.vx(), row[3], found.vy(), row[HEADING],
                found.heading());
            if (checkpoints != null) {
                compare(what + " next checkpoint", row[NEXT], race.nextCheckpoint(pod));
            }
        }
        compare(where + " number of impacts", recorded.size(), race.log().impacts());
        for (int k = 0; k < Math.min(recorded.size(), race.log().impacts()); k++) {
            double[] words = Arrays.stream(recorded.get(k), 1, 11).mapToDouble(Double::parseDouble).toArray();
            double[] found = Recordings.numbers(race.log().impact(k));
            for (int number = 0; number < words.length; number++) {
                compare(where + " impact " + k, words[number], found[number]);
            }
        }
    }

    /** @param pairs recorded and found, in turn; to the last bit */
    private void compare(String what, double... pairs) {
        for (int k = 0; k < pairs.length; k += 2) {
            values++;
            if (difference == null && Double.compare(pairs[k] + 0.0, pairs[k + 1] + 0.0) != 0) {
                difference = what + ": recorded " + pairs[k] + ", found " + pairs[k + 1];
            }
        }
    }
}
