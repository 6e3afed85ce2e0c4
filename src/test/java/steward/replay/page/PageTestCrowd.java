package steward.replay.page;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/** A made-up match of many bodies of four players, in a game without a look of its own. */
public final class PageTestCrowd {

    static final int TURNS = 60;
    private static final int WIDTH = 16_000;
    private static final int HEIGHT = 9_000;

    /** Fields of a body, in the order of its numbers. */
    private static final String[] NUMBERS = {",\"x\":", ",\"y\":", ",\"vx\":", ",\"vy\":"};

    private PageTestCrowd() {
    }

    /** A replay of bodies that fly straight and turn round at the edges; nobody verifies it. */
    public static List<String> lines(int bodies) {
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
            state.append(k == 0 ? "" : ",").append("{\"id\":").append(k);
            for (int number = 0; number < NUMBERS.length; number++) {
                state.append(NUMBERS[number]).append(Math.round(100 * bodies[k][number]) / 100.0);
            }
            state.append('}');
        }
        return state.append("]}").toString();
    }
}
