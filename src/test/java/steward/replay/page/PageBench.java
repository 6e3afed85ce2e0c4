package steward.replay.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/**
 * Script time of a frame of the page of a match: of a frame within a turn, and of one that begins a turn. The frames
 * are drawn one after the other as fast as they go, so that the figures are of the script and not of the screen.
 */
public final class PageBench {

    private static final int TURNS = 60;
    private static final int FRAMES = 480;
    private static final int WIDTH = 16_000;
    private static final int HEIGHT = 9_000;

    private PageBench() {
    }

    /** Prints a line for a pod race and for games of more and more bodies. */
    public static void main(String[] args) throws IOException {
        Path folder = Files.createTempDirectory("steward-page-bench");
        try (PageTestBrowser browser = PageTestBrowser.start(folder.resolve("profile"))) {
            browser.size(1440, 900);
            browser.prefer(true, false);
            System.out.printf("%-10s %22s %22s%n", "ms", "frame: median, 90%", "turn begins: median, 90%");
            PageTestPages pages = new PageTestPages(folder);
            browser.open(pages.page(PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3), "Race"), "#t=1");
            measure(browser, "pod race");
            for (int bodies : new int[] {50, 500}) {
                browser.open(pages.live("Bodies"), "");
                lines(bodies).forEach(line -> browser.run("steward.addTurn(arguments[0])", line));
                measure(browser, bodies + " bodies");
            }
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
            }
        }
    }

    @SuppressWarnings("unchecked")
    private static void measure(PageTestBrowser browser, String name) {
        List<Number> found = (List<Number>) browser.run("""
            const [frames, turns] = arguments;
            const [within, begins] = [[], []];
            steward.pause();
            steward.setPlaying(true);
            for (let pass = 0; pass < 2; pass++) {
              within.length = begins.length = 0;
              for (let k = 0, last = 0; k < frames; k++) {
                const time = 4.001 + k * (turns - 6) / frames;
                (Math.ceil(time) === Math.ceil(last) ? within : begins).push(steward.frameMs(time));
                last = time;
              }
            }
            steward.setPlaying(false);
            const at = (list, share) => list.sort((one, other) => one - other)[Math.floor(share * (list.length - 1))];
            return [at(within, 0.5), at(within, 0.9), at(begins, 0.5), at(begins, 0.9)];
            """, FRAMES, TURNS);
        System.out.printf(Locale.ROOT, "%-10s %14.2f %7.2f %14.2f %7.2f%n", name, found.get(0).doubleValue(),
            found.get(1).doubleValue(), found.get(2).doubleValue(), found.get(3).doubleValue());
    }

    /** A replay of bodies that fly straight and turn round at the edges; nobody verifies it. */
    private static List<String> lines(int bodies) {
        SplittableRandom random = new SplittableRandom(1);
        double[][] all = random.ints(bodies, 0, WIDTH).mapToObj(x -> new double[] {x, random.nextDouble(HEIGHT),
            random.nextDouble(-300, 300), random.nextDouble(-300, 300)}).toArray(double[][]::new);
        StringBuilder drawn = new StringBuilder();
        for (int k = 0; k < bodies; k++) {
            drawn.append(k == 0 ? "" : ",").append("{\"id\":").append(k)
                .append(",\"kind\":\"body\",\"radius\":90,\"owner\":").append(k % 4).append('}');
        }
        String header = "{\"type\":\"steward-replay\",\"format\":3,\"game\":\"bodies\",\"seed\":\"1\","
            + "\"timeFactor\":null,"
            + "\"players\":[{\"name\":\"a\"},{\"name\":\"b\"},{\"name\":\"c\"},{\"name\":\"d\"}],"
            + "\"scene\":{\"name\":\"bodies\",\"time\":{\"firstAnswerMs\":1000,\"answerMs\":50}},"
            + "\"drawing\":{\"field\":{\"x\":0,\"y\":0,\"width\":" + WIDTH + ",\"height\":" + HEIGHT + "},\"bodies\":["
            + drawn + "]},\"start\":{\"state\":" + state(all) + "}}";
        return Stream.concat(Stream.of(header), Stream.iterate(1, turn -> turn + 1).limit(TURNS).map(turn -> {
            for (double[] body : all) {
                body[2] = body[0] + body[2] < 0 || body[0] + body[2] > WIDTH ? -body[2] : body[2];
                body[3] = body[1] + body[3] < 0 || body[1] + body[3] > HEIGHT ? -body[3] : body[3];
                body[0] += body[2];
                body[1] += body[3];
            }
            return "{\"type\":\"turn\",\"turn\":" + turn + ",\"commands\":[1,1,1,1],\"outcome\":{\"state\":"
                + state(all) + "}}";
        })).toList();
    }

    private static String state(double[][] bodies) {
        StringBuilder state = new StringBuilder("{\"bodies\":[");
        for (int k = 0; k < bodies.length; k++) {
            state.append(k == 0 ? "" : ",").append(String.format(Locale.ROOT,
                "{\"id\":%d,\"x\":%.2f,\"y\":%.2f,\"vx\":%.2f,\"vy\":%.2f}", k, bodies[k][0], bodies[k][1],
                bodies[k][2], bodies[k][3]));
        }
        return state.append("]}").toString();
    }
}
