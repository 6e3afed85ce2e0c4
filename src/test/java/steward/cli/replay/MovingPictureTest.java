package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;
import steward.bots.BundledBots;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Marauder;
import steward.cli.Cli;
import steward.cli.streams.Json;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.replay.page.PageTestRaces;

/** The moving picture of a match: every body is where the replay says, at the end of every turn. */
class MovingPictureTest {

    @TempDir
    private Path folder;

    private String picture(Path replay, String... more) throws IOException {
        Path svg = folder.resolve(replay.getFileName() + ".svg");
        Cli cli = Cli.run(List.of("replay", replay.toString(), "--picture", svg.toString(),
            "--overwrite"), more);
        assertEquals("Picture: " + svg + "\n", cli.out(), cli.err());
        return Files.readString(svg);
    }

    /** The README's picture is made by the lines that the page on watching gives. */
    @Test
    @Tag("process")                                       // bundled bots
    void theReadmesPictureIsOfOurs() throws IOException {
        Path replay = folder.resolve("race.jsonl");
        Cli.run("match", "--scene", "walled-race", "--bot", "builtin:veteran", "--bot", "builtin:contender", "--seed",
            "7", "--time-factor", "30", "--out", replay.toString()).done();
        assertEquals(Files.readString(Path.of("docs/race.svg")), picture(replay));
    }

    @Test
    void bodiesAreWhereTheReplaySays() throws IOException, ParserConfigurationException, SAXException {
        Path race = Files.write(folder.resolve("race.jsonl"), PageTestRaces.play(PageTestRaces.scene("walled-race"),
            3));
        assertTrue(compare(race, picture(race), 0) > 200);
        Path part = Files.write(folder.resolve("part.jsonl"), Recorded.of(TestScenes.open("mean-max"), 7,
            List.of(BundledBots.of(new Marauder()), BundledBots.of(new Gatherer()), BundledBots.of(new Gatherer())))
            .bytes());
        assertTrue(compare(part, picture(part, "--from", "20", "--to", "60"), 20) > 41 * 9);
    }

    /** Returns how many places were compared. */
    private static int compare(Path replay, String svg, int from)
            throws IOException, ParserConfigurationException, SAXException {
        NodeList all = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8))).getElementsByTagName(
                "animateTransform");
        List<double[][]> paths = new ArrayList<>();
        double turns = 0;
        for (int k = 0; k < all.getLength(); k++) {
            Element each = (Element) all.item(k);
            if (each.getAttribute("type").equals("translate")) {
                turns = 10 * Double.parseDouble(each.getAttribute("dur").replace("s", ""));
                paths.add(new double[][] {numbers(each.getAttribute("keyTimes").split(";")),
                    numbers(each.getAttribute("values").replaceAll(",[^;]*", "").split(";")),
                    numbers(each.getAttribute("values").replaceAll("[^;]*,", "").split(";"))});
            }
        }
        int compared = 0;
        try (ReplayReader reader = ReplayReader.open(replay)) {
            int turn = 0;
            for (RecordedTurn next = reader.next(); next != null; next = reader.next()) {
                turn++;
                double time = (turn - from) / turns;
                if (time < 0 || turn - from > turns - 15) {
                    continue;
                }
                for (var body : Json.objects(((java.util.Map<?, ?>) Json.object(next.outcome()).get("state"))
                        .get("bodies"))) {
                    double x = Json.number(body.get("x"));
                    double y = Json.number(body.get("y"));
                    assertTrue(paths.stream().anyMatch(path -> Math.hypot(at(path, 1, time) - x,
                        at(path, 2, time) - y) < 30), () -> "no body at " + x + ", " + y + " at " + time);
                    compared++;
                }
            }
        }
        return compared;
    }

    private static double at(double[][] path, int which, double time) {
        int k = 1;
        while (path[0][k] < time - 5e-6) {
            k++;
        }
        while (k + 1 < path[0].length && Math.abs(path[0][k + 1] - time) < 1e-5) {
            k++;
        }
        double part = path[0][k] == path[0][k - 1] ? 1 : (time - path[0][k - 1]) / (path[0][k] - path[0][k - 1]);
        return path[which][k - 1] + Math.min(1, part) * (path[which][k] - path[which][k - 1]);
    }

    private static double[] numbers(String... texts) {
        double[] numbers = new double[texts.length];
        for (int k = 0; k < texts.length; k++) {
            numbers[k] = Double.parseDouble(texts[k]);
        }
        return numbers;
    }

    @Test
    void nothingIsOverwritten() throws IOException {
        Path replay = Files.write(folder.resolve("duel.jsonl"), Recorded.of("duel", 3).bytes());
        Path svg = Files.writeString(folder.resolve("x.svg"), "mine");
        Cli.run("replay", replay.toString(), "--picture", svg.toString()).assertRefused("exists already, and is kept");
        assertEquals("mine", Files.readString(svg));
    }
}
