package steward.codingame.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.CodecText;
import steward.game.GroundTruth;
import steward.game.TextCodec;
import steward.game.podrace.PodRace;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;
import steward.replay.verify.Verification;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The seven whole official games of 2016, put into the form of CodinGame's JSON, imported and verified: commands,
 * positions, speeds, shields and next checkpoints are the server's. Headings are recorded there as rounded degrees, so
 * that their bits are ours; impacts are not recorded.
 */
@Execution(ExecutionMode.CONCURRENT)
class OfficialRecordingsImportTest {

    private static final int PODS = 4;
    /** Values of a pod that stand in a recording and are compared: x y vx vy, shield, next checkpoint. */
    private static final int RECORDED = 6;

    private final PodRaceType.PodRaceSetup official =
        (PodRaceType.PodRaceSetup) TestScenes.open("mad-pod-racing");

    @Test
    @Tag("slow")
    void everyOfficialGameVerifies(TestReporter report) throws IOException {
        Path folder = Path.of(System.getProperty("steward.replays", "../shared/replays"));
        assumeTrue(Files.isDirectory(folder), "skipped: no folder of replays, -Psteward.replays=FOLDER");
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.filter(file -> file.getFileName().toString().startsWith("replay_")).sorted().toList();
        }
        assumeTrue(!files.isEmpty(), () -> "skipped: no replay_* in " + folder.toAbsolutePath());
        GroundTruth.Report all = new GroundTruth.Report(report, "pod-race of 2016");
        for (Path file : files) {
            ImportedRecording recording = ImportedRecording.of(json(Files.readAllLines(file)));
            Verification verification = recording.verified();
            String difference = recording.difference(verification);
            all.add(file.getFileName().toString(), verification.turns(), (long) verification.turns() * PODS * RECORDED,
                difference, List.of("headings, whole degrees there", "impacts, which are not told"));
        }
        assertEquals(List.of(), all.differences());
        assertTrue(all.values() > 0, "the folder holds games");
    }

    /** The game in the form of the site's own JSON. */
    private String json(List<String> lines) {
        List<String> in = rows(lines, "IN ");
        List<String> moves = rows(lines, "MOV ");
        List<String> out = rows(lines, "OUT ");
        String map = rows(lines, "CHECKPOINTS ").get(0);
        PodRace race = official.create(points(map));
        TextCodec codec = official.textCodec(race).orElseThrow();
        SiteViews views = new SiteViews(race);
        ObjectNode game = JsonMapper.shared().createObjectNode();
        ArrayNode frames = game.putArray("frames");
        frames.addObject().put("keyframe", true).put("view", views.first(pods(in.subList(0, PODS), race)));
        for (int from = 0; from < moves.size(); from += PODS) {
            for (int player = 0; player < 2; player++) {
                String said = moves.get(from + 2 * player) + "\n" + moves.get(from + 2 * player + 1);
                assertNull(CodecText.read(codec, player, said));
                frames.addObject().put("keyframe", player == 1).put("stdout", said + "\n");
            }
            views.before();
            race.play();
            String view = views.after(frames.size() - 1, pods(out.subList(from, from + PODS), race), "");
            ((ObjectNode) frames.get(frames.size() - 1)).put("view", String.join("\n",
                view.lines().limit(1 + 2 * PODS).toList()));
        }
        if (race.isOver()) {
            ArrayNode ranks = game.putArray("ranks");
            boolean firstWins = lines.get(0).startsWith("Replay between " + lines.get(1).split(" ")[1] + " and ");
            ranks.add(firstWins ? 0 : 1).add(firstWins ? 1 : 0);
        }
        return game.toString();
    }

    private static List<String> rows(List<String> lines, String first) {
        return lines.stream().filter(line -> line.startsWith(first)).map(line -> line.substring(first.length()))
            .toList();
    }

    private static double[][] points(String map) {
        List<double[]> points = new ArrayList<>();
        String[] words = map.split(" ");
        for (int k = 0; k < words.length; k += 2) {
            points.add(new double[] {Double.parseDouble(words[k]), Double.parseDouble(words[k + 1])});
        }
        return points.toArray(new double[0][]);
    }

    /** Rows: x y vx vy headingDegrees nextCheckpoint shield boosted; shield is 3 after the turn it was raised in. */
    private static List<String[]> pods(List<String> rows, PodRace race) {
        List<String[]> pods = new ArrayList<>();
        for (int pod = 0; pod < PODS; pod++) {
            String[] row = rows.get(pod).split(" ");
            double heading = race.pod(pod).heading();
            if (!Double.isNaN(heading)) {
                double off = Math.IEEEremainder(Math.toDegrees(heading) - Double.parseDouble(row[4]), 360);
                assertEquals(0, off, 1e-9, "the heading that takes its place");
            }
            pods.add(new String[] {row[0], row[1], row[2], row[3], null, row[6].equals("3") ? "1" : "0", row[5]});
        }
        return pods;
    }
}
