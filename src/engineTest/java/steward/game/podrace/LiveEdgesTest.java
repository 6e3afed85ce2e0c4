package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import steward.game.GroundTruth;
import steward.game.podrace.Recordings.Command;
import steward.game.podrace.protocol.PodRaceType;
import steward.game.podrace.simulator.PodCommands;
import steward.game.podrace.simulator.PodRaceSimulator;
import steward.numerics.SineCosine;

/**
 * Turns of the live server that decide when a checkpoint is passed and when a player is out. The expected numbers are
 * the server's: {@code live_edges.txt} of the sample, whose head tells the form.
 */
class LiveEdgesTest {

    private static final int PODS = 4;
    private static final int HEADING = 4;
    private static final int SHIELD = 5;
    private static final int NEXT = 6;
    /** An older server: only its next checkpoints are those of today. */
    private static final String OLDER = "158224761";
    /** A shield timer of a pod whose thrust does not act. */
    private static final int COOLING = 3;

    private final PodRaceType.PodRaceSetup setup = Recordings.official();

    /** The lines of one block: a turn of four pods. */
    private record Block(String[] turn, double[][] map, double[][] before, int[] left, String[] moves, String[] thrusts,
                         List<String[]> impacts, double[][] after, int[] leftAfter, String[] out) {
    }

    @Test
    void everyTurnPassesWhatTheServerPassesAndEliminatesWhomItEliminates(TestReporter report) {
        int turns = 0;
        int passes = 0;
        int out = 0;
        for (Block block : blocks()) {
            PodRace race = begin(block);
            race.play();
            compare(block, race);
            compareSimulated(block, race);
            turns++;
            out += block.out() == null ? 0 : 1;
            for (int pod = 0; pod < PODS; pod++) {
                passes += block.before()[pod][NEXT] == block.after()[pod][NEXT] ? 0 : 1;
            }
        }
        GroundTruth.tell(report, turns + " turns of the live server compared, " + passes + " checkpoints passed, " + out
            + " eliminations");
        assertTrue(turns > 0, "no turns");
    }

    @Test
    void everySinglePodPassesWhatTheServerPasses(TestReporter report) {
        int lines = 0;
        for (String line : lines()) {
            if (line.startsWith("Q ")) {
                comparePod(line, line.split(" "));
                lines++;
            }
        }
        GroundTruth.tell(report, lines + " pods of the live server compared");
        assertTrue(lines > 0, "no single pods");
    }

    /** Q battle viewBefore viewAfter pod x y vx vy headingAfter thrust x' y' vx' vy' cpX cpY passed. */
    private void comparePod(String line, String[] words) {
        double[] number = Arrays.stream(words, 5, 17).mapToDouble(Double::parseDouble).toArray();
        boolean last = words[17].equals("F");
        double[] checkpoint = {number[10], number[11]};
        double[] far = {-1e6, 1e6};
        PodRace race = setup.create(last ? new double[][] {checkpoint, far} : new double[][] {far, checkpoint});
        for (int pod = 1; pod < PODS; pod++) {
            race.setPod(pod, new PodState(1e6, 1e5 * pod, 0, 0, Double.NaN, 0, true, 0));
        }
        SineCosine direction = new SineCosine();
        direction.turn(number[4]);
        double length = Math.sqrt(direction.cos() * direction.cos() + direction.sin() * direction.sin());
        double vx = number[2] + direction.cos() / length * number[5];
        double vy = number[3] + direction.sin() / length * number[5];
        int before = last ? 3 * 2 - 1 : 0;
        race.setPod(0, new PodState(number[0], number[1], vx, vy, number[4], 0, true, before));
        race.play();
        PodState after = race.pod(0);
        assertEquals(number[6], after.x(), line);
        assertEquals(number[7], after.y(), line);
        assertEquals(number[8], after.vx(), line);
        assertEquals(number[9], after.vy(), line);
        assertEquals(words[17].equals("0") ? before : before + 1, after.passed(), line);
        assertEquals(last, race.isOver(), line);
        if (last) {
            assertEquals(0, race.nextCheckpoint(0), "the next one that the last frame shows: " + line);
        }
    }

    private static List<String> lines() {
        return Recordings.lines(GroundTruth.sample("live_edges.txt"));
    }

    private static List<Block> blocks() {
        List<Block> blocks = new ArrayList<>();
        String[][] now = new String['Z'][];
        List<String[]> impacts = new ArrayList<>();
        for (String line : lines()) {
            String[] words = line.split(" ");
            if (words[0].equals("T")) {
                add(blocks, now, impacts);
                now = new String['Z'][];
                impacts = new ArrayList<>();
            }
            if (words[0].equals("C")) {
                impacts.add(words);
            } else if (words[0].length() == 1) {
                now[words[0].charAt(0)] = words;
            }
        }
        add(blocks, now, impacts);
        return blocks;
    }

    private static void add(List<Block> blocks, String[][] now, List<String[]> impacts) {
        if (now['T'] != null) {
            blocks.add(new Block(now['T'], Recordings.map(now['P']), Recordings.rows(now['S'], 1), leftBefore(now),
                now['M'], now['W'], impacts, Recordings.rows(now['E'], 1), left(now['R']), now['D']));
        }
    }

    /** The counters before; where they were not read, those of a turn without a checkpoint. */
    private static int[] leftBefore(String[][] block) {
        return block['N'] != null ? left(block['N'])
            : Arrays.stream(left(block['R'])).map(left -> left + 1).toArray();
    }

    private static int[] left(String[] words) {
        return Arrays.stream(words, 1, 3).mapToInt(word -> Integer.parseInt(word.split(":")[1])).toArray();
    }

    /** The state before and the commands. Its thrust shows if a pod cools down, and has its boost. */
    private PodRace begin(Block block) {
        PodRace race = setup.create(block.map());
        for (int pod = 0; pod < PODS; pod++) {
            double[] row = block.before()[pod];
            String word = block.moves()[3 + 3 * pod];
            String acted = block.thrusts()[1 + pod];
            int timer = row[SHIELD] == 1 ? PodRaceSettings.SHIELD_TURNS
                : acted.equals("0") && !word.equals("0") && !word.equals("SHIELD") ? COOLING : 0;
            int count = block.map().length;
            race.setPod(pod, new PodState(row[0], row[1], row[2], row[3], row[HEADING], timer, !acted.equals("200"),
                ((int) row[NEXT] + count - 1) % count));
            Command command = Recordings.command(block.moves()[1 + 3 * pod], block.moves()[2 + 3 * pod], word);
            race.command(pod, command.x(), command.y(), command.thrust());
        }
        race.setTurnsLeft(0, block.left()[0]);
        race.setTurnsLeft(1, block.left()[1]);
        return race;
    }

    private void compare(Block block, PodRace race) {
        String where = String.join(" ", block.turn());
        for (int pod = 0; pod < PODS; pod++) {
            assertEquals((int) block.after()[pod][NEXT], race.nextCheckpoint(pod), where + ", next of pod " + pod);
        }
        if (block.turn()[1].equals(OLDER)) {
            return;
        }
        for (int pod = 0; pod < PODS; pod++) {
            double[] row = block.after()[pod];
            PodState found = race.pod(pod);
            assertEquals(Arrays.toString(Arrays.copyOf(row, SHIELD)), Arrays.toString(new double[] {found.x(),
                found.y(), found.vx(), found.vy(), found.heading()}), where + ", pod " + pod);
        }
        assertEquals(block.impacts().size(), race.log().impacts(), where + ", impacts");
        for (int k = 0; k < block.impacts().size(); k++) {
            String[] words = block.impacts().get(k);
            assertArrayEquals(Arrays.stream(words, 2, 12).mapToDouble(Double::parseDouble).toArray(),
                Recordings.numbers(race.log().impact(k)), where + " " + String.join(" ", words));
        }
        for (int player = 0; player < 2; player++) {
            assertEquals(block.leftAfter()[player], race.turnsLeft(player), where + ", turns left of " + player);
            boolean dead = block.out() != null && block.out()[1 + 2 * player].equals("1");
            assertEquals(!dead, race.isIn(player), where + ", player " + player + " is in");
        }
        assertEquals(block.out() != null, race.isOver(), where + ", is over");
    }

    /** The simulator goes on behind the finish, so that it is asked for what has been passed. */
    private void compareSimulated(Block block, PodRace played) {
        PodRace before = begin(block);
        PodRaceSimulator race = new PodRaceSimulator(block.map());
        PodCommands commands = new PodCommands(PODS);
        for (int pod = 0; pod < PODS; pod++) {
            Races.put(race, pod, before.pod(pod));
            commands.set(pod, before.targetX(pod), before.targetY(pod), before.thrust(pod));
        }
        race.play(commands);
        for (int pod = 0; pod < PODS; pod++) {
            assertEquals(played.pod(pod), Races.state(race, pod),
                "simulator, " + String.join(" ", block.turn()) + ", pod " + pod);
        }
    }
}
